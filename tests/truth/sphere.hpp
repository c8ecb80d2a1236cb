// SPDX-License-Identifier: Apache-2.0
// |p - c| = r.
#pragma once

#include "truth/truth.hpp"

namespace zraka {

struct AnchoredSphere;

namespace truth {

template <>
struct Truth<Sphere> {
  Point center;
  Real radius;

  explicit Truth(const Sphere& s) : center(exact(s.center)), radius(s.radius) {}
  Real residual(const Point& p) const { return length(p - center) - radius; }
  Point gradient(const Point& p) const { return unit(p - center); }

  static Sphere random(Random& random, const Place& place) {
    const Vec3 center = place.point(in_cube(random));
    return {center, place.length(between(kFinest, 0.6, random))};
  }
};

/// Every fourth one is a ground under the others.
template <>
struct Truth<AnchoredSphere> : Truth<Sphere> {
  using Truth<Sphere>::Truth;

  static Sphere random(Random& random, const Place& place) {
    if (random() % 4 != 0) return Truth<Sphere>::random(random, place);
    const Vec3 down = on_unit_sphere(random);
    const double radius = std::pow(10.0, between(2, 4, random));
    const double away = radius + between(-0.5, 1, random);
    return {place.point({down.x * away, down.y * away, down.z * away}), place.length(radius)};
  }
};

}  // namespace truth
}  // namespace zraka
