// SPDX-License-Identifier: Apache-2.0
// The torus round y: in its own space the circle in the tube's middle is the unit circle.
#pragma once

#include <cmath>

#include "math/elementary.hpp"
#include "shapes/bodies/reach.hpp"
#include "shapes/bodies/roots.hpp"
#include "shapes/bodies/slab.hpp"
#include "shapes/bodies/upright.hpp"

namespace zraka {

template <>
struct ShapeTraits<Torus> {
  static constexpr const char* kName = "torus";
  static constexpr const char* kNouns[2][4] = {{"torus", "torus", "torus", "torus"},
                                               {"torus", "torus", "torusa", "torusu"}};
  static constexpr bool kClosed = true, kComposed = false;
  /// The tube's radius.
  static constexpr int kNumbers = 1;

  static Bounds bounds(const Torus& s) { return bounds_under(s, {}); }

  /// Around the circle and a ball at its points.
  static Bounds bounds_under(const Torus& s, const Transform& t) {
    const Placement placement = place(s);
    const Transform from_own = under(placement.from_own, t);
    const double tube = placement.numbers[0];
    const Vec3 circle = circle_reach(from_own), ball = ball_reach(from_own);
    return bounds_around(from_own.origin, {circle.x + tube * ball.x, circle.y + tube * ball.y,
                                           circle.z + tube * ball.z});
  }

  static double distance_to(const Torus& s, const Vec3& p) {
    const V3<double> up = axis_frame(s.normal).y, q = vector_of(p) - vector_of(s.center);
    const double y = dot(q, up);
    const V3<double> across = q - up * y;
    const double around = safe_length(across.x, across.y, across.z);
    return std::fabs(safe_length(around - s.radius, y, 0) - s.tube_radius);
  }

  static const char* check(const Torus& s) {
    if (!finite(s.center)) return "its centre is not finite";
    if (const char* const problem = check_axis(s.normal)) return problem;
    if (!finite(s.radius) || !finite(s.tube_radius) || !(s.radius > 0 && s.tube_radius > 0))
      return "its radii are not finite numbers above 0";
    if (s.tube_radius > s.radius) return "its tube_radius is more than its radius";
    return nullptr;
  }

  static Placement place(const Torus& s) {
    return {upright(s.center, s.normal, s.radius), {s.tube_radius / s.radius}};
  }

  /// u around the axis as on a sphere, v around the tube: 0.5 is its outside, above it grows.
  static BodySurface surface(const double*, const V3<double>& p) {
    constexpr double kPi = 3.14159265358979323846;
    const double around = std::sqrt(p.x * p.x + p.z * p.z), x = around - 1;
    const V3<double> out =
        around > 0 ? V3<double>{p.x / around, 0, p.z / around} : V3<double>{0, 0, 1};
    BodySurface s;
    s.normal = {out.x * x, p.y, out.z * x};
    s.u = 0.5 + elementary::atan2(out.x, out.z) / (2 * kPi);
    s.v = 0.5 + elementary::atan2(p.y, x) / (2 * kPi);
    const double circle = 2 * kPi * std::fmax(around, 0x1p-40);
    s.along_u = {circle * out.z, 0, -circle * out.x};
    s.along_v = {-2 * kPi * p.y * out.x, 2 * kPi * x, -2 * kPi * p.y * out.z};
    return s;
  }
};

#ifdef ZRAKA_ISA
namespace ZRAKA_ISA {

/// A ray and a torus. With the origin nearest the middle, |p|² = t² + |o|², and where
/// (|p|² + 1 - r²)² = 4·(x² + z²) is a polynomial of the fourth degree without a cube of t:
/// t⁴ + a·t² + b·t + c.
///
/// Between the zeros of its derivative there is a zero at most. The polynomial itself loses much to
/// cancellation where tubes are thin; v = (√(x² + z²) - 1)² + y² - r² has the same sign and does
/// not, and it is v·(v + 4·√(x² + z²)).
template <class F>
struct TorusRay {
  V3<F> o, d;
  F tube, a, b;

