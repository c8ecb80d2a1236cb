// SPDX-License-Identifier: Apache-2.0
// Functions of the lanes over arrays, for each instruction set.
#pragma once

#include <cstddef>
#include <vector>
#include <zraka/render.hpp>

namespace zraka {

struct LanesProbe {
  Isa isa;
  std::size_t width;
  void (*power)(const float* x, const float* n, float* out, std::size_t count);
  /// Rays of origin and direction (3 numbers each) against one sphere each (4 numbers); distances.
  void (*sphere)(const float* origins, const float* directions, const float* spheres, float* t,
                 std::size_t count);
};

/// Those that this machine can run; the oracle last.
std::vector<LanesProbe> lanes_probes();

}  // namespace zraka
