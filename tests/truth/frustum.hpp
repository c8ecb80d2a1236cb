// SPDX-License-Identifier: Apache-2.0
// At height y above the base the distance from the axis is r + k·y at most, from base to top; or
// just that, without caps.
#pragma once

#include <algorithm>

#include "truth/truth.hpp"

namespace zraka::truth {

template <>
struct Truth<Frustum> {
  Point base, axis;
  Real height, radius, growth;
  bool caps;

  explicit Truth(const Frustum& s)
      : base(exact(s.base)),
        axis(unit(exact(s.top) - base)),
        height(length(exact(s.top) - base)),
        radius(s.base_radius),
        growth((Real{s.top_radius} - radius) / height),
        caps(s.caps) {}
  Real residual(const Point& p) const {
    return caps ? std::max({from_side(p), -above(p), above(p) - height}) : from_side(p);
  }
  Point gradient(const Point& p) const {
    if (!caps || residual(p) == from_side(p))
      return (unit(across(p)) - axis * growth) * (1 / std::sqrt(1 + growth * growth));
    return axis * (above(p) < height / 2 ? -1 : 1);
  }
  Real beyond(const Point& p) const {
    return caps ? -1e30L : std::max(-above(p), above(p) - height);
  }

  /// Those that grow, shrink or do neither, and whole cones.
  static Frustum random(Random& random, const Place& place) {
    const Vec3 base = in_cube(random), up = on_unit_sphere(random);
    const double height = between(0.3, 1, random), radius = between(2 * kFinest, 0.5, random);
    const Vec3 top{base.x + height * up.x, base.y + height * up.y, base.z + height * up.z};
    double other = between(2 * kFinest, 0.5, random);
    if (random() % 4 == 0) other = 0;
    if (random() % 4 == 0) other = radius;
    Frustum s{place.point(base), place.length(radius), place.point(top), place.length(other)};
    if (random() % 2 == 0) s = {s.top, s.top_radius, s.base, s.base_radius};
    s.caps = random() % 3 != 0;
    return s;
  }

 private:
  Real above(const Point& p) const { return dot(p - base, axis); }
  Point across(const Point& p) const { return p - base - axis * above(p); }
  /// The distance from the line that is turned round the axis.
  Real from_side(const Point& p) const {
    return (length(across(p)) - (radius + growth * above(p))) / std::sqrt(1 + growth * growth);
  }
};

}  // namespace zraka::truth