  ZRAKA_INLINE TorusRay(const BodyRay<F>& ray, F tube_radius)
      : o(ray.origin), d(ray.direction), tube(tube_radius) {
    const F sum = dot(o, o) + F(1.0) - tube * tube;
    a = F(2.0) * sum - F(4.0) + F(4.0) * (d.y * d.y);
    b = F(8.0) * (o.y * d.y);
  }

  /// v and √(x² + z²).
  struct Place {
    F value, around;
  };
  ZRAKA_INLINE Place place(F t) const {
    const F x = o.x + t * d.x, y = o.y + t * d.y, z = o.z + t * d.z;
    const F around = sqrt(x * x + z * z), out = around - F(1.0);
    return {out * out + y * y - tube * tube, around};
  }
  /// v and its slope, both times √(x² + z²).
  ZRAKA_INLINE ValueAndSlope<F> at(F t) const {
    const F x = o.x + t * d.x, y = o.y + t * d.y, z = o.z + t * d.z;
    const F around = max(sqrt(x * x + z * z), F(0x1p-500)), out = around - F(1.0);
    return {(out * out + y * y - tube * tube) * around,
            F(2.0) * (out * (x * d.x + z * d.z) + y * d.y * around)};
  }
  /// From t to the zero next to it: a step of Newton's, with what the slope changes on the way.
  struct Step {
    F t;
    decltype(F() < F()) near;  ///< it is not far
    decltype(F() < F()) sure;  ///< this is the zero, to some 2^-52
    decltype(F() < F()) falls;
  };
  ZRAKA_INLINE Step step(F t) const {
    const F x = o.x + t * d.x, y = o.y + t * d.y, z = o.z + t * d.z, across = x * d.x + z * d.z;
    const F around = max(sqrt(x * x + z * z), F(0x1p-500)), out = around - F(1.0);
    const F half_slope = out * across + y * d.y * around;  // v's, times `around`
    const F inverse = F(1.0) / around, steep = F(0.5) / half_slope;
    const F way = (out * out + y * y - tube * tube) * around * steep;
    const F first = across * inverse;  // derivatives of `around`
    const F second = (d.x * d.x + d.z * d.z - first * first) * inverse;
    const F bend = (F(1.0) - second) * (around * steep) * way, square = bend * bend;
    // What a parabola leaves, and what the third derivative does.
    const F error = abs(way) * (square + square + abs(first * second * steep) * (way * way));
    return {t - way * (F(1.0) + bend), abs(way) <= F(0x1p-8),
            both(error <= F(0x1p-54), square <= F(0x1p-6)), half_slope < F(0.0)};
  }
  /// How far from a least place of the polynomial its zeros would be if it were a parabola.
  ZRAKA_INLINE F reach_of(F t, const Place& there) const {
    const F value = there.value * (there.value + F(4.0) * there.around);
    return sqrt(max(-value / (F(6.0) * (t * t) + a), F(0.0)));
  }
};

/// Which lanes have come to a zero, and which of them are falling there, a bit each.
struct Refined {
  std::uint32_t found = 0, falls = 0;
};
/// Those lanes of t that are wanted, a bit each, come to the zeros next to them.
template <class D>
ZRAKA_INLINE Refined refine(const TorusRay<typename D::F>& torus, std::uint32_t wanted,
                            typename D::F& t) {
  constexpr int kMostSteps = 3;
  Refined lanes;
  for (int k = 0; k < kMostSteps && lanes.found != wanted; ++k) {
    const auto step = torus.step(t);
    wanted &= lanes.found | bits_of_doubles(step.near);
    const std::uint32_t going = wanted & ~lanes.found;
    t = select(D::from_bits(going), step.t, t);
    lanes.falls |= going & bits_of_doubles(both(step.sure, step.falls));
    lanes.found |= going & bits_of_doubles(step.sure);
  }
  return lanes;
}

template <class D>
struct BodyLanes<Torus, D> {
  using F = typename D::F;
  using M = typename D::M;
  static constexpr int kMost = 4;
  static constexpr bool kAsksForEnd = true;

