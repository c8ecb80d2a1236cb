// SPDX-License-Identifier: Apache-2.0
// All points within a radius of a line.
#pragma once

#include <algorithm>

#include "truth/truth.hpp"

namespace zraka::truth {

template <>
struct Truth<Capsule> {
  Point base, axis;
  Real height, radius;

  explicit Truth(const Capsule& s)
      : base(exact(s.base)),
        axis(unit(exact(s.top) - base)),
        height(length(exact(s.top) - base)),
        radius(s.radius) {}
  Real residual(const Point& p) const { return length(from_line(p)) - radius; }
  Point gradient(const Point& p) const { return unit(from_line(p)); }

  static Capsule random(Random& random, const Place& place) {
    const Vec3 base = in_cube(random), up = on_unit_sphere(random);
    const double height = between(0.1, 1, random);
    const Vec3 top{base.x + height * up.x, base.y + height * up.y, base.z + height * up.z};
    return {place.point(base), place.point(top), place.length(between(kFinest, 0.5, random))};
  }

 private:
  Point from_line(const Point& p) const {
    const Point q = p - base;
    return q - axis * std::clamp(dot(q, axis), Real{0}, height);
  }
};

}  // namespace zraka::truth
