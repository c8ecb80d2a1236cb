// SPDX-License-Identifier: Apache-2.0
// The capsule: all points within a radius of a line, which is along y in its own space.
#pragma once

#include <algorithm>
#include <cmath>

#include "math/elementary.hpp"
#include "shapes/bodies/frustum.hpp"

namespace zraka {

template <>
struct ShapeTraits<Capsule> {
  static constexpr const char* kName = "capsule";
  static constexpr const char* kNouns[2][4] = {{"capsule", "capsule", "capsule", "capsule"},
                                               {"kapsula", "kapsulu", "kapsule", "kapsuli"}};
  static constexpr bool kClosed = true, kComposed = false;
  /// Half the line's length, and the radius: together they are 1.
  static constexpr int kNumbers = 2;

  static Bounds bounds(const Capsule& s) { return bounds_under(s, {}); }

  /// Around both end balls.
  static Bounds bounds_under(const Capsule& s, const Transform& t) {
    const Vec3 reach = ball_reach(t);
    Bounds box = bounds_around(point_under(s.base, t), reach, s.radius);
    box.include(bounds_around(point_under(s.top, t), reach, s.radius));
    return box;
  }

  static double distance_to(const Capsule& s, const Vec3& p) {
    const V3<double> axis = vector_of(s.top) - vector_of(s.base);
    const V3<double> from_base = vector_of(p) - vector_of(s.base);
    const double length = safe_length(axis.x, axis.y, axis.z);
    const double along = dot(from_base, axis * (1 / length)) / length;
    const V3<double> away = from_base - axis * std::fmin(1, std::fmax(0, along));
    return std::fabs(safe_length(away.x, away.y, away.z) - s.radius);
  }

  static const char* check(const Capsule& s) {
    if (!finite(s.base) || !finite(s.top)) return "an end is not finite";
    if (!finite(s.radius) || !(s.radius > 0)) return "its radius is not a finite number above 0";
    if (s.base == s.top) return "its ends are one point";
    return nullptr;
  }

  static Placement place(const Capsule& s) {
    const Vec3 half{s.top.x / 2 - s.base.x / 2, s.top.y / 2 - s.base.y / 2,
                    s.top.z / 2 - s.base.z / 2};
    const Vec3 middle{s.top.x / 2 + s.base.x / 2, s.top.y / 2 + s.base.y / 2,
                      s.top.z / 2 + s.base.z / 2};
    const double length = safe_length(half.x, half.y, half.z), unit = length + s.radius;
    return {upright(middle, half, unit), {length / unit, s.radius / unit}};
  }

  /// u around the axis as on a sphere, v from the lowest point to the highest by the length of the
  /// way on the surface.
  static BodySurface surface(const double* numbers, const V3<double>& p) {
    constexpr double kPi = 3.14159265358979323846;
    const double half = numbers[0], radius = numbers[1];
    const double around = std::sqrt(p.x * p.x + p.z * p.z);
    const double beyond = p.y - std::fmin(half, std::fmax(-half, p.y));
    const V3<double> out =
        around > 0 ? V3<double>{p.x / around, 0, p.z / around} : V3<double>{0, 0, 1};
    const double way = 2 * half + kPi * radius;
    const double circle = 2 * kPi * std::fmax(around, 0x1p-40);
    BodySurface s;
    s.normal = {p.x, beyond, p.z};
    s.u = 0.5 + elementary::atan2(out.x, out.z) / (2 * kPi);
    s.v = 0.5 + (p.y - beyond + radius * elementary::atan2(beyond, around)) / way;
    s.along_u = {circle * out.z, 0, -circle * out.x};
    const double slope = way / std::sqrt(around * around + beyond * beyond);
    s.along_v = {-out.x * beyond * slope, around * slope, -out.z * beyond * slope};
    return s;
  }
};

#ifdef ZRAKA_ISA
namespace ZRAKA_ISA {

template <class D>
struct BodyLanes<Capsule, D> {
  using F = typename D::F;
  static constexpr int kMost = 2;

  /// It is convex, and made of a cylinder and two balls that touch it from within: the first to be
  /// entered and the last to be left.
  template <class Numbers>
  static ZRAKA_INLINE void cross(const Numbers& numbers, const BodyRay<F>& ray, F (&at)[kMost]) {
    const F half = numbers(0), radius = numbers(1);
    Span<F> side = within_cone(ray, radius, F(0.0));
    clip(side, ray.origin.y, ray.direction.y, half);
    Span<F> all{F(kNever), F(-kNever)};
    include(all, side);
    include(all, within_ball(ray, half, radius));
    include(all, within_ball(ray, -half, radius));
    const auto hit = all.in <= all.out;
    at[0] = select(hit, all.in, F(kNever));
    at[1] = select(hit, all.out, F(kNever));
  }

  template <class Numbers>
  static ZRAKA_INLINE V3<F> normal(const Numbers& numbers, const V3<F>& p) {
    const F half = numbers(0);
    return {p.x, p.y - min(half, max(-half, p.y)), p.z};
  }

 private:
  static ZRAKA_INLINE void include(Span<F>& all, const Span<F>& part) {
    const auto hit = part.in <= part.out;
    all.in = select(hit, min(part.in, all.in), all.in);
    all.out = select(hit, max(part.out, all.out), all.out);
  }
  /// Of the ball round (0, y, 0): half the chord is √(r² - a²), where the ray passes the middle at
  /// a distance of a.
  static ZRAKA_INLINE Span<F> within_ball(const BodyRay<F>& ray, F y, F radius) {
    const V3<F> o{ray.origin.x, ray.origin.y - y, ray.origin.z};
    const F nearest = -dot(o, ray.direction);
    const V3<F> away = o + ray.direction * nearest;
    const F h = radius * radius - dot(away, away);
    const auto hit = h >= F(0.0);
    const F chord = sqrt(max(h, F(0.0)));
    return {select(hit, nearest - chord, F(kNever)), select(hit, nearest + chord, F(-kNever))};
  }
};

}  // namespace ZRAKA_ISA
#endif

}  // namespace zraka
