// SPDX-License-Identifier: Apache-2.0
// The rays of a group against the shapes of a leaf: rays in lanes and shapes one after the other,
// or the other way round, whichever takes fewer tests; and the pairs that have waited.
#pragma once

#include "accel/pairs.hpp"
#include "accel/shadowless.hpp"

namespace zraka::ZRAKA_ISA {

/// Whether it takes fewer tests to have the shapes in lanes than to have the rays there.
template <class L>
ZRAKA_INLINE bool shapes_in_lanes(std::uint32_t rays, std::int32_t leaf) {
  constexpr int kWidth = static_cast<int>(L::kWidth);
  const int count = leaf_count(leaf), registers = (count + kWidth - 1) / kWidth;
  return __builtin_popcount(rays) * registers < count;
}

/// Each of the rays against kWidth shapes of a leaf at a time: function(ray, slot of the first
/// shape, distances, shapes), where distances that are not positive are no hits.
template <bool kAny, class L, class R, class Function>
ZRAKA_INLINE void each_ray_in_leaf(const FrozenScene<R>& scene, const Bundle<L>& bundle,
                                   const BundleEntry<R>& entry, std::uint32_t rays, const R* t,
                                   const Function& function) {
  using F = typename L::F;
  const auto count = static_cast<std::size_t>(leaf_count(entry.leaf));
  with_kind(scene, leaf_kind(entry.leaf), [&]<class Shape>(const FrozenShapes<R, Shape>& shapes) {
    for (std::size_t k = 0; k < count; k += L::kWidth) {
      const std::int32_t first = entry.child + static_cast<std::int32_t>(k);
      const auto exists = L::first(count - k);
      NumbersOf<Shape, L> shape;
      load_shapes<L>(shapes, first, shape);
      for (std::uint32_t left = rays; left != 0; left &= left - 1) {
        const auto i = static_cast<std::size_t>(__builtin_ctz(left));
        const F distance = intersect_shape<kAny, Shape, L>(
            shape, bundle.origin(i), bundle.direction(i), select(exists, F(t[i]), F(-1)));
        function(i, shapes.first_slot + first, select(exists, distance, F(-1)), shapes);
      }
    }
  });
}

/// What the rays of a group have hit so far, in memory where each ray can be asked for.
template <class L>
struct Nearest {
  using R = typename L::Real;
  alignas(64) R t[RayGroup<L>::kRays];
  alignas(64) std::int32_t slot[RayGroup<L>::kRays];

  ZRAKA_INLINE void take(const RayLanes<L>& ray, std::size_t r) {
    L::store(ray.t, t + r * L::kWidth);
    L::store(ray.slot, slot + r * L::kWidth);
  }
  ZRAKA_INLINE void give(RayGroup<L>& rays) const {
    for (std::size_t r = 0; r < kRegisters<L>; ++r) {
      rays.ray[r].t = L::load(t + r * L::kWidth);
      rays.ray[r].slot = L::load(slot + r * L::kWidth);
    }
  }
  /// Ray i hits the shapes of the slots from `first` on at these distances. True if that is
  /// another hit than before.
  ZRAKA_INLINE bool intersect(const FrozenScene<R>& scene, std::size_t i, std::int32_t first,
                              typename L::F distance) {
    using F = typename L::F;
    const auto nearer = both(distance > F(0), distance <= F(t[i]));
    if (!any(nearer)) return false;
    const R least = min_of(select(nearer, distance, F(kFarAway<R>)));
    bool changed = false;
    for (std::uint32_t equal = bits(both(nearer, distance <= F(least))); equal != 0;
         equal &= equal - 1)
      changed |= keep(scene, i, first + __builtin_ctz(equal), least);
    return changed;
  }
  /// Ray i hits the shape of one slot at a distance that is not greater than its t. True if that
  /// is another hit than before.
  ZRAKA_INLINE bool keep(const FrozenScene<R>& scene, std::size_t i, std::int32_t found,
                         R distance) {
    // Of equal hits the shape that was read first counts, in whatever order they are found.
    if (!(distance < t[i]) && slot[i] >= 0 && id_of(scene, found) >= id_of(scene, slot[i]))
      return false;
    t[i] = distance;
    slot[i] = found;
    return true;
  }
  /// A queue's first pairs hit, up to a register of them. True if any ray has another hit than
  /// before.
  template <class Shape>
  bool intersect(const FrozenScene<R>& scene, const FrozenShapes<R, Shape>& shapes,
                 const Bundle<L>& bundle, PairQueue<L>& queue) {
    using F = typename L::F;
    const auto pairs_hit = intersect_pairs<false, L>(shapes, bundle, queue, t);
    const auto nearer =
        both(pairs_hit.distance > F(0), pairs_hit.distance <= L::look_up(t, pairs_hit.ray));
    std::uint32_t lanes = bits(both(nearer, pairs_hit.active));
    if (lanes == 0) return false;
    alignas(64) R distance[L::kWidth];
    alignas(64) std::int32_t ray[L::kWidth];
    L::store(pairs_hit.distance, distance);
    L::store(pairs_hit.ray, ray);
    bool changed = false;
    for (; lanes != 0; lanes &= lanes - 1) {
      const int lane = __builtin_ctz(lanes);
      const auto i = static_cast<std::size_t>(ray[lane]);
      if (distance[lane] <= t[i])  // an earlier lane may hold the same ray
        changed |= keep(scene, i, shapes.first_slot + pairs_hit.shape[lane], distance[lane]);
    }
    return changed;
  }
};

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
        intersect_one<L>(scene, shapes, entry.child + i, ray);
    });
    if (all(ray.slot == before)) continue;
    nearest.take(ray, r);
    changed = true;
  }
  if (one_by_one == 0) return changed;
  bool more = false;
  each_ray_in_leaf<false, L>(scene, bundle, entry, one_by_one, nearest.t,
                             [&](std::size_t i, std::int32_t first, typename L::F distance,
                                 const auto&) {
                               if (nearest.intersect(scene, i, first, distance)) more = true;
                             });
  if (more) nearest.give(rays);
  return changed || more;
}

