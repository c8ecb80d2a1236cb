// SPDX-License-Identifier: Apache-2.0
// Which rays cannot hit a plane: known without roots and divisions, and of most rays that do not.
#pragma once

#include "math/double_lanes.hpp"
#include "scene/frozen_bodies.hpp"

namespace zraka::ZRAKA_ISA {

/// Whether rays surely hit the plane of these numbers nowhere before their limits: they go away
/// from it, or end long before it. Along a ray p + t·d the plane is at t = -p.y / d.y in its own
/// space. What view_of() and BodyLanes<Plane>::cross() make of it errs by some 2^-50·|p| / |d.y|,
/// so it says the same where p.y is more than 2^-40·|p|, and is within 2^-9 of that distance.
template <class D, class Row>
ZRAKA_INLINE typename D::M surely_miss_plane(const Row& row, const V3<typename D::F>& origin,
                                             const V3<typename D::F>& direction,
                                             const typename D::F& limit) {
  using F = typename D::F;
  const V3<F> o{origin.x - row(kBodyCenter), origin.y - row(kBodyCenter + 1),
                origin.z - row(kBodyCenter + 2)};
  const V3<F> up{row(kBodyMatrix + 3), row(kBodyMatrix + 4), row(kBodyMatrix + 5)};
  const F height = abs(dot(up, o)), fall = -dot(up, direction);
  F stretch(0.0);  // |p| is at most so many times the largest of |o|
  for (int k = 0; k < 9; ++k) stretch = stretch + abs(row(kBodyMatrix + k));
  const F size = stretch * max(abs(o.x), max(abs(o.y), abs(o.z)));
  const F towards = select(dot(up, o) < F(0.0), -fall, fall);
  return both(height > size * F(0x1p-40),
              either(towards < F(0.0), height > limit * abs(fall) * F(1 + 0x1p-8)));
}

}  // namespace zraka::ZRAKA_ISA
