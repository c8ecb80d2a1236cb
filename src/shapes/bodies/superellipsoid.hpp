// SPDX-License-Identifier: Apache-2.0
// The superellipsoid: radii of 1 in its own space.
//
// With p = 2/e and q = 2/n it is where the norm of (x, y, z) is 1 that is the q-norm of z and of
// the p-norm of x and y. That grows as fast as its vector does, however large p and q are.
#pragma once

#include <cmath>

#include "math/elementary.hpp"
#include "shapes/bodies/reach.hpp"
#include "shapes/bodies/superellipsoid_rays.hpp"
#include "shapes/bodies/upright.hpp"

namespace zraka {

template <>
struct ShapeTraits<Superellipsoid> {
  static constexpr const char* kName = "superellipsoid";
  static constexpr const char* kNouns[2][4] = {
      {"superellipsoid", "superellipsoid", "superellipsoid", "superellipsoid"},
      {"superelipsoid", "superelipsoid", "superelipsoida", "superelipsoidu"}};
  static constexpr bool kClosed = true, kComposed = false;
  /// p and q.
  static constexpr int kNumbers = 2;
  static constexpr double kLeastExponent = 0.05, kMostExponent = 4;

  static Bounds bounds(const Superellipsoid& s) { return bounds_around(s.center, s.radii); }

  /// Of the surface there is nothing in the largest box round the point whose nearest corner to the
  /// middle is outside, or whose farthest is inside.
  static double distance_to(const Superellipsoid& s, const Vec3& p) {
    const Norm norm{2 / s.e, 2 / s.n};
    const V3<double> q{std::fabs(p.x - s.center.x), std::fabs(p.y - s.center.y),
                       std::fabs(p.z - s.center.z)};
    const auto at = [&](double x, double y, double z) {
      return norm.value(
          {std::fmax(x, 0) / s.radii.x, std::fmax(y, 0) / s.radii.y, std::fmax(z, 0) / s.radii.z});
    };
    const double side = at(q.x, q.y, q.z) > 1 ? -1 : 1;
    double free = 0, reached = std::fmax(q.x, std::fmax(q.y, q.z)) +
                               std::fmin(s.radii.x, std::fmin(s.radii.y, s.radii.z));
    for (int k = 0; k < 48; ++k) {
      const double half = free + (reached - free) / 2, way = side * half;
      const bool is_free = (at(q.x + way, q.y + way, q.z + way) - 1) * side < 0;
      (is_free ? free : reached) = half;
    }
    return free;
  }

  static const char* check(const Superellipsoid& s) {
    if (!finite(s.center)) return "its centre is not finite";
    if (!finite(s.radii) || !(s.radii.x > 0 && s.radii.y > 0 && s.radii.z > 0))
      return "its radii are not finite numbers above 0";
    const auto sound = [](double k) { return k >= kLeastExponent && k <= kMostExponent; };
    if (!sound(s.e) || !sound(s.n)) return "its exponents are not from 0.05 to 4";
    return nullptr;
  }

  static Placement place(const Superellipsoid& s) {
    return {{{s.radii.x, 0, 0}, {0, s.radii.y, 0}, {0, 0, s.radii.z}, s.center},
            {2 / s.e, 2 / s.n}};
  }

  /// Without u and v; tangents are any.
  static BodySurface surface(const double* numbers, const V3<double>& p) {
    BodySurface s{Norm{numbers[0], numbers[1]}.gradient(p)};
    put_any_tangents(s);
    return s;
  }

 private:
  /// Of two numbers of 0 or more, not both 0: their p-norm and its slopes.
  struct TwoNorm {
    double value, along_a, along_b;
    TwoNorm(double a, double b, double p) {
      const bool a_is_less = a < b;
      const double large = a_is_less ? b : a, ratio = (a_is_less ? a : b) / large;
      const double factor = elementary::pow(1 + elementary::pow(ratio, p), 1 / p);
      value = large * factor;
      // The slope at 0 may be infinite.
      const double some = std::fmax(ratio, 0x1p-40), power = elementary::pow(some, p);
      const double along_large = factor / (1 + power), along_small = along_large * power / some;
      along_a = a_is_less ? along_small : along_large;
      along_b = a_is_less ? along_large : along_small;
    }
  };
  struct Norm {
    double p, q;

    /// Of a point with no negative coordinate.
    double value(const V3<double>& v) const {
      const double tiny = 0x1p-1000;
      const TwoNorm level(std::fmax(v.x, tiny), v.y, p);
      return TwoNorm(level.value, v.z, q).value;
    }
    V3<double> gradient(const V3<double>& v) const {
      const double tiny = 0x1p-1000;
      const TwoNorm level(std::fmax(std::fabs(v.x), tiny), std::fabs(v.y), p);
      const TwoNorm whole(level.value, std::fabs(v.z), q);
      return {std::copysign(whole.along_a * level.along_a, v.x),
              std::copysign(whole.along_a * level.along_b, v.y), std::copysign(whole.along_b, v.z)};
    }
  };
};

}  // namespace zraka
