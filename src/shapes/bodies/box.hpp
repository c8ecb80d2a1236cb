// SPDX-License-Identifier: Apache-2.0
// The box, whose edges may be round: then it is all points within a radius of an inner box.
#pragma once

#include <algorithm>
#include <cmath>

#include "shapes/bodies/reach.hpp"
#include "shapes/bodies/slab.hpp"

namespace zraka {

template <>
struct ShapeTraits<Box> {
  static constexpr const char* kName = "box";
  static constexpr const char* kNouns[2][4] = {{"box", "box", "box", "box"},
                                               {"kvadar", "kvadar", "kvadra", "kvadru"}};
  static constexpr bool kClosed = true, kComposed = false;
  /// The radius, and half the inner box' sides.
  static constexpr int kNumbers = 4;

  static Bounds bounds(const Box& s) { return {s.min, s.max}; }

  /// Around the inner box and a ball at its corners.
  static Bounds bounds_under(const Box& s, const Transform& t) {
    const Vec3 half = half_of(s);
    const Vec3 inner{half.x - s.radius, half.y - s.radius, half.z - s.radius};
    const auto reach = [&](double Vec3::*axis) {
      return std::fabs(t.along_x.*axis) * inner.x + std::fabs(t.along_y.*axis) * inner.y +
             std::fabs(t.along_z.*axis) * inner.z;
    };
    const Vec3 ball = ball_reach(t);
    return bounds_around(point_under(middle_of(s), t),
                         {reach(&Vec3::x) + s.radius * ball.x, reach(&Vec3::y) + s.radius * ball.y,
                          reach(&Vec3::z) + s.radius * ball.z});
  }

  static double distance_to(const Box& s, const Vec3& p) {
    const Vec3 middle = middle_of(s), half = half_of(s);
    const double x = std::fabs(p.x - middle.x) - (half.x - s.radius),
                 y = std::fabs(p.y - middle.y) - (half.y - s.radius),
                 z = std::fabs(p.z - middle.z) - (half.z - s.radius);
    const double outside = safe_length(std::fmax(x, 0), std::fmax(y, 0), std::fmax(z, 0));
    const double inside = std::fmin(std::fmax(x, std::fmax(y, z)), 0);
    return std::fabs(outside + inside - s.radius);
  }

  static const char* check(const Box& s) {
    if (!finite(s.min) || !finite(s.max)) return "a corner is not finite";
    if (!(s.max.x > s.min.x && s.max.y > s.min.y && s.max.z > s.min.z))
      return "its max is not above its min along every axis";
    if (!finite(s.radius) || s.radius < 0) return "its radius is not a finite number of 0 or more";
    const Vec3 half = half_of(s);
    // Such as 0.1 of from 0.1 to 0.3 is not too much, whatever doubles make of it.
    if (s.radius > std::min({half.x, half.y, half.z}) * (1 + 0x1p-40))
      return "its radius is more than half its shortest side";
    return nullptr;
  }

  /// What is sharp is the cube from -1 to 1; what is round keeps its proportions.
  static Placement place(const Box& s) {
    const Vec3 half = half_of(s);
    if (s.radius == 0)
      return {{{half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z}, middle_of(s)}, {0, 1, 1, 1}};
    const double unit = std::max({half.x, half.y, half.z});
    const auto inner = [&](double side) { return std::fmax(0, side - s.radius) / unit; };
    return {{{unit, 0, 0}, {0, unit, 0}, {0, 0, unit}, middle_of(s)},
            {s.radius / unit, inner(half.x), inner(half.y), inner(half.z)}};
  }

