// SPDX-License-Identifier: Apache-2.0
// n·(p - point) = 0.
#pragma once

#include "truth/truth.hpp"

namespace zraka::truth {

template <>
struct Truth<Plane> {
  Point point, up;

  explicit Truth(const Plane& s) : point(exact(s.point)), up(unit(exact(s.normal))) {}
  Real residual(const Point& p) const { return dot(up, p - point); }
  Point gradient(const Point&) const { return up; }

  static Plane random(Random& random, const Place& place) {
    const Vec3 point = place.point(in_cube(random)), up = on_unit_sphere(random);
    const double length = place.length(between(0.5, 2, random));
    return {point, {up.x * length, up.y * length, up.z * length}};
  }
};

}  // namespace zraka::truth
