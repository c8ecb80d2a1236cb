// SPDX-License-Identifier: Apache-2.0
// n·(p - a) = 0 with n = (b - a) × (c - a), within three edges.
#pragma once

#include <algorithm>

#include "truth/truth.hpp"

namespace zraka::truth {

template <>
struct Truth<Triangle> {
  Point a, b, c, up;

  explicit Truth(const Triangle& s)
      : a(exact(s.a)), b(exact(s.b)), c(exact(s.c)), up(unit(cross(b - a, c - a))) {}
  Real residual(const Point& p) const { return dot(up, p - a); }
  Point gradient(const Point&) const { return up; }
  Real beyond(const Point& p) const {
    const auto past = [&](const Point& from, const Point& to) {
      return dot(unit(cross(to - from, up)), p - from);
    };
    return std::max({past(a, b), past(b, c), past(c, a)});
  }

  static Triangle random(Random& random, const Place& place) {
    for (;;) {
      const Vec3 middle = in_cube(random);
      const auto corner = [&] {
        const Vec3 to = in_cube(random);
        return place.point({middle.x + to.x, middle.y + to.y, middle.z + to.z});
      };
      const Triangle s{corner(), corner(), corner()};
      if (least_height(s) > place.length(2 * kFinest)) return s;
    }
  }

 private:
  static Real least_height(const Triangle& s) {
    const Point a = exact(s.a), b = exact(s.b), c = exact(s.c);
    return length(cross(b - a, c - a)) / std::max({length(b - a), length(c - b), length(a - c)});
  }
};

}  // namespace zraka::truth
