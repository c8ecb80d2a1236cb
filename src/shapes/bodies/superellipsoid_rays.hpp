// SPDX-License-Identifier: Apache-2.0
// Rays against superellipsoids.
//
// With exponents of 2 or less, p and q of 1 or more, the norm is convex: Newton's steps from
// outside come nearer to where it is 1 and never pass it. Others are pinched, and lie within the
// convex one whose p and q are 1 where theirs are less; there their crossings are searched for by
// intervals.
#pragma once

#include "shapes/bodies/roots.hpp"
#include "shapes/bodies/slab.hpp"

#ifdef ZRAKA_ISA
#include "math/double_power.hpp"

namespace zraka::ZRAKA_ISA {

/// The p-norm of two numbers of 0 or more, and its slopes.
template <class F>
struct PowerNorm {
  F value, along_a, along_b;

  /// `steepest`: the slope along a number that is 0, beside another.
  ZRAKA_INLINE PowerNorm(F a, F b, F p, F steepest) {
    const auto a_is_less = a < b;
    const F large = max(select(a_is_less, b, a), F(0x1p-1000));
    const F ratio = select(a_is_less, a, b) / large;
    const auto positive = ratio > F(0x1p-1000);
    const F power =
        select(positive, double_exp2(p * double_log2(max(ratio, F(0x1p-1000)))), F(0.0));
    const F factor = double_exp2(double_log2(F(1.0) + power) / p);
    value = large * factor;
    const F along_large = factor / (F(1.0) + power);
    const F along_small = select(positive, along_large * (power / ratio), steepest);
    along_a = select(a_is_less, along_small, along_large);
    along_b = select(a_is_less, along_large, along_small);
  }
};

/// The norm along a ray, less 1.
template <class F>
struct NormAlong {
  V3<F> o, d;
  F p, q;

  ZRAKA_INLINE ValueAndSlope<F> at(F t) const {
    const V3<F> v = o + d * t;
    // Where a slope leaps, 0 is between its values.
    const PowerNorm<F> level(abs(v.x), abs(v.y), p, F(0.0));
    const PowerNorm<F> whole(level.value, abs(v.z), q, F(0.0));
    const auto growth = [](F x, F way) { return select(x < F(0.0), -way, way); };
    const F outwards = level.along_a * growth(v.x, d.x) + level.along_b * growth(v.y, d.y);
    return {whole.value - F(1.0), whole.along_a * outwards + whole.along_b * growth(v.z, d.z)};
  }
};

/// The two crossings with a convex one, or where it is not known to be missed.
template <class F, class M>
ZRAKA_INLINE M cross_convex(const NormAlong<F>& norm, Span<F>& span) {
  constexpr int kMostSteps = 100;
  constexpr double kNear = 0x1p-50;
  M hit = span.in <= span.out, entering = hit, leaving = hit;
  // A step from an end inwards; what is done by then, or has nowhere to go to.
  const auto step = [&](F& t, F inwards, M& going) {
    const ValueAndSlope<F> f = norm.at(t);
    const F slope = f.slope * inwards;
    const auto falls = slope < F(0.0), close = f.value <= F(kNear);
    const F way = max(f.value, F(0.0)) / max(-slope, F(0x1p-1000));
    t = select(both(going, falls), t + inwards * way, t);
    hit = but_not(hit, but_not(but_not(going, falls), close));
    going = but_not(but_not(going, close), way <= F(0x1p-52));
  };
  for (int k = 0; k < kMostSteps; ++k) {
    if (any(entering)) step(span.in, F(1.0), entering);
    if (any(leaving)) step(span.out, F(-1.0), leaving);
    hit = both(hit, span.in <= span.out);
    entering = both(entering, hit);
    leaving = both(leaving, hit);
    if (!any(either(entering, leaving))) break;
  }
  return hit;
}

/// Numbers that are known to be between two.
struct Interval {
  double low, high;
};

/// A pinched superellipsoid and a ray, on its own: it is the same in all lanes, and seldom.
class PinchedRay {
 public:
  static constexpr int kMost = 8;

