// SPDX-License-Identifier: Apache-2.0
// Rays that go down the hierarchy together.
#pragma once

#include "accel/single_ray.hpp"

namespace zraka::ZRAKA_ISA {

/// A child that some rays of a bundle, a bit each, have still to visit.
template <class R>
struct BundleEntry {
  R t;  ///< how near the box begins for the first of them
  std::int32_t child, leaf;
  std::uint32_t rays;
};

template <class L>
using BundleStack = Stack<BundleEntry<typename L::Real>>;

/// Rays in lanes, and what bounds all of them.
template <class L>
class Bundle {
 public:
  using R = typename L::Real;
  using F = typename L::F;

  ZRAKA_INLINE Bundle(const RayLanes<L>& ray, typename L::M active)
      : x_(ray.origin.x, ray.direction.x, active),
        y_(ray.origin.y, ray.direction.y, active),
        z_(ray.origin.z, ray.direction.z, active),
        coherent_(x_.same_side && y_.same_side && z_.same_side) {
    const F rays[9] = {ray.origin.x,    ray.origin.y,    ray.origin.z,
                       ray.direction.x, ray.direction.y, ray.direction.z,
                       x_.inverse,      y_.inverse,      z_.inverse};
    for (std::size_t i = 0; i < 9; ++i) L::store(rays[i], single_[i]);
  }

  /// Ray i in all lanes.
  ZRAKA_INLINE SingleRay<L> single(std::size_t i) const {
    const auto vector = [&](std::size_t first) {
      return V3<R>{single_[first][i], single_[first + 1][i], single_[first + 2][i]};
    };
    return {vector(0), vector(3), vector(6)};
  }

  /// Pushes the children that some of the rays meet before their own t, and `farthest`, the
  /// greatest of these.
  ZRAKA_INLINE void push_children(const Node& node, std::uint32_t rays, F t, R farthest,
                                  bool sorted, BundleStack<L>& stack) const {
    const int before = stack.size();
    if (coherent_)
      push_if_met(node, rays, t, farthest, stack,
                  [&](const Axis& axis, const float* lower, const float* upper, std::size_t i) {
                    const float in = axis.back ? upper[i] : lower[i],
                                out = axis.back ? lower[i] : upper[i];
                    return Slab{roughly_mul_sub(F(static_cast<R>(in)), axis.inverse, axis.scaled),
                                roughly_mul_sub(F(static_cast<R>(out)), axis.inverse, axis.scaled)};
                  });
    else
      push_if_met(
          node, rays, t, farthest, stack,
          [&](const Axis& axis, const float* lower, const float* upper, std::size_t i) {
            const F a = roughly_mul_sub(F(static_cast<R>(lower[i])), axis.inverse, axis.scaled);
            const F b = roughly_mul_sub(F(static_cast<R>(upper[i])), axis.inverse, axis.scaled);
            return Slab{min(a, b), max(a, b)};
          });
    if (sorted) stack.sort_from(before);
  }

 private:
  /// Where rays enter and leave what lies between two planes.
  struct Slab {
    F enter, leave;
  };

  /// What the rays are along one axis, each and all together.
  struct Axis {
    F scaled, inverse;   // of each ray: origin/direction and 1/direction
    F o_lower, o_upper;  // bounds of origins
    F i_lower, i_upper;  // bounds of the magnitudes of 1/direction
    bool back, same_side;

    ZRAKA_INLINE Axis(F o, F d, typename L::M active) : inverse(slab_inverse(d)) {
      const F far(kFarAway<R>);
      scaled = o * inverse;
      R least[4];
      min_of_each(select(active, inverse, far), select(active, -inverse, far),
                  select(active, o, far), select(active, -o, far), least);
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
    /// How far at least the boxes are from where the rays begin.
    ZRAKA_INLINE F gap(const float* lower, const float* upper) const {
      return max(L::load_box(lower) - o_upper, o_lower - L::load_box(upper));
    }
  };

  template <class SlabOf>
  ZRAKA_INLINE void push_if_met(const Node& node, std::uint32_t rays, F t, R farthest,
                                BundleStack<L>& stack, const SlabOf& slab_of) const {
    for (std::size_t k = 0; k < kNodeWidth; k += L::kWidth) {
      alignas(64) R nearest[L::kWidth];
      for (std::uint32_t met = candidates(node, k, farthest, nearest); met != 0; met &= met - 1) {
        const auto lane = static_cast<std::size_t>(__builtin_ctz(met));
        const std::size_t i = k + lane;
        const Slab x = slab_of(x_, node.lower_x, node.upper_x, i);
        const Slab y = slab_of(y_, node.lower_y, node.upper_y, i);
        const Slab z = slab_of(z_, node.lower_z, node.upper_z, i);
        const F enter = max(max(x.enter, y.enter), max(z.enter, F(0)));
        const F leave = min(min(x.leave, y.leave), min(z.leave, t));
        const std::uint32_t through = rays & bits(enter <= leave);
        stack.push_if(through != 0, {nearest[lane], node.child[i], node.leaf[i], through});
      }
    }
  }

  /// Which of the boxes [k, k + kWidth) any of the rays may meet before `limit`, and bounds of
  /// where they begin.
  ZRAKA_INLINE std::uint32_t candidates(const Node& node, std::size_t k, R limit,
                                        R* nearest) const {
    if (!coherent_) {
      L::store(max(max(x_.gap(node.lower_x + k, node.upper_x + k),
                       y_.gap(node.lower_y + k, node.upper_y + k)),
                   max(z_.gap(node.lower_z + k, node.upper_z + k), F(0))),
               nearest);
      return bits(L::load_box(node.lower_x + k) <= L::load_box(node.upper_x + k));
    }
    const Slab x = x_.slab(node.lower_x + k, node.upper_x + k);
    const Slab y = y_.slab(node.lower_y + k, node.upper_y + k);
    const Slab z = z_.slab(node.lower_z + k, node.upper_z + k);
    const F enter = max(max(x.enter, y.enter), max(z.enter, F(0)));
    L::store(enter, nearest);
    return bits(enter <= min(min(x.leave, y.leave), min(z.leave, F(limit))));
  }

  Axis x_, y_, z_;
  bool coherent_;                       ///< all rays go to the same side along each axis
  alignas(64) R single_[9][L::kWidth];  ///< of each ray: origin, direction, 1/direction
};

}  // namespace zraka::ZRAKA_ISA
