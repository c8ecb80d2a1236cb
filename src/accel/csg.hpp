// SPDX-License-Identifier: Apache-2.0
// Constructive solid geometry: where a ray goes in and comes out of what bodies are together.
//
// A ray's crossings with each member come first. From one to the next, in front of the origin, it
// is asked which members hold the ray there and what their expression says; the first crossing at
// which that changes is the hit. So the surface of every member counts, and no span is put together
// that nobody asks for.
#pragma once

#include "accel/csg_sides.hpp"

namespace zraka::ZRAKA_ISA {

template <class D>
using CrossFunction = void (*)(const double* row, const V3<typename D::F>& origin,
                               const V3<typename D::F>& direction,
                               const Span<typename D::F>& between, typename D::F* at);

/// Crossings of one body for all lanes, of which those in a span count.
template <class Shape, class D>
void cross_shared(const double* row, const V3<typename D::F>& origin,
                  const V3<typename D::F>& direction, const Span<typename D::F>& between,
                  typename D::F* at) {
  using F = typename D::F;
  if constexpr (requires { BodyLanes<Shape, D>::kAsksForEnd; })
    crossings<Shape, D>(SharedNumbers<D>{row}, origin, direction, Wanted::all, between.out, at,
                        between.in);
  else
    crossings<Shape, D>(SharedNumbers<D>{row}, origin, direction, Wanted::all, F(kNever), at);
}

/// What members of this type have; nothing where they cannot be members.
template <class Shape, class D>
constexpr CrossFunction<D> crossing_function() {
  if constexpr (ShapeTraits<Shape>::kClosed && !ShapeTraits<Shape>::kComposed)
    return cross_shared<Shape, D>;
  else
    return nullptr;
}
template <class Shape>
constexpr int most_crossings() {
  if constexpr (ShapeTraits<Shape>::kClosed && !ShapeTraits<Shape>::kComposed)
    return BodyLanes<Shape, ScalarDoubles>::kMost;
  else
    return 0;
}
template <class D>
inline constexpr CrossFunction<D> kCrossingFunctions[kBodyTypes] = {
#define ZRAKA_FUNCTION(Type, plural) crossing_function<Type, D>(),
    ZRAKA_BODIES(ZRAKA_FUNCTION)
#undef ZRAKA_FUNCTION
};
inline constexpr int kMostCrossings[kBodyTypes] = {
#define ZRAKA_MOST(Type, plural) most_crossings<Type>(),
    ZRAKA_BODIES(ZRAKA_MOST)
#undef ZRAKA_MOST
};

/// One ray's, or lanes of rays', way through a CSG body.
template <class D>
class CsgWay {
 public:
  using F = typename D::F;
  using M = typename D::M;

  /// Of the lanes that are asked for, as far as `limit`. With `whole_alone`, members that no ray
  /// goes through before it and that the whole needs spare the others.
  CsgWay(const FrozenBodies& bodies, std::int32_t body, const V3<F>& origin, const V3<F>& direction,
         M asked, F limit, bool whole_alone)
      : csg_{bodies.numbers + bodies.start[body]}, asked_(asked), limit_(limit) {
    const bool by_table = csg_.has_table();
    const int members = csg_.members();
    Span<F> counts;
    if (whole_alone) counts = {F(0.0), limit};
    const int last_needed = whole_alone && by_table ? last_that_is_needed() : -1;
    int used = 0;
    for (int i = 0; i < members; ++i) {
      const std::int32_t member = csg_.member(i);
      const std::uint8_t type = bodies.type[member];
      kCrossingFunctions<D>[type](bodies.numbers + bodies.start[member], origin, direction, counts,
                                  at_ + used);
      first_[i] = used;
      used += kMostCrossings[type];
      if (!by_table) continue;
      put_bit(i, used);
      if (!whole_alone || !csg_needs(csg_.table(), i)) continue;
      keep_within(first_[i], used);
      counts = {begin_, min(end_, limit)};
      misses_ = !any(both(asked, begin_ < counts.out));
      if (misses_) return;
      if (i == last_needed) settle(bodies, origin, direction, used);
      if (settled_) return;
    }
    first_[members] = used;
  }