  ZRAKA_INLINE PinchedRay(const NormAlong<double>& norm, const Span<double>& span)
      : norm_(norm), span_(span) {
    for (double& t : found_) t = kNever;
  }

  /// Between the planes through the middle: in an octant |x|, |y| and |z| are linear.
  const double* crossings() {
    double ends[5] = {span_.in, plane(norm_.o.x, norm_.d.x), plane(norm_.o.y, norm_.d.y),
                      plane(norm_.o.z, norm_.d.z), span_.out};
    for (int i = 1; i < 3; ++i)
      for (int k = 1; k < 4 - i; ++k)
        if (ends[k + 1] < ends[k]) {
          const double t = ends[k];
          ends[k] = ends[k + 1];
          ends[k + 1] = t;
        }
    bool inside = false;
    for (int k = 0; k < 4; ++k) {
      const bool then = k < 3 && norm_.at(ends[k + 1]).value <= 0;
      search({ends[k], ends[k + 1], inside, then});
      inside = then;
    }
    return found_;
  }

 private:
  struct Part {
    double a, b;
    bool inside_a, inside_b;
  };

  double plane(double o, double d) const {
    const double t = -o / d;
    return t > span_.in && t < span_.out ? t : span_.out;
  }

  /// Cuts a part of an octant into halves until the norm is monotonic, or surely not 1; what is
  /// smaller than rounding shows, or takes too long, counts as monotonic.
  void search(const Part& octant) {
    constexpr int kMostDepth = 64, kMostParts = 4000;
    constexpr double kSmallest = 0x1p-46;
    Part waiting[kMostDepth];
    int count = 0;
    waiting[count++] = octant;
    while (count > 0) {
      const Part part = waiting[--count];
      ++parts_;
      const Known known = known_of(part);
      if (known == Known::away && part.inside_a == part.inside_b) continue;
      if (known != Known::nothing || part.b - part.a < kSmallest || parts_ > kMostParts ||
          count + 2 > kMostDepth) {
        if (part.inside_a != part.inside_b) add(part);
        continue;
      }
      const double middle = part.a + (part.b - part.a) / 2;
      const bool inside = norm_.at(middle).value <= 0;
      waiting[count++] = {middle, part.b, inside, part.inside_b};
      waiting[count++] = {part.a, middle, part.inside_a, inside};
    }
  }

  void add(const Part& part) {
    const Bracket<double, bool> bracket{part.a, part.b, part.inside_b};
    const double t = zero_in(bracket, true, [&](double s) { return norm_.at(s); });
    if (count_ < kMost) found_[count_++] = t;
  }

  enum class Known { nothing, away, monotonic };

  /// The norm grows with |x|, |y| and |z|; its slopes along them depend on their ratios alone and
  /// are monotonic in these.
  Known known_of(const Part& part) const {
    const V3<double> from = norm_.o + norm_.d * part.a, to = norm_.o + norm_.d * part.b;
    const Interval x = between(from.x, to.x), y = between(from.y, to.y), z = between(from.z, to.z);
    const PowerNorm<double> least = level(x.low, y.low), most = level(x.high, y.high);
    const PowerNorm<double> whole_least = whole(least.value, z.low),
                            whole_most = whole(most.value, z.high);
    if (whole_least.value > 1 + kSurely || whole_most.value < 1 - kSurely) return Known::away;

    const PowerNorm<double> flat = level(x.high, y.low), steep = level(x.low, y.high);
    const Interval outwards = sum(growth(around(flat.along_a, steep.along_a), from.x, to.x),
                                  growth(around(flat.along_b, steep.along_b), from.y, to.y));
    const PowerNorm<double> low = whole(most.value, z.low), high = whole(least.value, z.high);
    const Interval slope = sum(product(around(low.along_a, high.along_a), outwards),
                               growth(around(low.along_b, high.along_b), from.z, to.z));
    return slope.low > 0 || slope.high < 0 ? Known::monotonic : Known::nothing;
  }
  static constexpr double kSurely = 0x1p-48;

