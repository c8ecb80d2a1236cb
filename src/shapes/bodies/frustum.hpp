// SPDX-License-Identifier: Apache-2.0
// The cone, frustum and cylinder under any transform: from y = -1 to y = 1 in its own space, the
// larger radius 1.
#pragma once

#include <algorithm>
#include <cmath>

#include "math/elementary.hpp"
#include "shapes/bodies/reach.hpp"
#include "shapes/bodies/slab.hpp"
#include "shapes/bodies/upright.hpp"

namespace zraka {

template <>
struct ShapeTraits<Frustum> {
  static constexpr const char* kName = "frustum";
  static constexpr const char* kNouns[2][4] = {
      {"frustum", "frustum", "frustum", "frustum"},
      {"krnji stožac", "krnji stožac", "krnjeg stošca", "krnjem stošcu"}};
  static constexpr bool kClosed = true, kComposed = false;
  /// The radius at y = 0 and its growth along y; whether there are caps, 1 or 0.
  static constexpr int kNumbers = 3;

  static Bounds bounds(const Frustum& s) { return bounds_under(s, {}); }

  /// Around both end discs.
  static Bounds bounds_under(const Frustum& s, const Transform& t) {
    const Placement placement = place(s);
    const Transform from_own = under(placement.from_own, t);
    const Vec3 reach = circle_reach(from_own);
    const double middle = placement.numbers[0], growth = placement.numbers[1];
    Bounds box = bounds_around(point_under({0, -1, 0}, from_own), reach, middle - growth);
    box.include(bounds_around(point_under({0, 1, 0}, from_own), reach, middle + growth));
    return box;
  }

  /// From the lines that are turned round the axis.
  static double distance_to(const Frustum& s, const Vec3& p) {
    const V3<double> axis = vector_of(s.top) - vector_of(s.base);
    const double height = safe_length(axis.x, axis.y, axis.z);
    const V3<double> unit = axis * (1 / height), from_base = vector_of(p) - vector_of(s.base);
    const double y = dot(from_base, unit);
    const V3<double> across = from_base - unit * y;
    const double x = safe_length(across.x, across.y, across.z);
    const double side = from_line(x, y, s.base_radius, 0, s.top_radius, height);
    if (!s.caps) return side;
    return std::min({side, from_line(x, y, 0, 0, s.base_radius, 0),
                     from_line(x, y, 0, height, s.top_radius, height)});
  }

  static const char* check(const Frustum& s) {
    if (!finite(s.base) || !finite(s.top)) return "an end is not finite";
    if (!finite(s.base_radius) || !finite(s.top_radius) || s.base_radius < 0 || s.top_radius < 0 ||
        !(s.base_radius + s.top_radius > 0))
      return "its radii are not finite numbers of 0 or more, one of them more";
    if (s.base == s.top) return "its ends are one point";
    return nullptr;
  }
  static const char* check_member(const Frustum& s) {
    return s.caps ? nullptr : "without caps it has no inside";
  }

  static Placement place(const Frustum& s) {
    const Vec3 half{s.top.x / 2 - s.base.x / 2, s.top.y / 2 - s.base.y / 2,
                    s.top.z / 2 - s.base.z / 2};
    const Vec3 middle{s.top.x / 2 + s.base.x / 2, s.top.y / 2 + s.base.y / 2,
                      s.top.z / 2 + s.base.z / 2};
    const double unit = std::max(s.base_radius, s.top_radius);
    const double base = s.base_radius / unit, top = s.top_radius / unit;
    Transform from_own = upright(middle, half, unit);
    from_own.along_y = half;
    return {from_own, {(base + top) / 2, (top - base) / 2, s.caps ? 1.0 : 0.0}};
  }

  /// u around the axis as on a sphere, v from base to top.
  static BodySurface surface(const double* numbers, const V3<double>& p) {
    constexpr double kPi = 3.14159265358979323846;
    const double growth = numbers[1], around = std::sqrt(p.x * p.x + p.z * p.z);
    const double radius = numbers[0] + growth * p.y;
    const double up = p.y > 0 ? 1 : -1, end = numbers[0] + growth * up;
    const V3<double> out =
        around > 0 ? V3<double>{p.x / around, 0, p.z / around} : V3<double>{0, 0, 1};
    BodySurface s;
    s.u = 0.5 + elementary::atan2(out.x, out.z) / (2 * kPi);
    s.v = std::fmin(1, std::fmax(0, 0.5 + p.y / 2));
    const double circle = 2 * kPi * std::fmax(around, 0x1p-40);
    s.along_u = {circle * out.z, 0, -circle * out.x};
    const double beyond_side = (around - radius) / std::sqrt(1 + growth * growth);
    if (numbers[2] > 0 && end > 0 && std::fabs(p.y) - 1 > beyond_side) {
      s.normal = {0, up, 0};
      // v stays as it is: the way in from below, and out from above, on which it would grow.
      s.along_v = out * -up;
      return s;
    }
    s.normal = {out.x, -growth, out.z};
    s.along_v = {2 * growth * out.x, 2, 2 * growth * out.z};
    return s;
  }

