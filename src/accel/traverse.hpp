// SPDX-License-Identifier: Apache-2.0
// Through the hierarchy, sixteen rays at a time: they go down together, and each child is visited
// by those that meet its box.
#pragma once

#include "accel/flat_list.hpp"
#include "accel/leaf.hpp"

namespace zraka::ZRAKA_ISA {

/// The nearest hit of each active ray nearer than its t.
template <class L, class R = typename L::Real>
void nearest_in_hierarchy(const FrozenScene<R>& scene, typename L::M active, RayLanes<L>& ray) {
  active = both(active, are_numbers<L>(ray));
  const Bundle<L> bundle(ray, active);
  // Lanes that are not active meet nothing.
  ray.t = select(active, ray.t, typename L::F(-1));
  Nearest<L> nearest;
  nearest.take(ray);
  R farthest = max_of(ray.t);
  BundleStack<L> stack;
  stack.push({0, 0, 0, bits(active)});
  while (!stack.empty()) {
    const BundleEntry<R> entry = stack.pop();
    if (entry.t > farthest) continue;
    if (entry.leaf == 0) {
      const int before = stack.size();
      bundle.push_children(scene.hierarchy.nodes[entry.child], entry.rays, nearest.t, farthest,
                           stack);
      stack.sort_from(before);
    } else if (nearest_in_leaf<L>(scene, bundle, entry, ray, nearest)) {
      farthest = max_of(ray.t);
    }
  }
}

/// The leaf that blocked a ray last: what throws a shadow on one point mostly throws it on its
/// neighbours too.
struct LastBlocker {
  std::int32_t child = 0, leaf = 0;
};

/// Which of the wanted rays meet anything nearer than their t.
template <class L, class R = typename L::Real>
typename L::M blocked_in_hierarchy(const FrozenScene<R>& scene, typename L::M wanted,
                                   LastBlocker& last, RayLanes<L> ray) {
  using F = typename L::F;
  wanted = both(wanted, are_numbers<L>(ray));
  const Bundle<L> bundle(ray, wanted);
  ray.t = select(wanted, ray.t, F(-1));
  alignas(64) R t[L::kWidth];
  L::store(ray.t, t);
  std::uint32_t left = bits(wanted);
  R farthest = max_of(ray.t);
  BundleStack<L> stack;
  stack.push({0, 0, 0, left});
  if (last.leaf != 0) stack.push({0, last.child, last.leaf, left});
  while (!stack.empty() && left != 0) {
    const BundleEntry<R> entry = stack.pop();
    const std::uint32_t rays = entry.rays & left;
    if (rays == 0) continue;
    if (entry.leaf == 0) {
      bundle.push_children(scene.hierarchy.nodes[entry.child], rays, t, farthest, stack);
      continue;
    }
    const std::uint32_t blocked = blocked_in_leaf<L>(scene, bundle, entry, rays, ray, t);
    if (blocked == 0) continue;
    last = {entry.child, entry.leaf};
    left &= ~blocked;
    ray.t = select(L::from_bits(blocked), F(-1), ray.t);
    L::store(ray.t, t);
    farthest = max_of(ray.t);
  }
  return but_not(wanted, L::from_bits(left));
}

/// The nearest hit of each active ray nearer than its t, by whichever structure the scene has.
template <class L>
ZRAKA_INLINE void find_nearest(const FrozenScene<typename L::Real>& scene, typename L::M active,
                               RayLanes<L>& ray) {
  if (scene.hierarchy.nodes == nullptr)
    nearest_in_list<L>(scene, ray);
  else
    nearest_in_hierarchy<L>(scene, active, ray);
}

/// Which of the wanted rays meet anything nearer than their t, by whichever structure the scene
/// has.
template <class L>
ZRAKA_INLINE typename L::M find_blocked(const FrozenScene<typename L::Real>& scene,
                                        typename L::M wanted, LastBlocker& last,
                                        const RayLanes<L>& ray) {
  if (scene.hierarchy.nodes == nullptr) return blocked_in_list<L>(scene, ray, wanted);
  return blocked_in_hierarchy<L>(scene, wanted, last, ray);
}

}  // namespace zraka::ZRAKA_ISA
