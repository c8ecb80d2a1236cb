// SPDX-License-Identifier: Apache-2.0
// |q| = 1 in units of the radii.
#pragma once

#include <algorithm>

#include "truth/truth.hpp"

namespace zraka::truth {

template <>
struct Truth<Ellipsoid> {
  Point center, radii;
  Real least;

  explicit Truth(const Ellipsoid& s)
      : center(exact(s.center)),
        radii(exact(s.radii)),
        least(std::min({radii.x, radii.y, radii.z})) {}
  /// |q| changes by at most 1 over the least radius.
  Real residual(const Point& p) const { return (length(in_radii(p)) - 1) * least; }
  Point gradient(const Point& p) const {
    const Point q = unit(in_radii(p));
    return Point{q.x / radii.x, q.y / radii.y, q.z / radii.z} * least;
  }

  /// Radii of 0.3 to 0.6: no curvature has a radius below 0.3²/0.6.
  static Ellipsoid random(Random& random, const Place& place) {
    const auto radius = [&] { return place.length(between(0.3, 0.6, random)); };
    const Vec3 center = place.point(in_cube(random));
    const double x = radius(), y = radius();
    return {center, {x, y, radius()}};
  }

 private:
  Point in_radii(const Point& p) const {
    const Point q = p - center;
    return {q.x / radii.x, q.y / radii.y, q.z / radii.z};
  }
};

}  // namespace zraka::truth
