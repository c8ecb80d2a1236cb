// SPDX-License-Identifier: Apache-2.0
// Rays against tori, as hits ask for them: what decides between crossings is found in the engine's
// own lanes, the one that counts is found in double from there. A lane that floats leave in doubt
// is asked as other bodies are.
#pragma once

#include "accel/body_rays.hpp"

namespace zraka::ZRAKA_ISA {

/// Rays in the tori's own spaces, in double, two registers of them or so.
template <class L>
struct TorusViews {
  using D = DoublesOf<L>;
  using F = typename D::F;
  static constexpr std::size_t kParts = kDoubleParts<L>;
  F o[3][kParts], d[3][kParts], before[kParts], unit[kParts], stretch[kParts], tube[kParts];
  F begin_value[kParts];  ///< TorusRay's where the rays begin

  /// Part i, with the numbers of `row`.
  template <class Row>
  ZRAKA_INLINE void set(std::size_t i, const Row& row, const V3<F>& origin,
                        const V3<F>& direction) {
    const V3<F> from{origin.x - row(kBodyCenter), origin.y - row(kBodyCenter + 1),
                     origin.z - row(kBodyCenter + 2)};
    const V3<F> own = into_body(row, from), way = into_body(row, direction);
    stretch[i] = sqrt(dot(way, way));
    unit[i] = F(1.0) / stretch[i];
    const V3<F> along = way * unit[i];
    before[i] = -dot(own, along);
    const V3<F> nearest = own + along * before[i];
    o[0][i] = nearest.x, o[1][i] = nearest.y, o[2][i] = nearest.z;
    d[0][i] = along.x, d[1][i] = along.y, d[2][i] = along.z;
    tube[i] = row(kBodyNumbers);
    begin_value[i] = torus(i).place(-before[i]).value;
  }
  ZRAKA_INLINE TorusRay<F> torus(std::size_t i) const {
    return {BodyRay<F>{{o[0][i], o[1][i], o[2][i]}, {d[0][i], d[1][i], d[2][i]}, F(0.0), true},
            tube[i]};
  }
};

/// The same in the engine's lanes: a polynomial whose signs are known where it is not near 0.
template <class L>
class RoughTorus {
 public:
  using F = typename L::F;
  using M = typename L::M;

  /// So far from 0 the value's sign is known, and so far outside of the torus' bounds a place is.
  static constexpr float kDoubt = 0x1p-16f;
  /// Thinner tubes are nothing but doubt.
  static constexpr float kThinnest = 0x1p-5f;

  ZRAKA_INLINE RoughTorus(const TorusViews<L>& views, F limit)
      : o_{narrow(views.o[0]), narrow(views.o[1]), narrow(views.o[2])},
        d_{narrow(views.d[0]), narrow(views.d[1]), narrow(views.d[2])},
        tube_(narrow(views.tube)) {
    const F rest = F(1) - tube_ * tube_, square = dot(o_, o_), sum = square + rest;
    a_ = F(2) * sum - F(4) + F(4) * (d_.y * d_.y);
    b_ = F(8) * (o_.y * d_.y);
    c_ = sum * sum - F(4) * (o_.x * o_.x + o_.z * o_.z);
    const F begin = -narrow(views.before), length = limit * narrow(views.stretch);
    end = begin + length;
    about = (length + abs(begin)) * F(0x1p-18f);
    // What is crossed of the ball and the slab that hold it, and a little more.
    const F reach = F(1) + tube_ + F(kDoubt);
    const F chord = reach * reach - square, half = sqrt(max(chord, F(0)));
    Span<F> whole{-half, half};
    clip(whole, o_.y, d_.y, tube_ + F(kDoubt));
    near = both(both(chord >= F(0), whole.in <= whole.out),
                both(whole.out >= begin, whole.in <= end + about));
    t_[0] = max(begin, whole.in);
    t_[4] = whole.out;
    value_[0] = select(begin > whole.in, narrow(views.begin_value), F(1));
    value_[4] = F(1);
  }