 private:
  /// Of a point of the plane from the line between two.
  static double from_line(double x, double y, double x0, double y0, double x1, double y1) {
    const double dx = x1 - x0, dy = y1 - y0, length = safe_length(dx, dy, 0);
    if (!(length > 0)) return safe_length(x - x0, y - y0, 0);
    const double along = ((x - x0) * (dx / length) + (y - y0) * (dy / length)) / length;
    const double share = std::fmin(1, std::fmax(0, along));
    return safe_length(x - (x0 + share * dx), y - (y0 + share * dy), 0);
  }
};

#ifdef ZRAKA_ISA
namespace ZRAKA_ISA {

/// What of a ray is within the cone whose radius is middle + growth·y, where that is not negative.
///
/// It is within where a·t² + 2b·t + c ≤ 0. Where a is 0 or less, the ray also passes through the
/// cone's image beyond the apex.
template <class F>
ZRAKA_INLINE Span<F> within_cone(const BodyRay<F>& ray, F middle, F growth) {
  const V3<F>&o = ray.origin, &d = ray.direction;
  const F radius = middle + growth * o.y, widening = growth * d.y;
  const F a = d.x * d.x + d.z * d.z - widening * widening;
  const F b = o.x * d.x + o.z * d.z - radius * widening;
  const F c = o.x * o.x + o.z * o.z - radius * radius;
  // b² - a·c, without what it loses to cancellation (Lagrange's identity).
  const F x = d.x * radius - o.x * widening, z = d.z * radius - o.z * widening;
  const F aside = o.x * d.z - o.z * d.x;
  const F root_square = x * x + z * z - aside * aside;
  const F root = sqrt(max(root_square, F(0.0)));
  // The one without cancellation, and by it the other.
  const F q = -(b + copy_sign(root, b));
  const F one = q / a, other = select(q == F(0.0), one, c / q);
  const F never(kNever);
  Span<F> span{min(one, other), max(one, other)};

  const auto narrow = a > F(0.0);
  const auto misses =
      either(both(narrow, root_square < F(0.0)), both(both(a == F(0.0), b == F(0.0)), c > F(0.0)));
  // Along the side: until, or from, where the ray crosses it once; along the axis, always.
  const auto flat = a == F(0.0);
  const F once = c / (b * F(-2.0));
  const auto leaving = b > F(0.0), entering = b < F(0.0);
  const auto opening = widening > F(0.0);
  const F in = select(flat, select(entering, once, -never), select(opening, span.out, -never));
  const F out = select(flat, select(leaving, once, never), select(opening, never, span.in));
  span.in = select(misses, never, select(narrow, span.in, in));
  span.out = select(misses, -never, select(narrow, span.out, out));
  return span;
}

template <class D>
struct BodyLanes<Frustum, D> {
  using F = typename D::F;
  static constexpr int kMost = 2;

  template <class Numbers>
  static ZRAKA_INLINE void cross(const Numbers& numbers, const BodyRay<F>& ray, F (&at)[kMost]) {
    const F never(kNever);
    const Span<F> cone = within_cone(ray, numbers(0), numbers(1));
    Span<F> slab;
    clip(slab, ray.origin.y, ray.direction.y, F(1.0));
    const F in = max(cone.in, slab.in), out = min(cone.out, slab.out);
    const auto hit = in <= out;
    at[0] = select(hit, in, never);
    at[1] = select(hit, out, never);
    const auto capped = numbers(2) > F(0.0);
    if (all(capped)) return;

    const auto first = both(hit, in == cone.in), second = both(hit, out == cone.out);
    const F side_out = select(second, out, never), side_in = select(first, in, side_out);
    at[0] = select(capped, at[0], side_in);
    at[1] = select(capped, at[1], select(first, side_out, never));
  }

  template <class Numbers>
  static ZRAKA_INLINE V3<F> normal(const Numbers& numbers, const V3<F>& p) {
    const F middle = numbers(0), growth = numbers(1), none(0.0);
    const F around = sqrt(p.x * p.x + p.z * p.z), radius = middle + growth * p.y;
    const F up = select(p.y > none, F(1.0), F(-1.0)), end = middle + growth * up;
    const F beyond_side = (around - radius) / sqrt(F(1.0) + growth * growth);
    const auto on_cap = both(both(numbers(2) > none, end > none), abs(p.y) - F(1.0) > beyond_side);
    const auto off_axis = around > none;
    return {select(on_cap, none, select(off_axis, p.x / around, none)),
            select(on_cap, up, -growth),
            select(on_cap, none, select(off_axis, p.z / around, F(1.0)))};
  }
};

}  // namespace ZRAKA_ISA
#endif

}  // namespace zraka