  /// u and v from 0 to 1 over each face, which looks upright from outside; of +y with -z up, of -y
  /// with +z. A rounded edge belongs to the face that it looks most towards.
  static BodySurface surface(const double* numbers, const V3<double>& p) {
    const double r = numbers[0];
    const V3<double> inner{numbers[1], numbers[2], numbers[3]};
    const V3<double> past{std::fabs(p.x) - inner.x, std::fabs(p.y) - inner.y,
                          std::fabs(p.z) - inner.z};
    const int axis = past.x >= past.y && past.x >= past.z ? 0 : past.y >= past.z ? 1 : 2;
    const V3<double> sign{std::copysign(1, p.x), std::copysign(1, p.y), std::copysign(1, p.z)};
    const double half_x = inner.x + r, half_y = inner.y + r, half_z = inner.z + r;
    BodySurface s;
    const V3<double> across{axis == 0 ? sign.x : 0, axis == 1 ? sign.y : 0, axis == 2 ? sign.z : 0};
    s.normal = across;
    if (r > 0 && std::fmax(past.x, std::fmax(past.y, past.z)) > 0)
      s.normal = {sign.x * std::fmax(past.x, 0), sign.y * std::fmax(past.y, 0),
                  sign.z * std::fmax(past.z, 0)};
    const V3<double> edge_u = axis == 0   ? V3<double>{0, 0, -2 * sign.x * half_z}
                              : axis == 1 ? V3<double>{2 * half_x, 0, 0}
                                          : V3<double>{2 * sign.z * half_x, 0, 0};
    const V3<double> edge_v =
        axis == 1 ? V3<double>{0, 0, -2 * sign.y * half_z} : V3<double>{0, 2 * half_y, 0};
    s.u = share(p, edge_u);
    s.v = share(p, edge_v);
    // Over a rounded edge a point also moves across the face.
    const auto along = [&](const V3<double>& edge) {
      return edge - across * (dot(edge, s.normal) / dot(across, s.normal));
    };
    s.along_u = along(edge_u);
    s.along_v = along(edge_v);
    return s;
  }

 private:
  static Vec3 middle_of(const Box& s) {
    return {s.min.x / 2 + s.max.x / 2, s.min.y / 2 + s.max.y / 2, s.min.z / 2 + s.max.z / 2};
  }
  static Vec3 half_of(const Box& s) {
    return {s.max.x / 2 - s.min.x / 2, s.max.y / 2 - s.min.y / 2, s.max.z / 2 - s.min.z / 2};
  }
  /// Where between the ends of an edge through the middle.
  static double share(const V3<double>& p, const V3<double>& edge) {
    return std::fmin(1, std::fmax(0, 0.5 + dot(p, edge) / dot(edge, edge)));
  }
};

#ifdef ZRAKA_ISA
namespace ZRAKA_ISA {

/// The square of the distance from the inner box along a ray, less the radius' square: a convex
/// function of pieces that are quadratic, from where the ray passes a plane of the inner box' sides
/// to where it passes the next.
template <class F>
struct RoundBox {
  V3<F> o, d, inner;
  F radius;

  /// On one axis, how far beyond its sides, and how that changes.
  struct Beyond {
    F e, d;
  };
  static ZRAKA_INLINE Beyond beyond(F t, F o, F d, F half) {
    const F x = o + t * d;
    const auto out = abs(x) > half;
    return {select(out, o - copy_sign(half, x), F(0.0)), select(out, d, F(0.0))};
  }
  struct Value {
    F square, slope;
  };
  ZRAKA_INLINE Value at(F t) const {
    const Beyond x = beyond(t, o.x, d.x, inner.x), y = beyond(t, o.y, d.y, inner.y),
                 z = beyond(t, o.z, d.z, inner.z);
    const V3<F> d_out{x.d, y.d, z.d};
    const V3<F> e{x.e + t * x.d, y.e + t * y.d, z.e + t * z.d};
    return {dot(e, e) - radius * radius, dot(e, d_out)};
  }
  /// The piece around t: its least value is at `least`, and it is 0 so far before and after.
  struct Piece {
    F least, half;
  };
  ZRAKA_INLINE Piece piece(F t) const {
    const Beyond x = beyond(t, o.x, d.x, inner.x), y = beyond(t, o.y, d.y, inner.y),
                 z = beyond(t, o.z, d.z, inner.z);
    const V3<F> e{x.e, y.e, z.e}, way{x.d, y.d, z.d};
    const F a = dot(way, way);
    // b² - a·c, without what it loses to cancellation (Lagrange's identity).
    const V3<F> aside = zraka::cross(e, way);
    const F root = sqrt(max(a * radius * radius - dot(aside, aside), F(0.0)));
    return {-dot(e, way) / a, root / a};
  }
};

template <class D>
struct BodyLanes<Box, D> {
  using F = typename D::F;
  using M = typename D::M;
  static constexpr int kMost = 2;