  template <class Numbers>
  static ZRAKA_INLINE void cross(const Numbers& numbers, const BodyRay<F>& ray, F (&at)[kMost]) {
    for (F& t : at) t = F(kNever);
    const TorusRay<F> torus(ray, numbers(0));
    // Within the ball and the slab that hold it.
    const F reach = F(1.0) + torus.tube;
    const F chord = reach * reach - dot(ray.origin, ray.origin);
    const F end = sqrt(max(chord, F(0.0)));
    Span<F> span{-end, end};
    clip(span, ray.origin.y, ray.direction.y, torus.tube);
    auto near = both(chord >= F(0.0), span.in <= span.out);
    if (ray.first_only)
      near = both(near, both(span.out >= ray.begin, span.in <= ray.end + ray.about));
    if (!any(near)) return;
    if (ray.first_only) return cross_first(torus, ray, span, near, at);

    F turns[5] = {span.in, F(0.0), F(0.0), F(0.0), span.out};
    find_turns(torus, near, turns);
    const M outside = but_not(near, near);
    Turn before{span.in, F(0.0), F(0.0), outside};
    Part parts[4];
    for (int k = 0; k < 4; ++k) {
      const Turn next = k == 3 ? Turn{span.out, F(0.0), F(0.0), outside}
                               : turn_at(torus, min(max(turns[k + 1], span.in), span.out));
      parts[k] = part_between(before, next, near);
      before = next;
    }
    for (int k = 3; k >= 0; --k) {
      if (!any(parts[k].crossed)) continue;
      const auto wanted = both(parts[k].b >= ray.from, parts[k].a <= ray.end + ray.about);
      put_first(parts[k].crossed, parts[k].zero(torus, both(parts[k].crossed, wanted)), at);
    }
  }

  template <class Numbers>
  static ZRAKA_INLINE V3<F> normal(const Numbers&, const V3<F>& p) {
    const F around = sqrt(p.x * p.x + p.z * p.z), x = around - F(1.0);
    const auto off_axis = around > F(0.0);
    return {select(off_axis, p.x / around, F(0.0)) * x, p.y,
            select(off_axis, p.z / around, F(1.0)) * x};
  }

 private:
  /// Where the polynomial turns, or the span begins or ends: what it is there.
  struct Turn {
    F t, value, around;
    M inside;
  };
  static ZRAKA_INLINE Turn turn_at(const TorusRay<F>& torus, F t) {
    const auto there = torus.place(t);
    return {t, there.value, there.around, there.value <= F(0.0)};
  }

  /// What is between two turns, and whether the surface is crossed there; where it is, it is
  /// looked for from the turn that is inside.
  struct Part {
    F a, b;
    Turn from;
    M falls, crossed;

    ZRAKA_INLINE F zero(const TorusRay<F>& torus, M wanted) const {
      const F reach = torus.reach_of(from.t, {from.value, from.around});
      const F guess = select(falls, from.t - reach, from.t + reach);
      F t = select(both(guess > a, guess < b), guess, a + (b - a) * F(0.5));
      const M left = come_near(torus, wanted, t);
      if (!any(left)) return t;
      const auto function = [&](F x) { return torus.at(x); };
      return select(left, zero_in(Bracket<F, M>{a, b, falls}, left, function, t), t);
    }
    /// Lanes of t come to the zero by the torus' own steps; returns those that do not.
    ZRAKA_INLINE M come_near(const TorusRay<F>& torus, M left, F& t) const {
      constexpr int kMostSteps = 4;
      for (int k = 0; k < kMostSteps && any(left); ++k) {
        const auto step = torus.step(t);
        const auto going = both(left, both(step.t >= a, step.t <= b));
        t = select(going, step.t, t);
        const auto turned = either(but_not(falls, step.falls), but_not(step.falls, falls));
        left = but_not(left, but_not(both(going, step.sure), turned));
      }
      return left;
    }
  };
  static ZRAKA_INLINE Part part_between(const Turn& a, const Turn& b, M wanted) {
    const auto falls = but_not(b.inside, a.inside), rises = but_not(a.inside, b.inside);
    return {a.t, b.t, select_turn(falls, b, a), falls, both(wanted, either(falls, rises))};
  }
  static ZRAKA_INLINE Turn select_turn(M m, const Turn& a, const Turn& b) {
    return {select(m, a.t, b.t), select(m, a.value, b.value), select(m, a.around, b.around),
            select(m, a.inside, b.inside)};
  }

