// SPDX-License-Identifier: Apache-2.0
// CSG of the simplest kind: what is within some convex members and outside of the others, as
// differences and intersections are. Where a ray meets it first is known without its expression.
#pragma once

#include <bit>

#include "accel/csg.hpp"

namespace zraka::ZRAKA_ISA {

/// Whether members of this type have one way in and one way out, the same whoever asks.
template <class Shape>
constexpr bool crosses_plainly() {
  if constexpr (ShapeTraits<Shape>::kClosed && !ShapeTraits<Shape>::kComposed)
    return BodyLanes<Shape, ScalarDoubles>::kMost == 2 &&
           !requires { BodyLanes<Shape, ScalarDoubles>::kAsksForEnd; };
  else
    return false;
}
inline constexpr bool kCrossesPlainly[kBodyTypes] = {
#define ZRAKA_PLAIN(Type, plural) crosses_plainly<Type>(),
    ZRAKA_BODIES(ZRAKA_PLAIN)
#undef ZRAKA_PLAIN
};

/// What is within some such members and outside of the others, and nothing else; or all but that.
/// Both have the same surface.
struct Meet {
  bool possible = false;    ///< whether a CSG body is one
  bool all_but = false;     ///< what is inside of one is outside of the other
  unsigned within = 0, outside = 0;  ///< a bit for each member

  explicit Meet(const FrozenBodies& bodies, std::int32_t body) {
    const CsgNumbers csg{bodies.numbers + bodies.start[body]};
    if (!csg.has_table()) return;
    const std::uint64_t table = csg.table(), others = ~table << (64 - (1u << csg.members()));
    all_but = !std::has_single_bit(table);
    if (all_but && !std::has_single_bit(others)) return;
    for (int i = 0; i < csg.members(); ++i)
      if (!kCrossesPlainly[bodies.type[csg.member(i)]]) return;
    const unsigned all = (1u << csg.members()) - 1;
    within = static_cast<unsigned>(std::countr_zero(all_but ? ~table : table));
    outside = all & ~within;
    possible = true;
  }
};

/// The way of lanes of rays through such a body: what CsgWay finds, of the same bits.
template <class D>
class CsgMeet {
 public:
  using F = typename D::F;
  using M = typename D::M;

  CsgMeet(const FrozenBodies& bodies, std::int32_t body, const Meet& meet, const V3<F>& origin,
          const V3<F>& direction, M asked, F limit)
      : bodies_(bodies), csg_{bodies.numbers + bodies.start[body]}, meet_(meet), origin_(origin),
        direction_(direction), limit_(limit), going_(asked) {
    F begin(0.0);
    for (unsigned left = meet.within; left != 0; left &= left - 1) {
      const F* const at = cross(std::countr_zero(left));
      begin = max(at[0], begin);
      end_ = min(at[1], end_);
      going_ = both(going_, both(begin < end_, begin < limit));
      misses_ = !any(going_);
      if (misses_) return;
    }
    find_hit(begin);
  }

  /// All of the rays, the whole: then there is nothing else to ask for.
  bool misses() const { return misses_; }

  /// The first crossing with the whole's surface in front of the origin, before the limit.
  F first_hit() const { return select(going_, hit_, F(kNever)); }

  /// Which rays come into the whole where they hit it, at t.
  M enters(F /*t*/) const {
    return meet_.all_but ? begins_inside_ : but_not(going_, begins_inside_);
  }

  /// Whether a member is crossed at t.
  M crosses(int i, F t) const {
    if ((crossed_ >> i & 1) == 0) return t < t;  // it is for certain not
    return either(at_[2 * i] == t, at_[2 * i + 1] == t);
  }

  int members() const { return csg_.members(); }
  std::int32_t member(int i) const { return csg_.member(i); }

 private:
  const F* cross(int i) {
    const std::int32_t member = csg_.member(i);
    kCrossingFunctions<D>[bodies_.type[member]](bodies_.numbers + bodies_.start[member], origin_,
                                                direction_, {}, at_ + 2 * i);
    crossed_ |= 1u << i;
    return at_ + 2 * i;
  }

  /// Whether all rays that count are for certain not in a member there.
  bool are_outside(int i, const PlaceOnRay<F>& place) const {
    const Sides<D> sides = sides_of_member<D>(bodies_, csg_, i, place);
    return !any(but_not(going_, sides.outside));
  }

  /// From t on through one member after the other that the whole is outside of and a ray is in.
  void find_hit(F t) {
    for (;;) {
      const F before = t;
      PlaceOnRay<F> place(origin_, direction_, t);
      for (unsigned left = meet_.outside; left != 0; left &= left - 1) {
        const int i = std::countr_zero(left);
        if ((crossed_ >> i & 1) == 0) {
          // Where the whole may be anywhere, rays begin outside of all and need all crossings.
          if (meet_.within != 0 && are_outside(i, place)) continue;
          cross(i);
        }
        t = select(both(at_[2 * i] <= t, t < at_[2 * i + 1]), at_[2 * i + 1], t);
        place = PlaceOnRay<F>(origin_, direction_, t);
      }
      if (!any(both(going_, t > before))) break;
    }
    going_ = both(going_, both(t < end_, t < limit_));
    begins_inside_ = both(going_, t <= F(0.0));
    hit_ = t;
    if (any(begins_inside_)) find_way_out();
  }
  /// Out of the whole at its end, or into the first member that it is outside of.
  void find_way_out() {
    F out = end_;
    for (unsigned left = meet_.outside; left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      if ((crossed_ >> i & 1) == 0) cross(i);
      const F in = at_[2 * i];
      out = select(both(in > F(0.0), in < at_[2 * i + 1]), min(in, out), out);
    }
    hit_ = select(begins_inside_, out, hit_);
    going_ = both(going_, hit_ < limit_);
  }

  const FrozenBodies& bodies_;
  CsgNumbers csg_;
  const Meet& meet_;
  const V3<F>&origin_, &direction_;
  bool misses_ = false;
  F limit_, end_{kNever};  ///< nothing of it is beyond
  F hit_;
  M going_, begins_inside_;
  unsigned crossed_ = 0;  ///< a bit for each member whose crossings are known
  F at_[2 * kMostCsgTableMembers];
};

}  // namespace zraka::ZRAKA_ISA
