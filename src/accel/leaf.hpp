// SPDX-License-Identifier: Apache-2.0
// The rays of a group against the shapes of a leaf: rays in lanes and shapes one after the other,
// or the other way round, whichever takes fewer tests.
#pragma once

#include "accel/bundle.hpp"

namespace zraka::ZRAKA_ISA {

/// Parts of Node::leaf.
ZRAKA_INLINE std::int32_t leaf_count(std::int32_t leaf) {
  return leaf & (2 * kNodeWidth - 1);
}
ZRAKA_INLINE std::int32_t leaf_kind(std::int32_t leaf) {
  return leaf / (2 * kNodeWidth);
}

/// Whether it takes fewer tests to have the shapes in lanes than to have the rays there.
template <class L>
ZRAKA_INLINE bool shapes_in_lanes(std::uint32_t rays, std::int32_t leaf) {
  constexpr int kWidth = static_cast<int>(L::kWidth);
  const int count = leaf_count(leaf), registers = (count + kWidth - 1) / kWidth;
  return __builtin_popcount(rays) * registers < count;
}

/// Each of the rays against kWidth shapes of a leaf at a time: function(ray, slot of the first
/// shape, distances), where distances that are not positive are no hits.
template <class L, class R, class Function>
ZRAKA_INLINE void each_ray_in_leaf(const FrozenScene<R>& scene, const Bundle<L>& bundle,
                                   const BundleEntry<R>& entry, std::uint32_t rays,
                                   const Function& function) {
  using F = typename L::F;
  const auto count = static_cast<std::size_t>(leaf_count(entry.leaf));
  with_kind(scene, leaf_kind(entry.leaf), [&]<class Shape>(const FrozenShapes<R, Shape>& shapes) {
    for (std::size_t k = 0; k < count; k += L::kWidth) {
      const std::int32_t first = entry.child + static_cast<std::int32_t>(k);
      const auto exists = L::first(count - k);
      F shape[ShapeTraits<Shape>::kHitReals];
      load_shapes<L>(shapes, first, shape);
      for (std::uint32_t left = rays; left != 0; left &= left - 1) {
        const auto i = static_cast<std::size_t>(__builtin_ctz(left));
        const F distance =
            ShapeLanes<Shape, L>::intersect(shape, bundle.origin(i), bundle.direction(i));
        function(i, shapes.first_slot + first, select(exists, distance, F(-1)));
      }
    }
  });
}

/// What the rays of a group have met so far, in memory where each ray can be asked for.
template <class L>
struct Nearest {
  using R = typename L::Real;
  alignas(64) R t[RayGroup<L>::kRays];
  alignas(64) std::int32_t slot[RayGroup<L>::kRays];