/// The nearest hits of pairs of some kinds, a bit each: of as many as fill registers, or of all.
/// True if any are new.
template <class L, class R = typename L::Real>
ZRAKA_INLINE bool nearest_of_pairs(const FrozenScene<R>& scene, const Bundle<L>& bundle,
                                   Pairs<L>& pairs, std::uint32_t kinds, bool all,
                                   RayGroup<L>& rays, Nearest<L>& nearest) {
  bool changed = false;
  for (; kinds != 0; kinds &= kinds - 1) {
    const std::int32_t kind = __builtin_ctz(kinds);
    if (PairQueue<L>& queue = pairs.of_kind[kind]; queue.ready(all))
      with_kind(scene, kind, [&](const auto& shapes) {
        while (queue.ready(all)) changed |= nearest.intersect(scene, shapes, bundle, queue);
      });
  }
  if (changed) nearest.give(rays);
  return changed;
}

/// A queue's first pairs hit, up to a register of them: the rays that are blocked nearer than
/// their t, a bit each.
template <class L, class Shape, class R = typename L::Real>
std::uint32_t blocked_in_queue(const FrozenScene<R>& scene, const FrozenShapes<R, Shape>& shapes,
                               std::int32_t kind, const Bundle<L>& bundle, PairQueue<L>& queue,
                               const R* t, LastBlocker& last) {
  using F = typename L::F;
  const auto pairs_hit = intersect_pairs<true, L>(shapes, bundle, queue, t);
  const auto nearer =
      both(pairs_hit.distance > F(0), pairs_hit.distance < L::look_up(t, pairs_hit.ray));
  std::uint32_t blocked = 0;
  std::uint32_t lanes = that_throw_shadows(scene, shapes, bits(both(nearer, pairs_hit.active)),
                                           [&](int lane) { return pairs_hit.shape[lane]; });
  if (lanes == 0) return 0;
  alignas(64) std::int32_t ray[L::kWidth];
  L::store(pairs_hit.ray, ray);
  last = {pairs_hit.shape[__builtin_ctz(lanes)], leaf_of(1, kind)};
  for (; lanes != 0; lanes &= lanes - 1) blocked |= 1u << ray[__builtin_ctz(lanes)];
  return blocked;
}

/// Which rays pairs of some kinds block, a bit each: as many pairs as fill registers, or all.
template <class L, class R = typename L::Real>
ZRAKA_INLINE std::uint32_t blocked_by_pairs(const FrozenScene<R>& scene, const Bundle<L>& bundle,
                                            const R* t, Pairs<L>& pairs, std::uint32_t kinds,
                                            bool all, LastBlocker& last) {
  std::uint32_t blocked = 0;
  for (; kinds != 0; kinds &= kinds - 1) {
    const std::int32_t kind = __builtin_ctz(kinds);
    if (PairQueue<L>& queue = pairs.of_kind[kind]; queue.ready(all))
      with_kind(scene, kind, [&](const auto& shapes) {
        while (queue.ready(all))
          blocked |= blocked_in_queue<L>(scene, shapes, kind, bundle, queue, t, last);
      });
  }
  return blocked;
}

/// Which of the rays hit some of the shapes of a leaf nearer than their t: rays in lanes, a shape
/// after the other.
template <class L, class Shape, class R = typename L::Real>
ZRAKA_INLINE std::uint32_t blocked_by_each_shape(const FrozenScene<R>& scene,
                                                 const FrozenShapes<R, Shape>& shapes,
                                                 std::int32_t first, std::int32_t count,
                                                 std::uint32_t rays, const RayGroup<L>& group) {
  std::uint32_t blocked_rays = 0;
  for (std::size_t r = 0; r < kRegisters<L>; ++r) {
    if (in_register<L>(rays, r) == 0) continue;
    const RayLanes<L>& ray = group.ray[r];
    typename L::M blocked = L::first(0);
    for (std::int32_t i = first; i < first + count; ++i) {
      if (is_shadowless(scene, shapes, i)) continue;
      NumbersOf<Shape, L> shape;
      broadcast_shape<L>(shapes, i, shape);
      blocked = either(blocked, blocks<Shape, L>(shape, ray.origin, ray.direction, ray.t));
    }
    blocked_rays |= group_bits<L>(blocked, r);
  }
  return blocked_rays & rays;
}

