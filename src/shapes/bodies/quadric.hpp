// SPDX-License-Identifier: Apache-2.0
// The quadric, as far as it is in its box: that is the cube from -1 to 1 in its own space.
#pragma once

#include <algorithm>
#include <cmath>

#include "shapes/bodies/quadratic_form.hpp"
#include "shapes/bodies/reach.hpp"
#include "shapes/bodies/slab.hpp"
#include "shapes/bodies/upright.hpp"

namespace zraka {

template <>
struct ShapeTraits<Quadric> {
  static constexpr const char* kName = "quadric";
  static constexpr const char* kNouns[2][4] = {{"quadric", "quadric", "quadric", "quadric"},
                                               {"kvadrika", "kvadriku", "kvadrike", "kvadrici"}};
  static constexpr bool kClosed = true, kComposed = false;
  /// The coefficients; 1 where the box cuts the surface off, 0 where it is an ellipsoid in it.
  static constexpr int kNumbers = 11;

  static Bounds bounds(const Quadric& s) { return {s.min, s.max}; }

  /// From its box; and so far that the polynomial, whose slope there is known and changes by at
  /// most twice its matrix' largest row, cannot have become 0.
  static double distance_to(const Quadric& s, const Vec3& p) {
    const QuadraticForm form = in_box(s);
    const V3<double> q = vector_of(p) - middle_of(s), g = form.gradient(q);
    const double value = std::fabs(form.value(q)), slope = safe_length(g.x, g.y, g.z);
    const auto row = [&](std::size_t square, std::size_t one, std::size_t other) {
      return std::fabs(form.c[square]) + std::fabs(form.c[one]) / 2 + std::fabs(form.c[other]) / 2;
    };
    const double bend = std::max({row(0, 3, 4), row(1, 3, 5), row(2, 4, 5)});
    const double divisor = slope + std::sqrt(slope * slope + 4 * bend * value);
    const double free = value > 0 ? 2 * value / divisor : 0;
    return std::fmax(bounds(s).distance_to(p), free);
  }

  static const char* check(const Quadric& s) {
    for (const double k : s.coefficients)
      if (!finite(k)) return "a coefficient is not finite";
    if (std::all_of(s.coefficients.begin(), s.coefficients.end() - 1,
                    [](double k) { return k == 0; }))
      return "its coefficients but the last are 0";
    if (!finite(s.min) || !finite(s.max)) return "a corner of its box is not finite";
    if (!(s.max.x > s.min.x && s.max.y > s.min.y && s.max.z > s.min.z))
      return "its max is not above its min along every axis";
    return nullptr;
  }
  static const char* check_member(const Quadric& s) {
    return is_ellipsoid_in_cube(own(s)) ? nullptr
                                        : "its box cuts its surface off, so it has no inside";
  }

  static Placement place(const Quadric& s) {
    const V3<double> half = half_of(s);
    const QuadraticForm form = own(s);
    Placement placement{{{half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z}, vec3_of(middle_of(s))}};
    std::copy_n(form.c.begin(), 10, placement.numbers);
    placement.numbers[10] = is_ellipsoid_in_cube(form) ? 0 : 1;
    return placement;
  }

  /// Without u and v; tangents are any.
  static BodySurface surface(const double* numbers, const V3<double>& p) {
    QuadraticForm form;
    std::copy_n(numbers, 10, form.c.begin());
    BodySurface s{form.gradient(p)};
    // There is none at the apex of a cone.
    if (!(dot(s.normal, s.normal) > 0)) s.normal = {0, 1, 0};
    put_any_tangents(s);
    return s;
  }