  ZRAKA_INLINE void take(const RayLanes<L>& ray, std::size_t r) {
    L::store(ray.t, t + r * L::kWidth);
    L::store(ray.slot, slot + r * L::kWidth);
  }
  ZRAKA_INLINE void give(RayLanes<L>& ray, std::size_t r) const {
    ray.t = L::load(t + r * L::kWidth);
    ray.slot = L::load(slot + r * L::kWidth);
  }
  /// Ray i meets the shapes of the slots from `first` on at these distances. True if that is
  /// another hit than before.
  ZRAKA_INLINE bool meet(const FrozenScene<R>& scene, std::size_t i, std::int32_t first,
                         typename L::F distance) {
    using F = typename L::F;
    const auto nearer = both(distance > F(0), distance <= F(t[i]));
    if (!any(nearer)) return false;
    const std::int32_t before = slot[i];
    const R least = min_of(select(nearer, distance, F(kFarAway<R>)));
    for (std::uint32_t equal = bits(both(nearer, distance <= F(least))); equal != 0;
         equal &= equal - 1) {
      // Of equal hits the shape that was read first counts, in whatever order they are found.
      const std::int32_t found = first + __builtin_ctz(equal);
      if (least < t[i] || slot[i] < 0 || id_of(scene, found) < id_of(scene, slot[i]))
        slot[i] = found;
      t[i] = least;
    }
    return slot[i] != before;
  }
};

/// The bits of those of the rays that a register holds.
template <class L>
ZRAKA_INLINE std::uint32_t in_register(std::uint32_t rays, std::size_t r) {
  constexpr std::uint32_t kOne = static_cast<std::uint32_t>((std::uint64_t{1} << L::kWidth) - 1);
  return rays & kOne << (r * L::kWidth);
}

/// The nearest hits of an entry's rays in its leaf, into `rays` and `nearest`. True if any are new.
template <class L, class R = typename L::Real>
ZRAKA_INLINE bool nearest_in_leaf(const FrozenScene<R>& scene, const Bundle<L>& bundle,
                                  const BundleEntry<R>& entry, RayGroup<L>& rays,
                                  Nearest<L>& nearest) {
  bool changed = false;
  std::uint32_t one_by_one = 0;
  for (std::size_t r = 0; r < kRegisters<L>; ++r) {
    const std::uint32_t mine = in_register<L>(entry.rays, r);
    if (mine == 0) continue;
    if (shapes_in_lanes<L>(mine, entry.leaf)) {
      one_by_one |= mine;
      continue;
    }
    RayLanes<L>& ray = rays.ray[r];
    const typename L::I before = ray.slot;
    with_kind(scene, leaf_kind(entry.leaf), [&]<class Shape>(const FrozenShapes<R, Shape>& shapes) {
      for (std::int32_t i = 0; i < leaf_count(entry.leaf); ++i)
        meet<L>(scene, shapes, entry.child + i, ray);
    });
    if (all(ray.slot == before)) continue;
    nearest.take(ray, r);
    changed = true;
  }
  if (one_by_one == 0) return changed;
  bool more = false;
  each_ray_in_leaf<L>(scene, bundle, entry, one_by_one,
                      [&](std::size_t i, std::int32_t first, typename L::F distance) {
                        if (nearest.meet(scene, i, first, distance)) more = true;
                      });
  if (more)
    for (std::size_t r = 0; r < kRegisters<L>; ++r) nearest.give(rays.ray[r], r);
  return changed || more;
}

/// Which of the rays meet a shape of the entry's leaf nearer than their t; `t` has the same as
/// the group.
template <class L, class R = typename L::Real>
ZRAKA_INLINE std::uint32_t blocked_in_leaf(const FrozenScene<R>& scene, const Bundle<L>& bundle,
                                           const BundleEntry<R>& entry, std::uint32_t rays,
                                           const RayGroup<L>& group, const R* t) {
  using F = typename L::F;
  std::uint32_t blocked_rays = 0, one_by_one = 0;
  for (std::size_t r = 0; r < kRegisters<L>; ++r) {
    const std::uint32_t mine = in_register<L>(rays, r);
    if (mine == 0) continue;
    if (shapes_in_lanes<L>(mine, entry.leaf)) {
      one_by_one |= mine;
      continue;
    }
    const RayLanes<L>& ray = group.ray[r];
    typename L::M blocked = L::first(0);
    with_kind(scene, leaf_kind(entry.leaf), [&]<class Shape>(const FrozenShapes<R, Shape>& shapes) {
      for (std::int32_t i = 0; i < leaf_count(entry.leaf); ++i) {
        F shape[ShapeTraits<Shape>::kHitReals];
        broadcast_shape<L>(shapes, entry.child + i, shape);
        const F distance = ShapeLanes<Shape, L>::intersect(shape, ray.origin, ray.direction);
        blocked = either(blocked, both(distance > F(0), distance < ray.t));
      }
    });
    blocked_rays |= mine & group_bits<L>(blocked, r);
  }
  if (one_by_one != 0)
    each_ray_in_leaf<L>(scene, bundle, entry, one_by_one,
                        [&](std::size_t i, std::int32_t, F distance) {
                          if (any(both(distance > F(0), distance < F(t[i]))))
                            blocked_rays |= 1u << i;
                        });
  return blocked_rays;
}

}  // namespace zraka::ZRAKA_ISA
