// SPDX-License-Identifier: Apache-2.0
// Every ray against every shape: the acceleration structure of small scenes.
#pragma once

#include <algorithm>
#include <iterator>

#include "accel/shadowless.hpp"

namespace zraka::ZRAKA_ISA {

template <class L, class Shape>
ZRAKA_INLINE void nearest_of(const FrozenShapes<typename L::Real, Shape>& shapes,
                             RayLanes<L>& ray) {
  using F = typename L::F;
  for (std::int32_t i = 0; i < shapes.count; ++i) {
    NumbersOf<Shape, L> shape;
    broadcast_shape<L>(shapes, i, shape);
    const F t = intersect_shape<false, Shape, L>(shape, ray.origin, ray.direction, ray.t);
    const auto nearer = both(t > F(0), t < ray.t);
    ray.t = select(nearer, t, ray.t);
    ray.slot = select(nearer, typename L::I(shapes.first_slot + i), ray.slot);
  }
}

#define ZRAKA_KIND_AS_READ(Type, plural) kind_as_read(kKindOf##Type),
inline constexpr std::int32_t kKindsById[] = {ZRAKA_KINDS_BY_ID(ZRAKA_KIND_AS_READ)};
#undef ZRAKA_KIND_AS_READ
static_assert(std::size(kKindsById) == kKinds &&
              std::is_sorted(std::begin(kKindsById), std::end(kKindsById)));

/// The nearest hit of each ray nearer than its t. Shapes are asked in the order of their ids, so
/// that of equal hits the one that was read first stays, as in the hierarchy.
template <class L>
ZRAKA_INLINE void nearest_in_list(const FrozenScene<typename L::Real>& scene, RayLanes<L>& ray) {
#define ZRAKA_NEAREST(Type, plural) nearest_of<L>(scene.plural, ray);
  ZRAKA_KINDS_BY_ID(ZRAKA_NEAREST)
#undef ZRAKA_NEAREST
}

template <class L, class Shape>
ZRAKA_INLINE typename L::M blocked_by(const FrozenScene<typename L::Real>& scene,
                                      const FrozenShapes<typename L::Real, Shape>& shapes,
                                      const RayLanes<L>& ray, typename L::M blocked,
                                      typename L::M wanted) {
  using F = typename L::F;
  for (std::int32_t i = 0; i < shapes.count; ++i) {
    if (is_shadowless(scene, shapes, i)) continue;
    NumbersOf<Shape, L> shape;
    broadcast_shape<L>(shapes, i, shape);
    const F t = intersect_shape<true, Shape, L>(shape, ray.origin, ray.direction, ray.t);
    blocked = either(blocked, both(t > F(0), t < ray.t));
    if (!any(but_not(wanted, blocked))) break;
  }
  return blocked;
}

/// Which of the wanted rays hit anything nearer than their t.
template <class L>
ZRAKA_INLINE typename L::M blocked_in_list(const FrozenScene<typename L::Real>& scene,
                                           const RayLanes<L>& ray, typename L::M wanted) {
  typename L::M blocked = L::first(0);
#define ZRAKA_BLOCKED(Type, plural) \
  blocked = blocked_by<L>(scene, scene.plural, ray, blocked, wanted);
  ZRAKA_KINDS(ZRAKA_BLOCKED)
#undef ZRAKA_BLOCKED
  return both(blocked, wanted);
}

}  // namespace zraka::ZRAKA_ISA
