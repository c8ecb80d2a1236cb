// SPDX-License-Identifier: Apache-2.0
// The engine's steps one by one, compiled once per instruction set, for micro.cpp to time.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/engine.hpp"

namespace zraka::micro {

/// Rays in the engine's frame, unit directions, in arrays with kArrayPadding values past the end.
struct Rays {
  const float *ox, *oy, *oz, *dx, *dy, *dz;
  std::size_t count;
};

struct Probe {
  const char* isa = "";
  /// Distances of rays to one shape given by its frozen numbers, by kind of shape; 0 or less: none.
  void (*intersect[kKinds])(const float* shape, const Rays& rays, float* t) = {};
  /// How many rays hit something.
  std::size_t (*nearest)(const FrozenScene<float>& scene, const Rays& rays) = nullptr;
  /// How many hit something before the distance `far`.
  std::size_t (*blocked)(const FrozenScene<float>& scene, const Rays& rays, float far) = nullptr;
  void (*power)(const float* x, const float* n, float* out, std::size_t count) = nullptr;

  /// A tile's camera rays and what they hit. The steps after that may be repeated in this order.
  void (*hits)(const FrozenScene<float>& scene, const TileRect& tile,
               Workspace<float>& workspace) = nullptr;
  void (*surfaces)(const FrozenScene<float>& scene, Workspace<float>& workspace) = nullptr;
  void (*light)(const FrozenScene<float>& scene, const TraceSettings& settings,
                Workspace<float>& workspace) = nullptr;
  void (*spawn)(const FrozenScene<float>& scene, const TraceSettings& settings,
                Workspace<float>& workspace) = nullptr;
  void (*fold)(const TraceSettings& settings, Workspace<float>& workspace) = nullptr;
};

/// Of all instruction sets that this machine can run.
std::vector<Probe> probes();

}  // namespace zraka::micro
