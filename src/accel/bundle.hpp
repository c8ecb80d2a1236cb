// SPDX-License-Identifier: Apache-2.0
// Rays that go down the hierarchy together.
#pragma once

#include "accel/pair_queue.hpp"
#include "accel/ray_lanes.hpp"
#include "accel/stack.hpp"

namespace zraka::ZRAKA_ISA {

/// 1/d with a large number for 1/0; boxes are larger than what that errs.
template <class F>
ZRAKA_INLINE F slab_inverse(F d) {
  return F(1) / copy_sign(max(abs(d), F(0x1p-60f)), d);
}

/// A group of rays in lanes, each for itself in memory besides, and what bounds all of them.
template <class L>
class Bundle {
 public:
  using R = typename L::Real;
  using F = typename L::F;

  ZRAKA_INLINE Bundle(const RayGroup<L>& rays, bool all_active)
      : x_(rays, all_active, &V3<F>::x),
        y_(rays, all_active, &V3<F>::y),
        z_(rays, all_active, &V3<F>::z),
        coherent_(x_.same_side && y_.same_side && z_.same_side) {
    for (std::size_t r = 0; r < kRegisters<L>; ++r) {
      const V3<F>&o = rays.ray[r].origin, &d = rays.ray[r].direction;
      const F columns[kColumns] = {o.x,           o.y,          o.z,           d.x,
                                   d.y,           d.z,          x_.inverse[r], y_.inverse[r],
                                   z_.inverse[r], x_.scaled[r], y_.scaled[r],  z_.scaled[r]};
      for (std::size_t i = 0; i < kColumns; ++i) L::store(columns[i], single_[i] + r * L::kWidth);
    }
  }

  /// Of ray i, in all lanes.
  ZRAKA_INLINE V3<F> origin(std::size_t i) const { return of_one(0, i); }
  ZRAKA_INLINE V3<F> direction(std::size_t i) const { return of_one(3, i); }

  /// Of the rays of these numbers.
  ZRAKA_INLINE V3<F> origins(typename L::I rays) const { return of_each(0, rays); }
  ZRAKA_INLINE V3<F> directions(typename L::I rays) const { return of_each(3, rays); }

  /// Pushes the children that some of the rays hit before their own t, of which `farthest` is the
  /// greatest. Where rays are few, small leaves become pairs at once. Returns the bits of kinds
  /// that there are now enough pairs of for a register.
  template <class Stack>
  ZRAKA_INLINE std::uint32_t push_children(const Node& node, std::uint32_t rays, const R* t,
                                           R farthest, Stack& stack, Pairs<L>& pairs) const {
    const auto count = static_cast<std::size_t>(__builtin_popcount(rays));
    const bool few = count <= FewRays<L>::kMost;
    const std::size_t before = stack.size();
    bool in_order = L::kWidth >= kNodeWidth;
    std::uint32_t kinds = 0;
    for (std::size_t k = 0; k < kNodeWidth; k += L::kWidth) {
      if (few) {
        if (coherent_)
          kinds |= push_ray_by_ray<true, kWide>(node, k, rays, t, stack, pairs);
        else
          kinds |= push_ray_by_ray<false, kWide>(node, k, rays, t, stack, pairs);
        continue;
      }
      if (!coherent_) {
        push_ray_by_ray<false, false>(node, k, rays, t, stack, pairs);
        continue;
      }
      alignas(64) R nearest[L::kWidth];
      const std::uint32_t hit = candidates(node, k, farthest, nearest);
      if (count < kRegisters<L> * static_cast<std::size_t>(__builtin_popcount(hit))) {
        push_ray_by_ray<true, false>(node, k, rays, t, stack, pairs);
      } else {
        push_box_by_box(node, k, hit, rays, t, nearest, stack);
        in_order = false;
      }
    }
    if (!in_order) stack.sort_from(before);
    return kinds;
  }

 private:
  static constexpr std::size_t kColumns = 12;
  static constexpr std::uint32_t kAllLanes =
      static_cast<std::uint32_t>((std::uint64_t{1} << L::kWidth) - 1);
  /// Lanes of one ray make no pairs.
  static constexpr bool kWide = L::kWidth != 1;

  ZRAKA_INLINE V3<F> of_one(std::size_t column, std::size_t i) const {
    return {F(single_[column][i]), F(single_[column + 1][i]), F(single_[column + 2][i])};
  }

  ZRAKA_INLINE V3<F> of_each(std::size_t column, typename L::I rays) const {
    return {L::look_up(single_[column], rays), L::look_up(single_[column + 1], rays),
            L::look_up(single_[column + 2], rays)};
  }