  /// All of the rays, the whole: then there is nothing else to ask for.
  bool misses() const { return misses_; }

  /// Whether what is behind distance t is inside.
  M inside(F t) const {
    if (csg_.has_table()) return D::has_bit(csg_.table(), members_at(crossing_count(), t));
    return csg_value(
        csg_.length(), [&](int i) { return csg_.step(i); },
        [&](int member) { return in_member(member, t); },
        [](CsgOperation operation, const M& a, const M& b) {
          return operation == CsgOperation::unite       ? either(a, b)
                 : operation == CsgOperation::intersect ? both(a, b)
                                                        : but_not(a, b);
        });
  }

  /// Which rays come into the whole where they hit it, at t.
  M enters(F t) const { return settled_ ? t == t : inside(t); }

  /// The next crossing with any member after t, kNever where there is none.
  F next(F t) const { return next_of(crossing_count(), t); }

  /// The first crossing with the whole's surface in front of the origin, before the limit.
  F first_hit() const {
    if (settled_) return select(asked_, begin_, F(kNever));
    if (!csg_.has_table()) {
      const auto is_inside = [&](F t) { return inside(t); };
      return first_change(crossing_count(), is_inside(F(0.0)), is_inside);
    }
    switch (crossing_count()) {  // mostly so few that no loop is needed
      case 4:
        return first_change_by_table(std::integral_constant<int, 4>{});
      case 6:
        return first_change_by_table(std::integral_constant<int, 6>{});
      default:
        return first_change_by_table(crossing_count());
    }
  }

  /// Whether a member is crossed at t.
  M crosses(int i, F t) const {
    M crossed = F(0.0) > F(0.0);
    for (int k = first_[i]; k < first_[i + 1]; ++k) crossed = either(crossed, at_[k] == t);
    return crossed;
  }

  int members() const { return csg_.members(); }
  std::int32_t member(int i) const { return csg_.member(i); }
  const F* crossings(int member) const { return at_ + first_[member]; }
  int crossing_count() const { return first_[csg_.members()]; }
  int crossing_count(int member) const { return first_[member + 1] - first_[member]; }

 private:
  int last_that_is_needed() const {
    int i = csg_.members() - 1;
    while (i >= 0 && !csg_needs(csg_.table(), i)) --i;
    return i;
  }
  /// Whether all rays hit the whole where it begins at the earliest: by the crossings that are
  /// known, `used` of them, and by where that is beside the other members.
  void settle(const FrozenBodies& bodies, const V3<F>& origin, const V3<F>& direction, int used) {
    const M may_hit = both(asked_, both(begin_ < limit_, begin_ < end_));
    M sure = begin_ > F(0.0);
    typename D::B in = members_at(used, begin_);
    const PlaceOnRay<F> place(origin, direction, begin_);
    for (int i = last_that_is_needed() + 1; i < csg_.members(); ++i) {
      if (any(but_not(may_hit, sure))) return;
      const Sides<D> sides = sides_of_member<D>(bodies, csg_, i, place);
      sure = both(sure, either(sides.inside, sides.outside));
      in = D::unite(in, D::bits_if(sides.inside, std::uint64_t{1} << i));
    }
    if (any(but_not(may_hit, both(sure, D::has_bit(csg_.table(), in))))) return;
    settled_ = true;
    asked_ = may_hit;
    for (int i = last_that_is_needed() + 1; i <= csg_.members(); ++i) first_[i] = used;
  }

  M in_member(int i, F t) const {
    M in = F(0.0) > F(0.0);
    for (int k = first_[i]; k + 1 < first_[i + 1]; k += 2)
      in = either(in, both(at_[k] <= t, t < at_[k + 1]));
    return in;
  }