  template <class Numbers>
  static ZRAKA_INLINE void cross(const Numbers& numbers, const BodyRay<F>& ray, F (&at)[kMost]) {
    const F radius = numbers(0);
    const auto sharp = radius == F(0.0);
    Span<F> span;
    clip(span, ray.origin.x, ray.direction.x, F(1.0));
    clip(span, ray.origin.y, ray.direction.y, F(1.0));
    clip(span, ray.origin.z, ray.direction.z, F(1.0));
    auto hit = span.in <= span.out;
    if (!all(sharp)) {
      const V3<F> inner{numbers(1), numbers(2), numbers(3)};
      const RoundBox<F> box{ray.origin, ray.direction, inner, radius};
      Span<F> round;
      hit = select(sharp, hit, cross_round(box, round));
      span.in = select(sharp, span.in, round.in);
      span.out = select(sharp, span.out, round.out);
    }
    at[0] = select(hit, span.in, F(kNever));
    at[1] = select(hit, span.out, F(kNever));
  }

  template <class Numbers>
  static ZRAKA_INLINE V3<F> normal(const Numbers& numbers, const V3<F>& p) {
    const V3<F> past{abs(p.x) - numbers(1), abs(p.y) - numbers(2), abs(p.z) - numbers(3)};
    const F one(1.0), none(0.0);
    const V3<F> sign{copy_sign(one, p.x), copy_sign(one, p.y), copy_sign(one, p.z)};
    const auto x = both(past.x >= past.y, past.x >= past.z), y_or_z = past.y >= past.z;
    const V3<F> across{select(x, sign.x, none), select(but_not(y_or_z, x), sign.y, none),
                       select(either(x, y_or_z), none, sign.z)};
    const auto round =
        both(numbers(0) > none, max(past.x, max(past.y, past.z)) > none);
    if (!any(round)) return across;
    return {select(round, sign.x * max(past.x, none), across.x),
            select(round, sign.y * max(past.y, none), across.y),
            select(round, sign.z * max(past.z, none), across.z)};
  }

 private:
  static ZRAKA_INLINE M cross_round(const RoundBox<F>& box, Span<F>& span) {
    clip(span, box.o.x, box.d.x, box.inner.x + box.radius);
    clip(span, box.o.y, box.d.y, box.inner.y + box.radius);
    clip(span, box.o.z, box.d.z, box.inner.z + box.radius);
    const auto hit = span.in <= span.out;
    F bends[6];
    bends_of(box.o.x, box.d.x, box.inner.x, span, bends);
    bends_of(box.o.y, box.d.y, box.inner.y, span, bends + 2);
    bends_of(box.o.z, box.d.z, box.inner.z, span, bends + 4);

    // The least value is in the piece in which the slope becomes positive.
    Span<F> falling = span;
    F square[6];
    for (int k = 0; k < 6; ++k) {
      const auto value = box.at(bends[k]);
      square[k] = value.square;
      const auto falls = value.slope < F(0.0);
      falling.in = select(falls, max(bends[k], falling.in), falling.in);
      falling.out = select(falls, falling.out, min(bends[k], falling.out));
    }
    const F least = within(falling, box.piece(middle(falling)).least);
    const auto meets = both(hit, box.at(least).square <= F(0.0));

    // The surface is in the pieces in which the value becomes 0.
    Span<F> before{span.in, least}, after{least, span.out};
    for (int k = 0; k < 6; ++k) {
      const auto out = square[k] > F(0.0);
      const auto early = bends[k] <= least, late = bends[k] >= least;
      before.in = select(both(out, early), max(bends[k], before.in), before.in);
      before.out = select(but_not(early, out), min(bends[k], before.out), before.out);
      after.out = select(both(out, late), min(bends[k], after.out), after.out);
      after.in = select(but_not(late, out), max(bends[k], after.in), after.in);
    }
    const auto first = box.piece(middle(before)), last = box.piece(middle(after));
    span.in = within(before, first.least - first.half);
    span.out = within(after, last.least + last.half);
    return meets;
  }

  /// Where a ray passes the planes of two sides of the inner box, as far as it is in a span.
  static ZRAKA_INLINE void bends_of(F o, F d, F half, const Span<F>& span, F* bends) {
    const F inverse = F(1.0) / d;
    bends[0] = within(span, (-half - o) * inverse);
    bends[1] = within(span, (half - o) * inverse);
  }
  /// What is no number becomes the span's begin.
  static ZRAKA_INLINE F within(const Span<F>& span, F t) { return min(max(t, span.in), span.out); }
  static ZRAKA_INLINE F middle(const Span<F>& span) {
    return span.in + (span.out - span.in) * F(0.5);
  }
};

}  // namespace ZRAKA_ISA
#endif

}  // namespace zraka
