// SPDX-License-Identifier: Apache-2.0
// The disc and the ring: y = 0 within the unit circle in its own space.
#pragma once

#include <cmath>

#include "math/elementary.hpp"
#include "shapes/bodies/reach.hpp"
#include "shapes/bodies/upright.hpp"

namespace zraka {

template <>
struct ShapeTraits<Disc> {
  static constexpr const char* kName = "disc";
  static constexpr const char* kNouns[2][4] = {{"disc", "disc", "disc", "disc"},
                                               {"disk", "disk", "diska", "disku"}};
  static constexpr bool kClosed = false, kComposed = false;
  /// The inner radius.
  static constexpr int kNumbers = 1;

  static Bounds bounds(const Disc& s) { return bounds_under(s, {}); }

  static Bounds bounds_under(const Disc& s, const Transform& t) {
    const Transform from_own = under(place(s).from_own, t);
    return bounds_around(from_own.origin, circle_reach(from_own));
  }

  static double distance_to(const Disc& s, const Vec3& p) {
    const V3<double> up = axis_frame(s.normal).y, q = vector_of(p) - vector_of(s.center);
    const double y = dot(q, up);
    const V3<double> across = q - up * y;
    const double around = safe_length(across.x, across.y, across.z);
    return safe_length(std::fmax(0, std::fmax(around - s.radius, s.inner_radius - around)), y, 0);
  }

  static const char* check(const Disc& s) {
    if (!finite(s.center)) return "its centre is not finite";
    if (const char* const problem = check_axis(s.normal)) return problem;
    if (!finite(s.radius) || !(s.radius > 0)) return "its radius is not a finite number above 0";
    if (!finite(s.inner_radius) || s.inner_radius < 0 || !(s.inner_radius < s.radius))
      return "its inner_radius is not 0 or more and less than its radius";
    return nullptr;
  }

  static Placement place(const Disc& s) {
    return {upright(s.center, s.normal, s.radius), {s.inner_radius / s.radius}};
  }

  /// u around the axis as on a sphere, v from the inner radius to the outer.
  static BodySurface surface(const double* numbers, const V3<double>& p) {
    constexpr double kPi = 3.14159265358979323846;
    const double around = std::sqrt(p.x * p.x + p.z * p.z), width = 1 - numbers[0];
    const V3<double> out =
        around > 0 ? V3<double>{p.x / around, 0, p.z / around} : V3<double>{0, 0, 1};
    const double circle = 2 * kPi * std::fmax(around, 0x1p-40);
    BodySurface s;
    s.normal = {0, 1, 0};
    s.u = 0.5 + elementary::atan2(out.x, out.z) / (2 * kPi);
    s.v = std::fmin(1, std::fmax(0, (around - numbers[0]) / width));
    s.along_u = {circle * out.z, 0, -circle * out.x};
    s.along_v = out * width;
    return s;
  }
};

#ifdef ZRAKA_ISA
namespace ZRAKA_ISA {

template <class D>
struct BodyLanes<Disc, D> {
  using F = typename D::F;
  static constexpr int kMost = 1;

  /// Along the plane, t is infinite or no number, and so nothing is within.
  template <class Numbers>
  static ZRAKA_INLINE void cross(const Numbers& numbers, const BodyRay<F>& ray, F (&at)[kMost]) {
    const V3<F>&o = ray.origin, &d = ray.direction;
    const F inner = numbers(0), t = -(o.y / d.y);
    const F x = o.x + t * d.x, z = o.z + t * d.z;
    const F around = x * x + z * z;
    at[0] = select(both(around <= F(1.0), around >= inner * inner), t, F(kNever));
  }

  template <class Numbers>
  static ZRAKA_INLINE V3<F> normal(const Numbers&, const V3<F>&) {
    return {F(0.0), F(1.0), F(0.0)};
  }
};

}  // namespace ZRAKA_ISA
#endif

}  // namespace zraka
