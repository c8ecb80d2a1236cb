// SPDX-License-Identifier: Apache-2.0
// All points within a radius of a circle.
#pragma once

#include "truth/truth.hpp"

namespace zraka::truth {

template <>
struct Truth<Torus> {
  Point center, axis;
  Real radius, tube;

  explicit Truth(const Torus& s)
      : center(exact(s.center)),
        axis(unit(exact(s.normal))),
        radius(s.radius),
        tube(s.tube_radius) {}
  Real residual(const Point& p) const {
    return std::hypot(length(across(p)) - radius, above(p)) - tube;
  }
  Point gradient(const Point& p) const {
    return unit(unit(across(p)) * (length(across(p)) - radius) + axis * above(p));
  }

  static Torus random(Random& random, const Place& place) {
    const Vec3 center = place.point(in_cube(random)), up = on_unit_sphere(random);
    const double radius = between(0.3, 0.6, random);
    const double tube = between(kFinest, radius - kFinest, random);
    return {center, up, place.length(radius), place.length(tube)};
  }

 private:
  Real above(const Point& p) const { return dot(p - center, axis); }
  Point across(const Point& p) const { return p - center - axis * above(p); }
};

}  // namespace zraka::truth