  /// Where rays enter and leave what lies between two planes.
  struct Slab {
    F enter, leave;
  };

  /// What the rays are along one axis, each and all together.
  struct Axis {
    F scaled[kRegisters<L>], inverse[kRegisters<L>];  // of each ray: origin/direction, 1/direction
    F o_lower, o_upper;                               // bounds of origins
    F i_lower, i_upper;                               // bounds of the magnitudes of 1/direction
    bool back, same_side;

    ZRAKA_INLINE Axis(const RayGroup<L>& rays, bool all_active, F V3<F>::*axis) {
      const F far(kFarAway<R>);
      F bounds[4] = {far, far, far, far};
      for (std::size_t r = 0; r < kRegisters<L>; ++r) {
        const F o = rays.ray[r].origin.*axis;
        inverse[r] = slab_inverse(rays.ray[r].direction.*axis);
        scaled[r] = o * inverse[r];
        F candidates[4] = {inverse[r], -inverse[r], o, -o};
        if (!all_active)
          for (F& c : candidates) c = select(rays.active[r], c, far);
        for (std::size_t i = 0; i < 4; ++i) bounds[i] = min(bounds[i], candidates[i]);
      }
      R least[4];
      min_of_each(bounds[0], bounds[1], bounds[2], bounds[3], least);
      const R lower = least[0], upper = -least[1];
      same_side = lower > 0 || upper < 0;
      back = upper < 0;
      o_lower = F(least[2]);
      o_upper = F(-least[3]);
      i_lower = back ? F(-upper) : F(lower);
      i_upper = back ? F(-lower) : F(upper);
    }

    /// Bounds over all rays for kWidth boxes, if they go to the same side: none enters before
    /// `near` or leaves after `far`.
    ZRAKA_INLINE Slab slab(const float* lower, const float* upper) const {
      const F in = back ? o_lower - L::load_box(upper) : L::load_box(lower) - o_upper;
      const F out = back ? o_upper - L::load_box(lower) : L::load_box(upper) - o_lower;
      return {in * select(in > F(0), i_lower, i_upper), out * select(out > F(0), i_upper, i_lower)};
    }
  };

  /// Which of the boxes [k, k + kWidth) any of the rays may hit before `limit`, and bounds of
  /// where they begin; for rays that go to the same sides.
  ZRAKA_INLINE std::uint32_t candidates(const Node& node, std::size_t k, R limit,
                                        R* nearest) const {
    const Slab x = x_.slab(node.lower_x + k, node.upper_x + k);
    const Slab y = y_.slab(node.lower_y + k, node.upper_y + k);
    const Slab z = z_.slab(node.lower_z + k, node.upper_z + k);
    const F enter = max(max(x.enter, y.enter), max(z.enter, F(0)));
    L::store(enter, nearest);
    return bits(enter <= min(min(x.leave, y.leave), min(z.leave, F(limit))));
  }

  /// Each of the candidates among the boxes [k, k + kWidth) against a register of rays at a time,
  /// where these are fewer tests.
  template <class Stack>
  ZRAKA_INLINE void push_box_by_box(const Node& node, std::size_t k, std::uint32_t candidates,
                                    std::uint32_t rays, const R* t, const R* nearest,
                                    Stack& stack) const {
    for (; candidates != 0; candidates &= candidates - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(candidates));
      const std::size_t i = k + lane;
      std::uint32_t through = 0;
      for (std::size_t r = 0; r < kRegisters<L>; ++r) {
        const auto slab = [i, r](const Axis& axis, const float* lower, const float* upper) {
          const float in = axis.back ? upper[i] : lower[i], out = axis.back ? lower[i] : upper[i];
          return Slab{roughly_mul_sub(F(static_cast<R>(in)), axis.inverse[r], axis.scaled[r]),
                      roughly_mul_sub(F(static_cast<R>(out)), axis.inverse[r], axis.scaled[r])};
        };
        const Slab x = slab(x_, node.lower_x, node.upper_x);
        const Slab y = slab(y_, node.lower_y, node.upper_y);
        const Slab z = slab(z_, node.lower_z, node.upper_z);
        const F enter = max(max(x.enter, y.enter), max(z.enter, F(0)));
        const F leave = min(min(x.leave, y.leave), min(z.leave, L::load(t + r * L::kWidth)));
        through |= group_bits<L>(enter <= leave, r);
      }
      through &= rays;
      stack.push_if(through != 0, {nearest[lane], node.child[i], node.leaf[i], through});
    }
  }