 private:
  static V3<double> middle_of(const Quadric& s) {
    return vector_of(s.min) * 0.5 + vector_of(s.max) * 0.5;
  }
  static V3<double> half_of(const Quadric& s) {
    return vector_of(s.max) * 0.5 - vector_of(s.min) * 0.5;
  }
  /// Relative to the middle of the box, the largest coefficient near 1.
  static QuadraticForm in_box(const Quadric& s) {
    QuadraticForm form{s.coefficients};
    int exponent = 0;
    std::frexp(form.largest(), &exponent);
    for (double& k : form.c) k = std::ldexp(k, -exponent);
    return form.relative_to(middle_of(s));
  }
  static QuadraticForm own(const Quadric& s) {
    const QuadraticForm form = in_box(s).in_units(half_of(s));
    const double largest = form.largest();
    return largest > 0 ? form.times(1 / largest) : form;
  }
  /// It may touch the cube's faces, and what its coefficients are rounded by.
  static bool is_ellipsoid_in_cube(const QuadraticForm& form) {
    return form.has_its_least_in_cube() && form.least_on_cube() >= -0x1p-44;
  }
};

#ifdef ZRAKA_ISA
namespace ZRAKA_ISA {

template <class D>
struct BodyLanes<Quadric, D> {
  using F = typename D::F;
  static constexpr int kMost = 2;

  /// Along a ray it is a·t² + 2b·t + c.
  template <class Numbers>
  static ZRAKA_INLINE void cross(const Numbers& numbers, const BodyRay<F>& ray, F (&at)[kMost]) {
    const V3<F>&o = ray.origin, &d = ray.direction;
    const F xx = numbers(0), yy = numbers(1), zz = numbers(2), xy = numbers(3), xz = numbers(4),
            yz = numbers(5);
    // Half the gradient of its squares along the ray, and at the origin.
    const V3<F> turned{xx * d.x + F(0.5) * (xy * d.y + xz * d.z),
                       yy * d.y + F(0.5) * (xy * d.x + yz * d.z),
                       zz * d.z + F(0.5) * (xz * d.x + yz * d.y)};
    const V3<F> linear{numbers(6), numbers(7), numbers(8)};
    const F a = dot(turned, d);
    const F b = dot(turned, o) + F(0.5) * dot(linear, d);
    const F c = (xx * o.x + xy * o.y + xz * o.z + linear.x) * o.x +
                (yy * o.y + yz * o.z + linear.y) * o.y + (zz * o.z + linear.z) * o.z + numbers(9);

    const F root_square = b * b - a * c;
    // The one without cancellation, and by it the other.
    const F q = -(b + copy_sign(sqrt(max(root_square, F(0.0))), b));
    const F one = q / a, other = select(q == F(0.0), one, c / q);
    const F first = min(one, other), second = max(one, other);
    Span<F> box;
    clip(box, o.x, d.x, F(1.0));
    clip(box, o.y, d.y, F(1.0));
    clip(box, o.z, d.z, F(1.0));
    const auto cut = numbers(10) > F(0.0), real = root_square >= F(0.0);
    const auto crossed = [&](F t) {
      return both(real, select(cut, both(t >= box.in, t <= box.out), t == t));
    };
    const auto has_first = crossed(first), has_second = crossed(second);
    const F later = select(has_second, second, F(kNever));
    at[0] = select(has_first, first, later);
    at[1] = select(has_first, later, F(kNever));
  }

  template <class Numbers>
  static ZRAKA_INLINE V3<F> normal(const Numbers& c, const V3<F>& p) {
    const V3<F> gradient{F(2.0) * c(0) * p.x + c(3) * p.y + c(4) * p.z + c(6),
                         c(3) * p.x + F(2.0) * c(1) * p.y + c(5) * p.z + c(7),
                         c(4) * p.x + c(5) * p.y + F(2.0) * c(2) * p.z + c(8)};
    const auto some = dot(gradient, gradient) > F(0.0);
    return {select(some, gradient.x, F(0.0)), select(some, gradient.y, F(1.0)),
            select(some, gradient.z, F(0.0))};
  }
};

}  // namespace ZRAKA_ISA
#endif

}  // namespace zraka
