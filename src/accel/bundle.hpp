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
    L::store(ray.direction.x, direction_[0]);
    L::store(ray.direction.y, direction_[1]);
    L::store(ray.direction.z, direction_[2]);
  }

  /// Ray i in all lanes.
  ZRAKA_INLINE SingleRay<L> single(std::size_t i) const {
    return {{x_.origin[i], y_.origin[i], z_.origin[i]},
            {direction_[0][i], direction_[1][i], direction_[2][i]},
            {x_.inverse[i], y_.inverse[i], z_.inverse[i]}};
  }

  /// Pushes the children that some of the rays meet before their own t, and `farthest`, the
  /// greatest of these.
  ZRAKA_INLINE void push_children(const Node& node, std::uint32_t rays, F t, R farthest,
                                  bool sorted, BundleStack<L>& stack) const {
    const int before = stack.size();
    for (std::size_t k = 0; k < kNodeWidth; k += L::kWidth) {
      for (std::uint32_t met = candidates(node, k, farthest); met != 0; met &= met - 1) {
        const std::size_t i = k + static_cast<std::size_t>(__builtin_ctz(met));
        const F near = max(max(x_.enter(node.lower_x[i], node.upper_x[i]),
                               y_.enter(node.lower_y[i], node.upper_y[i])),
                           max(z_.enter(node.lower_z[i], node.upper_z[i]), F(0)));
        const F far = min(min(x_.leave(node.lower_x[i], node.upper_x[i]),
                              y_.leave(node.lower_y[i], node.upper_y[i])),
                          min(z_.leave(node.lower_z[i], node.upper_z[i]), t));
        const auto inside = near <= far;
        const std::uint32_t through = rays & bits(inside);
        if (through == 0) continue;
        stack.push({sorted ? min_of(select(inside, near, F(kFarAway<R>))) : R(0), node.child[i],
                    node.leaf[i], through});
      }
    }
    if (sorted) stack.sort_from(before);
  }

 private:
  /// What the rays are along one axis, each and all together.
  struct Axis {
    F scaled, inv;       // of each ray: origin/direction and 1/direction
    F o_lower, o_upper;  // bounds of origins
    F i_lower, i_upper;  // bounds of the magnitudes of 1/direction
    bool back, same_side;
    alignas(64) R origin[L::kWidth];
    alignas(64) R inverse[L::kWidth];

    ZRAKA_INLINE Axis(F o, F d, typename L::M active) : inv(slab_inverse(d)) {
      const F far(kFarAway<R>);
      scaled = o * inv;
      L::store(o, origin);
      L::store(inv, inverse);
      const R lower = min_of(select(active, inv, far)), upper = max_of(select(active, inv, -far));
      same_side = lower > 0 || upper < 0;
      back = upper < 0;
      o_lower = F(min_of(select(active, o, far)));
      o_upper = F(max_of(select(active, o, -far)));
      i_lower = back ? F(-upper) : F(lower);
      i_upper = back ? F(-lower) : F(upper);
    }

    /// Where each ray enters and leaves the slab of one box.
    ZRAKA_INLINE F enter(float lower, float upper) const {
      if (same_side) return roughly_mul_sub(F(static_cast<R>(back ? upper : lower)), inv, scaled);
      return min(roughly_mul_sub(F(static_cast<R>(lower)), inv, scaled),
                 roughly_mul_sub(F(static_cast<R>(upper)), inv, scaled));
    }
    ZRAKA_INLINE F leave(float lower, float upper) const {
      if (same_side) return roughly_mul_sub(F(static_cast<R>(back ? lower : upper)), inv, scaled);
      return max(roughly_mul_sub(F(static_cast<R>(lower)), inv, scaled),
                 roughly_mul_sub(F(static_cast<R>(upper)), inv, scaled));
    }

    /// Bounds over all rays for kWidth boxes: none enters before `near` or leaves after `far`.
    ZRAKA_INLINE void slab(const float* lower, const float* upper, F& near, F& far) const {
      const F in = back ? o_lower - L::load_box(upper) : L::load_box(lower) - o_upper;
      const F out = back ? o_upper - L::load_box(lower) : L::load_box(upper) - o_lower;
      near = in * select(in > F(0), i_lower, i_upper);
      far = out * select(out > F(0), i_upper, i_lower);
    }
  };

  /// Which of the boxes [k, k + kWidth) any of the rays may meet before `limit`.
  ZRAKA_INLINE std::uint32_t candidates(const Node& node, std::size_t k, R limit) const {
    if (!coherent_) return bits(L::load_box(node.lower_x + k) <= L::load_box(node.upper_x + k));
    F nx, ny, nz, fx, fy, fz;
    x_.slab(node.lower_x + k, node.upper_x + k, nx, fx);
    y_.slab(node.lower_y + k, node.upper_y + k, ny, fy);
    z_.slab(node.lower_z + k, node.upper_z + k, nz, fz);
    return bits(max(max(nx, ny), max(nz, F(0))) <= min(min(fx, fy), min(fz, F(limit))));
  }

  Axis x_, y_, z_;
  bool coherent_;  ///< all rays go to the same side along each axis
  alignas(64) R direction_[3][L::kWidth];
};

}  // namespace zraka::ZRAKA_ISA
