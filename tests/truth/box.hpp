// SPDX-License-Identifier: Apache-2.0
// All points within a radius of an inner box.
#pragma once

#include <algorithm>

#include "truth/truth.hpp"

namespace zraka::truth {

template <>
struct Truth<Box> {
  Point middle, inner;
  Real radius;

  explicit Truth(const Box& s)
      : middle((exact(s.min) + exact(s.max)) * 0.5L),
        inner((exact(s.max) - exact(s.min)) * 0.5L - Point{s.radius, s.radius, s.radius}),
        radius(s.radius) {}
  Real residual(const Point& p) const {
    const Point q = past(p);
    return length(outside(q)) + std::min(std::max({q.x, q.y, q.z}), Real{0}) - radius;
  }
  Point gradient(const Point& p) const {
    const Point q = past(p), away = outside(q);
    const Point way = length(away) > 0           ? unit(away)
                      : q.x >= q.y && q.x >= q.z ? Point{1, 0, 0}
                      : q.y >= q.z               ? Point{0, 1, 0}
                                                 : Point{0, 0, 1};
    const Point from = p - middle;
    return {std::copysign(way.x, from.x), std::copysign(way.y, from.y),
            std::copysign(way.z, from.z)};
  }

  static Box random(Random& random, const Place& place) {
    const Vec3 c = in_cube(random);
    const auto side = [&] { return between(1.5 * kFinest, 0.6, random); };
    const Vec3 half{side(), side(), side()};
    Box s{place.point({c.x - half.x, c.y - half.y, c.z - half.z}),
          place.point({c.x + half.x, c.y + half.y, c.z + half.z})};
    const double most = std::min({half.x, half.y, half.z});
    if (random() % 2 == 0) s.radius = place.length(between(kFinest, most, random));
    return s;
  }

 private:
  /// How far outside of the inner box' sides.
  Point past(const Point& p) const {
    const Point q = p - middle;
    return {std::fabs(q.x) - inner.x, std::fabs(q.y) - inner.y, std::fabs(q.z) - inner.z};
  }
  static Point outside(const Point& q) {
    return {std::max(q.x, Real{0}), std::max(q.y, Real{0}), std::max(q.z, Real{0})};
  }
};

}  // namespace zraka::truth