  M near;        ///< the rays that may cross it at all
  F end, about;  ///< where the rays end, in its own space, and how exactly that is known
  M doubt;       ///< set by find_first() and all that follows: the rays that floats do not settle
  /// The first crossing's bracket and which way it goes; set by find_first().
  M crossed, falls;
  F a, b;

  ZRAKA_INLINE void find_first() {
    doubt = but_not(near, tube_ >= F(kThinnest));
    find_turns();
    F around[5];
    for (int k = 0; k < 5; ++k) {
      const F x = o_.x + t_[k] * d_.x, y = o_.y + t_[k] * d_.y, z = o_.z + t_[k] * d_.z;
      around[k] = sqrt(x * x + z * z);
      if (k == 0 || k == 4) continue;
      const F out = around[k] - F(1), value = out * out + y * y - tube_ * tube_;
      // Behind the ray's begin it is what it is there, and beyond the bounds it is outside.
      const auto early = t_[k] <= t_[0], late = t_[k] >= t_[4];
      value_[k] = select(early, value_[0], select(late, F(1), value));
      t_[k] = min(max(t_[k], t_[0]), t_[4]);
      around[k] = select(early, around[0], around[k]);
      const auto known = either(either(early, late), abs(value) >= F(kDoubt));
      doubt = either(doubt, but_not(near, known));
    }
    crossed = but_not(near, near);
    a = t_[0], b = t_[4];
    F from_t = a, from_value(1), from_around(1), before_value(1);
    for (int k = 3; k >= 0; --k) {
      const auto in = value_[k] <= F(0), next_in = value_[k + 1] <= F(0);
      const auto falling = but_not(next_in, in);
      const auto here = either(falling, but_not(in, next_in));
      crossed = either(crossed, here);
      a = select(here, t_[k], a);
      b = select(here, t_[k + 1], b);
      before_value = select(here, value_[k], before_value);
      from_t = select(here, select(falling, t_[k + 1], t_[k]), from_t);
      from_value = select(here, select(falling, value_[k + 1], value_[k]), from_value);
      from_around = select(here, select(falling, around[k + 1], around[k]), from_around);
    }
    crossed = both(both(crossed, near), a <= end + about);
    falls = before_value > F(0);
    // How far from a least place the zeros of a parabola would be.
    const F value = from_value * (from_value + F(4) * from_around);
    const F reach = sqrt(max(-value / (F(6) * (from_t * from_t) + a_), F(0)));
    guess_ = from_t + select(falls, -reach, reach);
  }

  /// Whether the first crossing, wherever it is between a and b, is in front of the ray's begin and
  /// before its end.
  ZRAKA_INLINE M blocks() const { return both(b > t_[0] + F(kDoubt), b < end - about); }

  /// The first crossing as well as floats know it.
  ZRAKA_INLINE F zero() const {
    F t = select(both(guess_ > a, guess_ < b), guess_, (a + b) * F(0.5f));
    for (int k = 0; k < 2; ++k) {  // Halley's steps
      const F square = t * t;
      const F value = ((square + a_) * t + b_) * t + c_;
      const F slope = (F(4) * square + F(2) * a_) * t + b_;
      const F bend = F(6) * square + a_;  // half the second derivative
      t = t - value * slope / (slope * slope - value * bend);
      t = min(max(t, a), b);
    }
    return t;
  }

