// SPDX-License-Identifier: Apache-2.0
// Functions of the lanes over arrays, for each instruction set.
#pragma once

#include <cstddef>
#include <vector>
#include <zraka/render.hpp>

#include "scene/frozen.hpp"

namespace zraka {

struct ProbeRay {
  double origin[3], direction[3];  // in the engine's frame; unit length
  double limit;                    // hits beyond do not count
};
struct ProbeHit {
  double t;         // the limit where nothing is hit
  std::int32_t id;  // place in the scene as it was read, over all kinds; -1: nothing
  bool blocked;     // what a shadow ray says
};
/// What a ray meets, in the engine's frame.
struct ProbeSurface {
  double t;         // the limit where nothing is met; then nothing below is set but the id
  std::int32_t id;  // as above
  double point[3], normal[3];
  double offset;
  bool inside;
};

struct LanesProbe {
  Isa isa;
  std::size_t width;
  void (*power)(const float* x, const float* n, float* out, std::size_t count);
  /// elementary_power(), -1 in place of what it does not know.
  void (*double_power)(const double* x, const double* y, double* out, std::size_t count);
  /// Rays of origin and direction (3 numbers each) against one sphere each (4 numbers); distances.
  void (*sphere)(const float* origins, const float* directions, const float* spheres, float* t,
                 std::size_t count);
  /// How many rays past, onto, out of and into spheres are said to be blocked, or not, other than by
  /// where they hit.
  std::size_t (*wrong_blocks)(unsigned seed);
  /// The four numbers from each place of an array on; places are multiples of four.
  void (*gather_four)(const float* from, const std::int32_t* at, float (*out)[4],
                      std::size_t count);
  /// Adds pairs to a queue in random order and takes them again: how many come out that should not,
  /// or not in their turn, or not at all.
  std::size_t (*wrong_pairs)(unsigned seed);
  /// Whether a stack has room for the deepest tree there may be, of full nodes, when each entry is
  /// taken ahead of its turn as shadow rays do.
  bool (*stack_fits)();
  /// Hits of rays in a frozen scene, through its hierarchy if it has one: of floats, but of doubles
  /// for the oracle.
  void (*trace)(const FrozenScene<float>* floats, const FrozenScene<double>* doubles,
                const ProbeRay* rays, ProbeHit* hits, std::size_t count);
  /// Which of up to 64 rays, all from where the first one begins and as far as it looks, are
  /// blocked, in a scene of a hierarchy of spheres.
  std::uint64_t (*from_point)(const FrozenScene<float>* floats, const FrozenScene<double>* doubles,
                              const ProbeRay* rays, std::size_t count);
  /// The same rays' surfaces.
  void (*surfaces)(const FrozenScene<float>* floats, const FrozenScene<double>* doubles,
                   const ProbeRay* rays, ProbeSurface* surfaces, std::size_t count);
};

/// Those that this machine can run; the oracle last.
std::vector<LanesProbe> lanes_probes();

}  // namespace zraka