  /// Each of the rays against all the boxes [k, k + kWidth) at once, where these are fewer tests,
  /// the rays few, or go to different sides. With kPairs they must be few. Returns what
  /// push_children() returns.
  template <bool kSameSides, bool kPairs, class Stack>
  ZRAKA_INLINE std::uint32_t push_ray_by_ray(const Node& node, std::size_t k, std::uint32_t rays,
                                             const R* t, Stack& stack, Pairs<L>& pairs) const {
    using I = typename L::I;
    const auto sides = [k](const Axis& axis, const float* lower, const float* upper) {
      const bool back = kSameSides && axis.back;
      return Slab{L::load_box((back ? upper : lower) + k), L::load_box((back ? lower : upper) + k)};
    };
    const Slab x = sides(x_, node.lower_x, node.upper_x);
    const Slab y = sides(y_, node.lower_y, node.upper_y);
    const Slab z = sides(z_, node.lower_z, node.upper_z);
    I through(0);  // by box: the rays that hit it
    F nearest(kFarAway<R>);
    FewRays<L> few;
    std::size_t asked = 0;
    std::uint32_t hit_by_any = 0, kinds = 0;
    for (std::uint32_t left = rays; left != 0; left &= left - 1, ++asked) {
      const auto i = static_cast<std::size_t>(__builtin_ctz(left));
      F enter[3], leave[3];
      const auto cut = [&](const Slab& side, std::size_t axis) {
        const F inverse(single_[6 + axis][i]), scaled(single_[9 + axis][i]);
        const F a = roughly_mul_sub(side.enter, inverse, scaled);
        const F b = roughly_mul_sub(side.leave, inverse, scaled);
        if constexpr (kSameSides)
          enter[axis] = a, leave[axis] = b;
        else
          enter[axis] = min(a, b), leave[axis] = max(a, b);
      };
      cut(x, 0), cut(y, 1), cut(z, 2);
      const F in = max(max(enter[0], enter[1]), max(enter[2], F(0)));
      const F out = min(min(leave[0], leave[1]), min(leave[2], F(t[i])));
      const auto hit = in <= out;
      through = select(hit, through + I(static_cast<std::int32_t>(1u << i)), through);
      if constexpr (Stack::kOrdered) nearest = select(hit, min(nearest, in), nearest);
      if constexpr (kPairs) {
        few.ray[asked] = static_cast<std::int32_t>(i);
        few.hit[asked] = bits(hit);
        hit_by_any |= few.hit[asked];
      }
    }
    if constexpr (!kPairs) hit_by_any = ~bits(through == I(0)) & kAllLanes;
    // A missing child's box is empty only as long as its sides are not turned round.
    if (!kSameSides) hit_by_any &= static_cast<std::uint32_t>(node.children >> k);
    if constexpr (kPairs) {
      few.count = asked;
      kinds = pair_small_leaves(node, k, few, hit_by_any, pairs);
      if (hit_by_any == 0) return kinds;
    }
    stack.push_children(node, k, hit_by_any, nearest, through);
    return kinds;
  }

  /// Makes pairs of rays and the shapes of small leaves among the boxes [k, k + kWidth), as far as
  /// they are among those that any of the rays have hit, and takes them from these. Returns
  /// what push_children() returns.
  ZRAKA_INLINE std::uint32_t pair_small_leaves(const Node& node, std::size_t k,
                                               const FewRays<L>& rays, std::uint32_t& hit,
                                               Pairs<L>& pairs) const {
    using I = typename L::I;
    const I first = L::load(node.child + k);
    std::uint32_t kinds = 0;
    static_assert(kMostInSmallLeaf == 2);
    for (std::uint32_t left = node.small_kinds; left != 0; left &= left - 1) {
      const auto kind = static_cast<std::size_t>(__builtin_ctz(left));
      const std::uint32_t one = hit & static_cast<std::uint32_t>(node.small_leaves[kind][0] >> k);
      const std::uint32_t two = hit & static_cast<std::uint32_t>(node.small_leaves[kind][1] >> k);
      if ((one | two) == 0) continue;
      PairQueue<L>& queue = pairs.of_kind[kind];
      queue.add(rays, one | two, first);
      if (two != 0) queue.add(rays, two, first + I(1));
      if (queue.ready(false)) kinds |= 1u << kind;
      hit &= ~(one | two);
    }
    return kinds;
  }

  Axis x_, y_, z_;
  bool coherent_;  ///< all rays go to the same side along each axis
  /// Of each ray: origin, direction, 1/direction, origin/direction.
  alignas(64) R single_[kColumns][RayGroup<L>::kRays];
};

}  // namespace zraka::ZRAKA_ISA
