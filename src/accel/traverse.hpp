// SPDX-License-Identifier: Apache-2.0
// Through the scene, a group of rays at a time: in the hierarchy they go down together, and each
// child is visited by those that hit its box.
#pragma once

#include "accel/flat_list.hpp"
#include "accel/leaf.hpp"
#include "accel/plane_rays.hpp"

namespace zraka::ZRAKA_ISA {

/// Leaves out the rays that are no rays, and puts an end before all others that are not active:
/// these hit nothing. Returns the bits of those that are left.
template <class L>
ZRAKA_INLINE std::uint32_t start(RayGroup<L>& rays) {
  std::uint32_t active = 0;
  for (std::size_t r = 0; r < kRegisters<L>; ++r) {
    rays.active[r] = both(rays.active[r], are_numbers<L>(rays.ray[r]));
    rays.ray[r].t = select(rays.active[r], rays.ray[r].t, typename L::F(-1));
    active |= group_bits<L>(rays.active[r], r);
  }
  return active;
}

/// The greatest t of a group.
template <class L>
ZRAKA_INLINE typename L::Real farthest_of(const RayGroup<L>& rays) {
  typename L::F farthest = rays.ray[0].t;
  for (std::size_t r = 1; r < kRegisters<L>; ++r) farthest = max(farthest, rays.ray[r].t);
  return max_of(farthest);
}

/// The nearest hit of each active ray nearer than its t.
template <class L, class R = typename L::Real>
void nearest_in_hierarchy(const FrozenScene<R>& scene, RayGroup<L>& rays) {
  const std::uint32_t active = start(rays);
  const Bundle<L> bundle(rays, active == RayGroup<L>::kAll);
  Nearest<L> nearest;
  for (std::size_t r = 0; r < kRegisters<L>; ++r) nearest.take(rays.ray[r], r);
  Pairs<L> pairs;
  R farthest = farthest_of(rays);
  OrderedStack<L> stack;
  stack.push({0, 0, 0, active});
  while (!stack.empty()) {
    const BundleEntry<R> entry = stack.pop();
    if (entry.t > farthest) continue;
    bool changed = false;
    std::uint32_t kinds = 0;  // with pairs enough for a register
    if (entry.leaf == 0)
      kinds = bundle.push_children(scene.hierarchy.nodes[entry.child], entry.rays, nearest.t,
                                   farthest, stack, pairs);
    else if (better_as_pairs<L>(entry.rays, leaf_count(entry.leaf)))
      kinds = pairs.add_leaf(entry.rays, entry.child, entry.leaf);
    else
      changed = nearest_in_leaf<L>(scene, bundle, entry, rays, nearest);
    if (kinds != 0)
      changed = nearest_of_pairs<L>(scene, bundle, pairs, kinds, false, rays, nearest);
    if (changed) farthest = farthest_of(rays);
  }
  nearest_of_pairs<L>(scene, bundle, pairs, pairs.kAllKinds, true, rays, nearest);
  nearest.give(rays);
}

/// A body that has blocked none of a group is not asked first by the next: it takes long, and where
/// the shadow has ended it is asked for nothing.
template <class R>
ZRAKA_INLINE void forget_body(const BundleEntry<R>& entry, LastBlocker& last) {
  if (leaf_kind(entry.leaf) == kKindOfBody && entry.leaf == last.leaf && entry.child == last.child)
    last = {};
}

/// Which of the active rays hit anything nearer than their t, a bit each. Their t is lost.
template <class L, class R = typename L::Real>
std::uint32_t blocked_in_hierarchy(const FrozenScene<R>& scene, LastBlocker& last,
                                   RayGroup<L>& rays) {
  const std::uint32_t active = start(rays);
  const Bundle<L> bundle(rays, active == RayGroup<L>::kAll);
  alignas(64) R t[RayGroup<L>::kRays];
  for (std::size_t r = 0; r < kRegisters<L>; ++r) L::store(rays.ray[r].t, t + r * L::kWidth);
  Pairs<L> pairs;
  std::uint32_t left = active;
  R farthest = farthest_of(rays);
  UnorderedStack<L> stack;
  stack.push({0, 0, 0, left});
  if (last.leaf != 0) stack.push({0, last.child, last.leaf, left});
  // An entry is taken before the one in front of it has put its children on the stack: so the
  // processor knows where to go on, and begins with it meanwhile. No order counts here.
  BundleEntry<R> ahead = stack.pop();
  while (left != 0) {
    const BundleEntry<R> entry = ahead;
    ahead = stack.pop_if_any();
    const std::uint32_t asking = entry.rays & left;
    if (asking == 0) {
      if (ahead.rays == 0) break;
      continue;
    }
    std::uint32_t blocked = 0, kinds = 0;
    if (entry.leaf == 0)
      kinds = bundle.push_children(scene.hierarchy.nodes[entry.child], asking, t, farthest, stack,
                                   pairs);
    else if (better_as_pairs<L>(asking, leaf_count(entry.leaf)))
      kinds = pairs.add_leaf(asking, entry.child, entry.leaf);
    else
      blocked = blocked_in_leaf<L>(scene, bundle, entry, asking, rays, t, last);
    if (blocked == 0 && entry.leaf != 0) forget_body(entry, last);
    if (kinds != 0) blocked = blocked_by_pairs<L>(scene, bundle, t, pairs, kinds, false, last);
    blocked &= left;
    if (blocked == 0) continue;
    left &= ~blocked;
    for (std::size_t r = 0; r < kRegisters<L>; ++r) {
      rays.ray[r].t = select(lanes_of<L>(blocked, r), typename L::F(-1), rays.ray[r].t);
      L::store(rays.ray[r].t, t + r * L::kWidth);
    }
    farthest = farthest_of(rays);
  }
  if (left != 0) left &= ~blocked_by_pairs<L>(scene, bundle, t, pairs, pairs.kAllKinds, true, last);
  return active & ~left;
}

/// The nearest hit of each active ray among the bodies that have no bounds.
template <class L>
void nearest_outside_hierarchy(const FrozenScene<typename L::Real>& scene, RayGroup<L>& rays) {
  for (RayLanes<L>& ray : rays.ray)
    for (std::int32_t i = scene.bodies.bounded; i < scene.bodies.count; ++i)
      keep_nearer<L>(scene, scene.bodies, i, intersect_unbounded<false, L>(scene.bodies, i, ray),
                     ray);
}

/// Which of the active rays hit one of the bodies that have no bounds nearer than their t: these
/// are not active any more.
template <class L>
std::uint32_t blocked_outside_hierarchy(const FrozenScene<typename L::Real>& scene,
                                        RayGroup<L>& rays) {
  using F = typename L::F;
  std::uint32_t blocked = 0;
  for (std::size_t r = 0; r < kRegisters<L>; ++r) {
    const RayLanes<L>& ray = rays.ray[r];
    typename L::M by_any = L::first(0);
    for (std::int32_t i = scene.bodies.bounded; i < scene.bodies.count; ++i) {
      if (is_shadowless(scene, scene.bodies, i)) continue;
      const F t = intersect_unbounded<true, L>(scene.bodies, i, ray);
      by_any = either(by_any, both(t > F(0), t < ray.t));
    }
    by_any = both(by_any, rays.active[r]);
    blocked |= group_bits<L>(by_any, r);
    rays.active[r] = but_not(rays.active[r], by_any);
  }
  return blocked;
}

/// The nearest hit of each active ray nearer than its t, by whichever structure the scene has.
template <class L>
ZRAKA_INLINE void find_nearest(const FrozenScene<typename L::Real>& scene, RayGroup<L>& rays) {
  if (scene.hierarchy.nodes != nullptr) {
    if (scene.bodies.bounded < scene.bodies.count) nearest_outside_hierarchy<L>(scene, rays);
    return nearest_in_hierarchy<L>(scene, rays);
  }
  for (std::size_t r = 0; r < kRegisters<L>; ++r) {
    if (!any(rays.active[r])) continue;
    RayLanes<L> ray = rays.ray[r];  // a copy that nothing else can know of stays in registers
    nearest_in_list<L>(scene, ray);
    rays.ray[r] = ray;
  }
}

/// Which of the active rays hit anything nearer than their t, a bit each, by whichever structure
/// the scene has. Their t is lost.
template <class L>
ZRAKA_INLINE std::uint32_t find_blocked(const FrozenScene<typename L::Real>& scene,
                                        LastBlocker& last, RayGroup<L>& rays) {
  if (scene.hierarchy.nodes != nullptr) {
    std::uint32_t outside = 0;
    if (scene.bodies.bounded < scene.bodies.count)
      outside = blocked_outside_hierarchy<L>(scene, rays);
    return outside | blocked_in_hierarchy<L>(scene, last, rays);
  }
  std::uint32_t blocked = 0;
  for (std::size_t r = 0; r < kRegisters<L>; ++r) {
    if (!any(rays.active[r])) continue;
    const RayLanes<L> ray = rays.ray[r];
    blocked |= group_bits<L>(blocked_in_list<L>(scene, ray, rays.active[r]), r);
  }
  return blocked;
}

}  // namespace zraka::ZRAKA_ISA
