// SPDX-License-Identifier: Apache-2.0
// n·(p - c) = 0 between two circles.
#pragma once

#include <algorithm>

#include "truth/truth.hpp"

namespace zraka::truth {

template <>
struct Truth<Disc> {
  Point center, up;
  Real radius, inner;

  explicit Truth(const Disc& s)
      : center(exact(s.center)),
        up(unit(exact(s.normal))),
        radius(s.radius),
        inner(s.inner_radius) {}
  Real residual(const Point& p) const { return dot(up, p - center); }
  Point gradient(const Point&) const { return up; }
  Real beyond(const Point& p) const {
    const Point q = p - center;
    const Real around = length(q - up * dot(q, up));
    return inner > 0 ? std::max(around - radius, inner - around) : around - radius;
  }

  static Disc random(Random& random, const Place& place) {
    const Vec3 center = place.point(in_cube(random)), up = on_unit_sphere(random);
    const double radius = between(0.3, 0.8, random);
    const double inner = random() % 2 == 0 ? 0 : between(kFinest, radius - kFinest, random);
    return {center, up, place.length(radius), place.length(inner)};
  }
};

}  // namespace zraka::truth
