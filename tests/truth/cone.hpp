// SPDX-License-Identifier: Apache-2.0
// At height y above the base the distance from the axis is r + k·y, up to the apex.
#pragma once

#include <algorithm>

#include "truth/truth.hpp"

namespace zraka {

struct Cylinder;

namespace truth {

template <>
struct Truth<Cone> {
  Point base, axis;
  Real height, radius, growth;

  explicit Truth(const Cone& s)
      : base(exact(s.base)),
        axis(unit(exact(s.apex) - base)),
        height(length(exact(s.apex) - base)),
        radius(s.base_radius),
        growth((Real{s.apex_radius} - radius) / height) {}
  /// The distance from the line that is turned around the axis.
  Real residual(const Point& p) const {
    return (length(across(p)) - (radius + growth * above(p))) / std::sqrt(1 + growth * growth);
  }
  Point gradient(const Point& p) const {
    return (unit(across(p)) - axis * growth) * (1 / std::sqrt(1 + growth * growth));
  }
  Real beyond(const Point& p) const { return std::max(-above(p), above(p) - height); }

  /// Frustums, which may grow or shrink, and whole cones.
  static Cone random(Random& random, const Place& place) {
    const Vec3 base = in_cube(random), up = on_unit_sphere(random);
    const double height = between(0.3, 1, random), radius = between(2 * kFinest, 0.5, random);
    const Vec3 apex{base.x + height * up.x, base.y + height * up.y, base.z + height * up.z};
    const double top = random() % 3 == 0 ? 0 : between(2 * kFinest, 0.5, random);
    const Cone s{place.point(base), place.length(radius), place.point(apex), place.length(top)};
    return random() % 2 == 0 ? s : Cone{s.apex, s.apex_radius, s.base, s.base_radius};
  }

 private:
  Real above(const Point& p) const { return dot(p - base, axis); }
  Point across(const Point& p) const { return p - base - axis * above(p); }
};

template <>
struct Truth<Cylinder> : Truth<Cone> {
  using Truth<Cone>::Truth;

  static Cone random(Random& random, const Place& place) {
    Cone s = Truth<Cone>::random(random, place);
    s.base_radius = s.apex_radius = std::max(s.base_radius, s.apex_radius);
    return s;
  }
};

}  // namespace truth
}  // namespace zraka