 private:
  /// As BodyLanes<Torus>::find_turns(), to some 2^-10: values there are flat.
  ZRAKA_INLINE void find_turns() {
    const F p = a_ * F(0.5f), q = b_ * F(0.25f), size = abs(q);
    const F root = sqrt(size), power = select(size < F(1), sqrt(root), root);
    const F slope = select(p < F(0), F(-2) * p, p);
    F x = sqrt(max(-p, F(0))) + min(size / slope, power), last = x;
    for (int k = 0; k < 3; ++k) {
      const F square = x * x, grows = F(3) * square + p, value = (square + p) * x - size;
      last = x;
      x = select(grows > F(0), x - value * grows / (grows * grows - F(3) * x * value), x);
    }
    doubt = either(doubt, but_not(near, abs(x - last) <= F(0x1p-9f)));
    const F apart = F(-3) * (x * x) - F(4) * p, between = sqrt(max(apart, F(0)));
    const auto three = apart > F(0), left = q >= F(0);
    const F large = select(three, (x + between) * F(0.5f), x);
    const F small = select(three, (x - between) * F(0.5f), x);
    const F outer = select(left, -x, x);
    t_[1] = select(three, select(left, -x, -large), outer);
    t_[2] = select(three, select(left, small, -small), outer);
    t_[3] = select(three, select(left, large, x), outer);
  }

  V3<F> o_, d_;
  F tube_, a_, b_, c_;
  F t_[5], value_[5];  // where the rays or the bounds begin and end, and three turns in between
  F guess_;
};

/// Puts the rays of those lanes into the views; of parts without any, another part's.
template <class L>
ZRAKA_INLINE void view_tori(const FrozenShapes<typename L::Real, Body>& bodies,
                            const BodyQuery<L>& query, std::uint32_t lanes, TorusViews<L>& views) {
  using D = DoublesOf<L>;
  constexpr auto kAll = static_cast<std::uint32_t>((std::uint64_t{1} << D::kWidth) - 1);
  const auto some = static_cast<std::size_t>(__builtin_ctz(lanes)) / D::kWidth * D::kWidth;
  for (std::size_t i = 0; i < views.kParts; ++i) {
    const std::size_t from = (lanes >> i * D::kWidth & kAll) != 0 ? i * D::kWidth : some;
    with_numbers<L>(bodies, query, from, lanes >> from & kAll, [&](const auto& row) {
      views.set(i, row, load_doubles<L>(query.origin, from),
                load_doubles<L>(query.direction, from));
    });
  }
}

/// The nearest hits of those lanes of a query, all of tori.
template <class L>
void hit_tori(const FrozenShapes<typename L::Real, Body>& bodies, BodyQuery<L>& query,
              std::uint32_t lanes, bool any_will_do) {
  using D = DoublesOf<L>;
  using F = typename L::F;
  TorusViews<L> views;
  view_tori<L>(bodies, query, lanes, views);
  RoughTorus<L> rough(views, L::load(query.limit));
  rough.near = both(rough.near, L::from_bits(lanes));
  if (!any(rough.near)) return;
  rough.find_first();
  std::uint32_t doubt = bits(rough.doubt), hit = bits(rough.crossed) & ~doubt, wanted = hit;
  F rough_zero = rough.b;
  if (any_will_do) wanted &= ~bits(rough.blocks());
  if (wanted != 0) rough_zero = select(L::from_bits(wanted), rough.zero(), rough_zero);
  typename D::F t[views.kParts];
  widen(rough_zero, t);
  for (std::size_t i = 0; i < views.kParts; ++i) {
    constexpr auto kAll = static_cast<std::uint32_t>((std::uint64_t{1} << D::kWidth) - 1);
    const std::uint32_t mine = wanted >> i * D::kWidth & kAll;
    if (mine != 0) {
      const Refined zeros = refine<D>(views.torus(i), mine, t[i]);
      const std::uint32_t turned = zeros.falls ^ bits(rough.falls) >> i * D::kWidth;
      doubt |= (mine & (~zeros.found | turned)) << i * D::kWidth;
    }
    t[i] = (t[i] + views.before[i]) * views.unit[i];
  }
  hit &= ~doubt;
  L::store(select(L::from_bits(hit), narrow(t), L::load(query.t)), query.t);
  if (doubt != 0) hit_bodies<Torus, L>(bodies, query, doubt, any_will_do);
}

}  // namespace zraka::ZRAKA_ISA