  /// The first crossing in a span alone: what is behind where the ray begins need not be found, nor
  /// what comes after the first.
  static ZRAKA_INLINE void cross_first(const TorusRay<F>& torus, const BodyRay<F>& ray,
                                       const Span<F>& whole, M near, F (&at)[kMost]) {
    const M outside = but_not(near, near), later = ray.begin > whole.in;
    const Span<F> span{select(later, ray.begin, whole.in), whole.out};
    Turn before{span.in, F(0.0), F(0.0), both(later, torus.place(span.in).value <= F(0.0))};
    F turns[5] = {span.in, F(0.0), F(0.0), F(0.0), span.out};
    find_turns(torus, near, turns);
    Part first{span.in, span.out, before, outside, outside};
    M open = near;  // where none has been found yet
    for (int k = 0; k < 4 && any(open); ++k) {
      const Turn next = k == 3 ? Turn{span.out, F(0.0), F(0.0), outside}
                               : turn_at(torus, min(max(turns[k + 1], span.in), span.out));
      const Part part = part_between(before, next, open);
      first = {select(part.crossed, part.a, first.a), select(part.crossed, part.b, first.b),
               select_turn(part.crossed, part.from, first.from),
               select(part.crossed, part.falls, first.falls), either(part.crossed, first.crossed)};
      open = but_not(open, part.crossed);
      before = next;
    }
    first.crossed = both(first.crossed, first.a <= ray.end + ray.about);
    if (!any(first.crossed)) return;
    M wanted = first.crossed;
    if (ray.any) wanted = but_not(wanted, both(first.a > ray.begin, first.b < ray.end - ray.about));
    const F zero = first.zero(torus, wanted);
    at[0] = select(first.crossed, select(first.falls, zero, F(-kNever)), F(kNever));
    at[1] = select(but_not(first.crossed, first.falls), zero, F(kNever));
  }

  /// Sets turns[1…3] to the zeros of the derivative, ascending: of t³ + p·t + q with p = a/2 and
  /// q = b/4. The one that is farthest out is of the sign of -q, and alone on its side; Newton's
  /// steps come down to it from a bound. The others follow from it by their sum and product; where
  /// they are not real, all three are the one.
  static ZRAKA_INLINE void find_turns(const TorusRay<F>& torus, M wanted, F (&turns)[5]) {
    constexpr int kMostSteps = 64;
    const F p = torus.a * F(0.5), q = torus.b * F(0.25), size = abs(q);
    // The zero of t³ + p·t = |q| is at most √-p + ∛|q|; and where the slope is known to be
    // greater, not so much more.
    const F root = sqrt(size), power = select(size < F(1.0), sqrt(root), root);
    const F slope = select(p < F(0.0), F(-2.0) * p, p);
    F x = sqrt(max(-p, F(0.0))) + min(size / slope, power);
    for (int k = 0; k < kMostSteps && any(wanted); ++k) {
      const F square = x * x, grows = F(3.0) * square + p;
      const F next = select(grows > F(0.0), (F(2.0) * square * x + size) / grows, x);
      const auto falls = x - next > x * F(0x1p-40);
      x = select(wanted, next, x);
      wanted = both(wanted, falls);
    }
    const F apart = F(-3.0) * (x * x) - F(4.0) * p;
    const auto three = apart > F(0.0), left = q >= F(0.0);
    const F large = select(three, (x + sqrt(max(apart, F(0.0)))) * F(0.5), x);
    const F small = select(three, size / (x * large), x);
    const F outer = select(left, -x, x);
    turns[1] = select(three, select(left, -x, -large), outer);
    turns[2] = select(three, select(left, small, -small), outer);
    turns[3] = select(three, select(left, large, x), outer);
  }
};

}  // namespace ZRAKA_ISA
#endif

}  // namespace zraka