  PowerNorm<double> level(double x, double y) const { return {x, y, norm_.p, steepest(norm_.p)}; }
  PowerNorm<double> whole(double l, double z) const { return {l, z, norm_.q, steepest(norm_.q)}; }
  static double steepest(double p) { return p < 1 ? kNever : p > 1 ? 0 : 1; }

  static Interval around(double a, double b) { return a < b ? Interval{a, b} : Interval{b, a}; }
  static Interval between(double from, double to) {
    return around(from < 0 ? -from : from, to < 0 ? -to : to);
  }
  static Interval sum(const Interval& a, const Interval& b) {
    return {a.low + b.low, a.high + b.high};
  }
  /// Infinite times 0 is 0 here: what does not change has no part in a slope.
  static double times(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }
  /// Of slopes along a coordinate's size, where the coordinate itself changes.
  static Interval growth(const Interval& slope, double from, double to) {
    const double way = from + to < 0 ? from - to : to - from;
    return product(slope, {way, way});
  }
  /// Of an interval without negative numbers with another.
  static Interval product(const Interval& a, const Interval& b) {
    return {times(b.low < 0 ? a.high : a.low, b.low), times(b.high > 0 ? a.high : a.low, b.high)};
  }

  const NormAlong<double>& norm_;
  const Span<double> span_;
  double found_[kMost];
  int count_ = 0, parts_ = 0;
};

template <class D>
struct BodyLanes<Superellipsoid, D> {
  using F = typename D::F;
  using M = typename D::M;
  static constexpr int kMost = PinchedRay::kMost;

  template <class Numbers>
  static ZRAKA_INLINE void cross(const Numbers& numbers, const BodyRay<F>& ray, F (&at)[kMost]) {
    const F p = numbers(0), q = numbers(1), one(1.0);
    Span<F> span;
    clip(span, ray.origin.x, ray.direction.x, one);
    clip(span, ray.origin.y, ray.direction.y, one);
    clip(span, ray.origin.z, ray.direction.z, one);
    const NormAlong<F> norm{ray.origin, ray.direction, max(p, one), max(q, one)};
    const M hit = cross_convex<F, M>(norm, span);
    at[0] = select(hit, span.in, F(kNever));
    at[1] = select(hit, span.out, F(kNever));
    for (int k = 2; k < kMost; ++k) at[k] = F(kNever);
    const auto pinched = both(hit, either(p < one, q < one));
    if (any(pinched)) cross_pinched({ray.origin, ray.direction, p, q}, span, pinched, at);
  }

 private:
  /// Lane by lane.
  static void cross_pinched(const NormAlong<F>& norm, const Span<F>& span, M pinched,
                            F (&at)[kMost]) {
    constexpr std::size_t kWidth = D::kWidth;
    alignas(64) double o[3][kWidth], d[3][kWidth], p[kWidth], q[kWidth], in[kWidth], out[kWidth],
        wanted[kWidth], found[kMost][kWidth];
    D::store(norm.o.x, o[0]), D::store(norm.o.y, o[1]), D::store(norm.o.z, o[2]);
    D::store(norm.d.x, d[0]), D::store(norm.d.y, d[1]), D::store(norm.d.z, d[2]);
    D::store(norm.p, p), D::store(norm.q, q);
    D::store(span.in, in), D::store(span.out, out);
    D::store(select(pinched, F(1.0), F(0.0)), wanted);
    for (int k = 0; k < kMost; ++k) D::store(at[k], found[k]);
    for (std::size_t lane = 0; lane < kWidth; ++lane) {
      if (wanted[lane] == 0) continue;
      const NormAlong<double> one{{o[0][lane], o[1][lane], o[2][lane]},
                                  {d[0][lane], d[1][lane], d[2][lane]},
                                  p[lane],
                                  q[lane]};
      PinchedRay ray(one, {in[lane], out[lane]});
      const double* crossings = ray.crossings();
      for (int k = 0; k < kMost; ++k) found[k][lane] = crossings[k];
    }
    for (int k = 0; k < kMost; ++k) at[k] = D::load(found[k]);
  }
};

}  // namespace zraka::ZRAKA_ISA
#endif
