// SPDX-License-Identifier: Apache-2.0
// n·(p - corner) = 0 with n = u × v, within four edges.
#pragma once

#include <algorithm>

#include "truth/truth.hpp"

namespace zraka::truth {

template <>
struct Truth<Parallelogram> {
  Point corner, u, v, up;

  explicit Truth(const Parallelogram& s)
      : corner(exact(s.corner)), u(exact(s.edge_u)), v(exact(s.edge_v)), up(unit(cross(u, v))) {}
  Real residual(const Point& p) const { return dot(up, p - corner); }
  Point gradient(const Point&) const { return up; }
  Real beyond(const Point& p) const {
    const auto past = [&](const Point& from, const Point& edge) {
      return dot(unit(cross(edge, up)), p - from);
    };
    return std::max({past(corner, u), past(corner + u, v), past(corner + u + v, u * -1),
                     past(corner + v, v * -1)});
  }

  static Parallelogram random(Random& random, const Place& place) {
    for (;;) {
      const Vec3 u = in_cube(random), v = in_cube(random), corner = in_cube(random);
      const auto edge = [&](const Vec3& e) {
        return Vec3{place.length(e.x), place.length(e.y), place.length(e.z)};
      };
      const Point a = exact(u), b = exact(v);
      if (length(cross(a, b)) > 2 * kFinest * std::max(length(a), length(b)))
        return {place.point(corner), edge(u), edge(v)};
    }
  }
};

}  // namespace zraka::truth