  template <class Count>
  ZRAKA_INLINE F next_of(Count count, F t) const {
    F nearest(kNever);
    for (int k = 0; k < count; ++k) nearest = min(select(at_[k] > t, at_[k], F(kNever)), nearest);
    return nearest;
  }

  /// The first crossing before the limit behind which `value` is not what it began with.
  template <class Value>
  ZRAKA_INLINE F first_change(int count, M began, const Value& value) const {
    F t(0.0), found(kNever);
    for (M going = asked_;;) {
      t = next_of(count, t);
      going = both(going, t < limit_);
      if (!any(going)) return found;
      const M changed = both(going, differ(value(t), began));
      found = select(changed, t, found);
      going = but_not(going, changed);
    }
  }
  /// The same by the table. Before `begin_` is nothing: who is inside there has just come in.
  template <class Count>
  ZRAKA_INLINE F first_change_by_table(Count count) const {
    const std::uint64_t table = csg_.table();
    F t = begin_;
    typename D::B members = members_at(count, t);
    const M began = D::has_bit(table, members);
    M going = both(asked_, both(t < limit_, t < end_));
    M changed = both(going, both(began, t > F(0.0)));
    F found = select(changed, t, F(kNever));
    for (;;) {
      going = but_not(going, changed);
      if (!any(going)) return found;
      t = next_of(count, t);
      going = both(going, both(t < limit_, t <= end_));
      members = D::flip(members, crossed_at(count, t));
      changed = both(going, differ(D::has_bit(table, members), began));
      found = select(changed, t, found);
    }
  }
  static ZRAKA_INLINE M differ(M a, M b) { return either(but_not(a, b), but_not(b, a)); }

  /// The members that hold what is behind t, a bit each.
  template <class Count>
  ZRAKA_INLINE typename D::B members_at(Count count, F t) const {
    typename D::B in = D::bits_if(t < t, 0);
    for (int k = 0; k < count; k += 2)
      in = D::unite(in, D::bits_if(both(at_[k] <= t, t < at_[k + 1]), bit_[k / 2]));
    return in;
  }
  /// The members that are crossed at t, a bit each: entered, or left, or both and so neither.
  template <class Count>
  ZRAKA_INLINE typename D::B crossed_at(Count count, F t) const {
    typename D::B crossed = D::bits_if(t < t, 0);
    for (int k = 0; k < count; ++k)
      crossed = D::flip(crossed, D::bits_if(at_[k] == t, bit_[k / 2]));
    return crossed;
  }
  /// Member i's bit, for its pairs up to a crossing.
  ZRAKA_INLINE void put_bit(int i, int end) {
    const std::uint64_t bit = std::uint64_t{1} << i;
    bit_[first_[i] / 2] = bit;
    for (int k = first_[i] + 2; k < end; k += 2) bit_[k / 2] = bit;
  }
  /// The whole is nowhere but where a member is that it needs, whose crossings these are.
  ZRAKA_INLINE void keep_within(int begin, int end) {
    F in(kNever), out(-kNever);
    for (int k = begin; k < end; k += 2) {
      const auto ahead = at_[k + 1] > F(0.0);
      in = select(ahead, min(at_[k], in), in);
      out = select(ahead, at_[k + 1], out);
    }
    begin_ = max(in, begin_);
    end_ = min(out, end_);
  }

  CsgNumbers csg_;
  M asked_;
  F limit_;
  F begin_{0.0}, end_{kNever};  ///< in front of the origin the whole is nowhere else
  bool misses_ = false, settled_ = false;
  int first_[kMostCsgCrossings + 1];
  F at_[kMostCsgCrossings];
  std::uint64_t bit_[kMostCsgCrossings / 2];  ///< a pair's member, where there is a table
};

}  // namespace zraka::ZRAKA_ISA