/// The same with shapes in lanes, a ray after the other. Who is blocked by the first register of
/// shapes asks no more; what each ray hits cannot be foreseen, so that nothing branches on it.
template <class L, class Shape, class R = typename L::Real>
ZRAKA_INLINE std::uint32_t blocked_ray_by_ray(const FrozenScene<R>& scene,
                                              const FrozenShapes<R, Shape>& shapes,
                                              std::int32_t first, std::int32_t count,
                                              std::uint32_t rays, const Bundle<L>& bundle,
                                              const R* t) {
  using F = typename L::F;
  std::uint32_t blocked = 0;
  for (std::int32_t k = 0; k < count && rays != 0; k += static_cast<std::int32_t>(L::kWidth)) {
    const auto exists = L::first(static_cast<std::size_t>(count - k));
    NumbersOf<Shape, L> shape;
    load_shapes<L>(shapes, first + k, shape);
    for (std::uint32_t left = rays; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctz(left));
      const auto hit = both(exists, blocks<Shape, L>(shape, bundle.origin(i), bundle.direction(i),
                                                     select(exists, F(t[i]), F(-1))));
      const std::uint32_t by =
          that_throw_shadows(scene, shapes, bits(hit), [&](int lane) { return first + k + lane; });
      blocked |= static_cast<std::uint32_t>(by != 0) << i;
    }
    rays &= ~blocked;
  }
  return blocked;
}

/// Spheres, which know without a distance what they block, each ray or each shape after the other,
/// whichever takes fewer tests.
template <class L, class R = typename L::Real>
ZRAKA_INLINE std::uint32_t blocked_in_leaf_of_spheres(const FrozenScene<R>& scene,
                                                      const Bundle<L>& bundle,
                                                      const BundleEntry<R>& entry,
                                                      std::uint32_t rays, const RayGroup<L>& group,
                                                      const R* t) {
  const std::int32_t first = entry.child, count = leaf_count(entry.leaf);
  std::uint32_t one_by_one = 0;
  for (std::size_t r = 0; r < kRegisters<L>; ++r)
    if (const std::uint32_t mine = in_register<L>(rays, r); shapes_in_lanes<L>(mine, entry.leaf))
      one_by_one |= mine;
  std::uint32_t blocked = 0;
  if (rays != one_by_one)
    blocked = blocked_by_each_shape<L>(scene, scene.spheres, first, count, rays & ~one_by_one,
                                       group);
  if (one_by_one != 0)
    blocked |= blocked_ray_by_ray<L>(scene, scene.spheres, first, count, one_by_one, bundle, t);
  return blocked;
}

/// Which of the rays hit a shape of the entry's leaf nearer than their t; `t` has the same as the
/// group.
template <class L, class R = typename L::Real>
ZRAKA_INLINE std::uint32_t blocked_in_leaf(const FrozenScene<R>& scene, const Bundle<L>& bundle,
                                           const BundleEntry<R>& entry, std::uint32_t rays,
                                           const RayGroup<L>& group, const R* t,
                                           LastBlocker& last) {
  if (leaf_kind(entry.leaf) == kKindOfSphere) {
    const std::uint32_t blocked =
        blocked_in_leaf_of_spheres<L>(scene, bundle, entry, rays, group, t);
    if (blocked != 0) last = {entry.child, entry.leaf};
    return blocked;
  }
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
        if (is_shadowless(scene, shapes, entry.child + i)) continue;
        NumbersOf<Shape, L> shape;
        broadcast_shape<L>(shapes, entry.child + i, shape);
        const F distance =
            intersect_shape<true, Shape, L>(shape, ray.origin, ray.direction, ray.t);
        blocked = either(blocked, both(distance > F(0), distance < ray.t));
      }
    });
    blocked_rays |= mine & group_bits<L>(blocked, r);
  }
  if (one_by_one != 0)
    each_ray_in_leaf<true, L>(scene, bundle, entry, one_by_one, t,
                              [&](std::size_t i, std::int32_t first, F distance,
                                  const auto& shapes) {
                                const auto hit = both(distance > F(0), distance < F(t[i]));
                                const auto index = [&](int lane) {
                                  return first - shapes.first_slot + lane;
                                };
                                if (any(hit) &&
                                    that_throw_shadows(scene, shapes, bits(hit), index) != 0)
                                  blocked_rays |= 1u << i;
                              });
  if (blocked_rays != 0) last = {entry.child, entry.leaf};
  return blocked_rays;
}

}  // namespace zraka::ZRAKA_ISA
