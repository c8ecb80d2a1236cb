// SPDX-License-Identifier: Apache-2.0
// Through the hierarchy: rays go down together as far as they meet the same boxes, and alone from
// there on (Benthin, Wald, Woop, Ernst and Mark, "Combining single and packet-ray tracing for
// arbitrary ray distributions", 2012).
#pragma once

#include "accel/bundle.hpp"
#include "accel/flat_list.hpp"
#include "accel/single_ray.hpp"

namespace zraka::ZRAKA_ISA {

/// So few rays of a bundle go on one by one.
template <class L>
inline constexpr int kFewRays = L::kWidth >= 16  ? 3
                                : L::kWidth >= 8 ? 2
                                                 : 1;

/// Calls function(lane) for each lane whose bit is set.
template <class Function>
ZRAKA_INLINE void each_lane(std::uint32_t lanes, const Function& function) {
  for (; lanes != 0; lanes &= lanes - 1) function(static_cast<std::size_t>(__builtin_ctz(lanes)));
}

/// The nearest hit of each active ray nearer than its t.
template <class L, class R = typename L::Real>
void nearest_in_hierarchy(const FrozenScene<R>& scene, typename L::M active, RayLanes<L>& ray) {
  active = both(active, are_numbers<L>(ray));
  const Bundle<L> bundle(ray, active);
  // Lanes that are not active meet nothing.
  ray.t = select(active, ray.t, typename L::F(-1));
  alignas(64) R t[L::kWidth];
  alignas(64) std::int32_t slot[L::kWidth];
  L::store(ray.t, t);
  L::store(ray.slot, slot);
  R farthest = max_of(ray.t);
  BundleStack<L> stack;
  stack.push({0, 0, 0, bits(active)});
  while (!stack.empty()) {
    const BundleEntry<R> entry = stack.pop();
    if (entry.t > farthest) continue;
    const int count = __builtin_popcount(entry.rays);
    const bool few = count <= kFewRays<L>;
    if (!few && entry.leaf == 0) {
      bundle.push_children(scene.hierarchy.nodes[entry.child], entry.rays, ray.t, farthest, true,
                           stack);
    } else if (few || count < leaf_count(entry.leaf)) {
      bool changed = false;
      each_lane(entry.rays, [&](std::size_t i) {
        const std::int32_t before = slot[i];
        if (entry.leaf == 0)
          nearest_of_one<L>(scene, bundle.single(i), entry.child, t[i], slot[i]);
        else
          nearest_in_leaf<L>(scene, bundle.single(i), entry.child, entry.leaf, t[i], slot[i]);
        changed = changed || slot[i] != before;
      });
      if (!changed) continue;
      ray.t = L::load(t);
      ray.slot = L::load(slot);
      farthest = max_of(ray.t);
    } else {
      const typename L::I before = ray.slot;
      with_kind(scene, leaf_kind(entry.leaf),
                [&]<class Shape>(const FrozenShapes<R, Shape>& shapes) {
                  for (std::int32_t i = 0; i < leaf_count(entry.leaf); ++i)
                    meet<L>(scene, shapes, entry.child + i, ray);
                });
      if (all(ray.slot == before)) continue;
      L::store(ray.t, t);
      L::store(ray.slot, slot);
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
    const std::uint32_t before = left;
    const int count = __builtin_popcount(rays);
    const bool few = count <= kFewRays<L>;
    if (!few && entry.leaf == 0) {
      bundle.push_children(scene.hierarchy.nodes[entry.child], rays, ray.t, farthest, false, stack);
      continue;
    }
    if (few || count < leaf_count(entry.leaf)) {
      each_lane(rays, [&](std::size_t i) {
        const bool blocked =
            entry.leaf == 0
                ? one_is_blocked<L>(scene, bundle.single(i), entry.child, t[i])
                : blocked_in_leaf<L>(scene, bundle.single(i), entry.child, entry.leaf, t[i]);
        if (blocked) left &= ~(1u << i);
      });
    } else {
      with_kind(
          scene, leaf_kind(entry.leaf), [&]<class Shape>(const FrozenShapes<R, Shape>& shapes) {
            typename L::M blocked = L::first(0);
            for (std::int32_t i = 0; i < leaf_count(entry.leaf); ++i) {
              F shape[ShapeTraits<Shape>::kHitReals];
              broadcast_shape<L>(shapes, entry.child + i, shape);
              const F distance = ShapeLanes<Shape, L>::intersect(shape, ray.origin, ray.direction);
              blocked = either(blocked, both(distance > F(0), distance < ray.t));
            }
            left &= ~bits(blocked);
          });
    }
    if (left != before) {
      if (entry.leaf != 0) last = {entry.child, entry.leaf};
      each_lane(before & ~left, [&](std::size_t i) { t[i] = -1; });
      ray.t = L::load(t);
      farthest = max_of(ray.t);
    }
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
