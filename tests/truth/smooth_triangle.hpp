// SPDX-License-Identifier: Apache-2.0
// A triangle whose normal is u·na + v·nb + w·nc, where u, v, w are the shares of its area opposite
// the corners (Phong 1975).
#pragma once

#include "truth/triangle.hpp"

namespace zraka::truth {

template <>
struct Truth<SmoothTriangle> : Truth<Triangle> {
  Point normal_a, normal_b, normal_c;
  Real side;  ///< of the flat normal that is outside: 1 or -1

  explicit Truth(const SmoothTriangle& s)
      : Truth<Triangle>({s.a, s.b, s.c}),
        normal_a(unit(exact(s.normal_a))),
        normal_b(unit(exact(s.normal_b))),
        normal_c(unit(exact(s.normal_c))),
        side(dot(normal_a, up) < 0 ? -1 : 1) {}
  Real residual(const Point& p) const { return side * Truth<Triangle>::residual(p); }
  Point gradient(const Point& p) const { return Truth<Triangle>::gradient(p) * side; }
  Point normal(const Point& p) const {
    const auto area = [&](const Point& from, const Point& to) {
      return std::fabs(dot(up, cross(from - p, to - p)));
    };
    return normal_a * area(b, c) + normal_b * area(c, a) + normal_c * area(a, b);
  }

  /// Normals of other lengths than 1, turned away from the flat one, on either side of it.
  static SmoothTriangle random(Random& random, const Place& place) {
    const Triangle s = Truth<Triangle>::random(random, place);
    const Point flat = Truth<Triangle>(s).up;
    const double side = random() % 2 == 0 ? 1 : -1;
    const auto turned = [&] {
      const Vec3 by = in_cube(random);
      const auto part = [&](Real of_flat, double of_turn) {
        return side * (static_cast<double>(of_flat) + 0.4 * of_turn) * 3;
      };
      return Vec3{part(flat.x, by.x), part(flat.y, by.y), part(flat.z, by.z)};
    };
    return {s.a, s.b, s.c, turned(), turned(), turned()};
  }
};

}  // namespace zraka::truth
