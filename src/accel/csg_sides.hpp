// SPDX-License-Identifier: Apache-2.0
// On which side of members of CSG a point is, where that is beyond doubt: so crossings that decide
// nothing are spared. What is hit is found by crossings all the same.
#pragma once

#include "accel/body_rays.hpp"
#include "shapes/bodies/csg.hpp"
#include "shapes/bodies/slab.hpp"

namespace zraka::ZRAKA_ISA {

/// The largest coordinate.
template <class F>
ZRAKA_INLINE F largest(const V3<F>& v) {
  return max(abs(v.x), max(abs(v.y), abs(v.z)));
}

/// Less than 0 inside of a body, more outside, 0 where that is not told. A point of its own space
/// that is known to within e, no more than 1/4, is on its side where this is beyond 16·e.
template <class F, class Row>
ZRAKA_INLINE F level_of_body(std::uint8_t type, const Row& row, const V3<F>& p) {
  switch (type) {
    case kTypeBox: {
      const F round = row(kBodyNumbers);
      const F level = largest(p) - F(1.0);  // what is outside of round edges may be inside of it
      return select(round > F(0.0), max(level, F(0.0)), level);
    }
    case kTypeEllipsoid:
      return dot(p, p) - F(1.0);
    case kTypeFrustum: {
      const F radius = row(kBodyNumbers) + row(kBodyNumbers + 1) * p.y;
      return max(abs(p.y) - F(1.0), p.x * p.x + p.z * p.z - radius * radius);
    }
    case kTypeTorus: {
      const F tube = row(kBodyNumbers);
      const F out = sqrt(p.x * p.x + p.z * p.z) - F(1.0);
      return select(tube < F(1.0), out * out + p.y * p.y - tube * tube, F(0.0));
    }
    default:
      return F(0.0);
  }
}

/// Where rays are at distances t, and how large the numbers are that this comes of.
template <class F>
struct PlaceOnRay {
  V3<F> at;
  F size;
  ZRAKA_INLINE PlaceOnRay(const V3<F>& origin, const V3<F>& direction, F t)
      : at(origin + direction * t), size(largest(origin) + largest(at)) {}
};

/// On which side of a member lanes of places are, neither where it is not certain.
template <class D>
struct Sides {
  typename D::M inside, outside;
};
template <class D>
ZRAKA_INLINE Sides<D> sides_of_member(const FrozenBodies& bodies, const CsgNumbers& csg, int i,
                                      const PlaceOnRay<typename D::F>& place) {
  using F = typename D::F;
  const std::int32_t member = csg.member(i);
  const SharedNumbers<D> row{bodies.numbers + bodies.start[member]};
  const V3<F> from{place.at.x - row(kBodyCenter), place.at.y - row(kBodyCenter + 1),
                   place.at.z - row(kBodyCenter + 2)};
  const F level = level_of_body(bodies.type[member], row, into_body(row, from));
  // Both the place and the crossings are known to some 2^-48 of this.
  const F reach = place.size * F(csg.stretch(i)) + F(csg.shift(i) + 1.0);
  const F doubt = reach * F(0x1p-36);
  return {level < -doubt, level > doubt};
}

}  // namespace zraka::ZRAKA_ISA
