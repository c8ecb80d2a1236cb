// SPDX-License-Identifier: Apache-2.0
// Crossings of rays with bodies, by each instruction set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>
#include <zraka/render.hpp>

#include "scene/frozen_bodies.hpp"

namespace zraka {

inline constexpr int kProbedCrossings = 8;

struct BodyProbeRay {
  double origin[3], direction[3];
};
struct BodyCrossings {
  double at[kProbedCrossings];  ///< infinite where there are no more
  /// What the engine finds of the surface that a ray hits first: the distance, infinite where there
  /// is none, the unit normal, and whether the ray comes from inside.
  double first, normal[3];
  bool inside;
  /// Whether a ray that looks a bit farther than its first crossing finds that, or any before its
  /// limit where any will do; and one that looks less far none.
  bool keeps_limits;
};

/// What the engine finds of a ray that asks for its nearest hit, and of one that asks for any.
struct BodyHit {
  double t, any;  ///< not positive where there is none
  double point[3], normal[3];
  bool inside;
};

struct BodiesProbe {
  Isa isa;
  /// Of ray i with the body of this type whose numbers begin at numbers + start[i].
  void (*cross)(BodyType type, const double* numbers, const std::int32_t* start,
                const BodyProbeRay* rays, BodyCrossings* found, std::size_t count);
  /// The same, through the engine's own functions and in its lanes, with rays that end at limit[i].
  void (*hit)(BodyType type, const double* numbers, const std::int32_t* start,
              const BodyProbeRay* rays, const double* limit, BodyHit* found, std::size_t count);
  /// log2 of numbers above 0, and powers of 2.
  void (*log2)(const double* x, double* out, std::size_t count);
  void (*exp2)(const double* x, double* out, std::size_t count);
};

/// Those that this machine can run; the oracle last.
std::vector<BodiesProbe> bodies_probes();

}  // namespace zraka
