// SPDX-License-Identifier: Apache-2.0
// Rays against bodies without bounds, above all planes. Most scenes stand on one, and every ray asks
// it: so a plane by itself does without the ray in its own space that other bodies have, and takes
// one division.
#pragma once

#include "accel/ray_lanes.hpp"
#include "math/double_lanes.hpp"

namespace zraka::ZRAKA_ISA {

/// How fast rays rise above the plane of these numbers, in its own units.
template <class F, class Row>
ZRAKA_INLINE F rise_over_plane(const Row& row, const V3<F>& direction) {
  return dot(V3<F>{row(kBodyMatrix + 3), row(kBodyMatrix + 4), row(kBodyMatrix + 5)}, direction);
}

/// The distances to the plane of these numbers; not positive where rays do not hit it.
template <class F, class Row>
ZRAKA_INLINE F distance_to_plane(const Row& row, const V3<F>& origin, const V3<F>& direction) {
  const V3<F> o{origin.x - row(kBodyCenter), origin.y - row(kBodyCenter + 1),
                origin.z - row(kBodyCenter + 2)};
  const F t = -(rise_over_plane(row, o) / rise_over_plane(row, direction));
  return select(t < F(kFarAway<double>), t, F(-1.0));  // along the plane it is infinite, or none
}

/// One plane for all lanes of an engine.
template <class L>
ZRAKA_INLINE typename L::F intersect_plane(const double* numbers,
                                           const V3<typename L::F>& origin,
                                           const V3<typename L::F>& direction) {
  using F = typename DoublesOf<L>::F;
  constexpr std::size_t kParts = kDoubleParts<L>;
  const auto row = [&](int k) { return F(numbers[k]); };
  F o[3][kParts], d[3][kParts], t[kParts];
  widen(origin.x, o[0]), widen(origin.y, o[1]), widen(origin.z, o[2]);
  widen(direction.x, d[0]), widen(direction.y, d[1]), widen(direction.z, d[2]);
  for (std::size_t i = 0; i < kParts; ++i)
    t[i] = distance_to_plane(row, V3<F>{o[0][i], o[1][i], o[2][i]},
                             V3<F>{d[0][i], d[1][i], d[2][i]});
  return narrow(t);
}

/// As intersect_shape() one body that has no bounds and stands outside of the hierarchy.
template <bool kAny, class L>
ZRAKA_INLINE typename L::F intersect_unbounded(const FrozenShapes<typename L::Real, Body>& bodies,
                                               std::int32_t i, const RayLanes<L>& ray) {
  if (bodies.type[i] == kTypePlane)
    return intersect_plane<L>(bodies.numbers + bodies.start[i], ray.origin, ray.direction);
  return intersect_bodies<L>({&bodies, typename L::I(i)}, ray.origin, ray.direction, ray.t, kAny);
}

}  // namespace zraka::ZRAKA_ISA
