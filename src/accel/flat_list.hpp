// SPDX-License-Identifier: Apache-2.0
// Every ray against every shape: the acceleration structure of small scenes.
#pragma once

#include "math/lanes.hpp"
#include "scene/frozen.hpp"
#include "shapes/shapes.hpp"

namespace zraka::ZRAKA_ISA {

/// Farther than anything: the squares of lengths in the engine's frame stay finite.
template <class R>
inline constexpr R kFarAway = static_cast<R>(0x1p+100);

/// Rays in lanes, and how far they have been found to be free.
template <class L>
struct RayLanes {
  V3<typename L::F> origin, direction;
  typename L::F t;   ///< nearest hit so far
  typename L::I id;  ///< its primitive, -1 for none
};

template <class L, class Shape>
ZRAKA_INLINE void load_shape(const FrozenShapes<typename L::Real, Shape>& shapes, std::int32_t i,
                             typename L::F (&out)[ShapeTraits<Shape>::kReals]) {
  for (int k = 0; k < ShapeTraits<Shape>::kReals; ++k) out[k] = typename L::F(shapes.column[k][i]);
}

template <class L, class Shape>
ZRAKA_INLINE void nearest_of(const FrozenShapes<typename L::Real, Shape>& shapes,
                             RayLanes<L>& ray) {
  using F = typename L::F;
  for (std::int32_t i = 0; i < shapes.count; ++i) {
    F shape[ShapeTraits<Shape>::kReals];
    load_shape<L>(shapes, i, shape);
    const F t = ShapeLanes<Shape, L>::intersect(shape, ray.origin, ray.direction);
    const auto nearer = both(t > F(0), t < ray.t);  // of equals the one with the lowest id
    ray.t = select(nearer, t, ray.t);
    ray.id = select(nearer, typename L::I(shapes.first_id + i), ray.id);
  }
}

/// The nearest hit of each ray nearer than its t.
template <class L>
ZRAKA_INLINE void find_nearest(const FrozenScene<typename L::Real>& scene, RayLanes<L>& ray) {
#define ZRAKA_NEAREST(Type, plural) nearest_of<L>(scene.plural, ray);
  ZRAKA_SHAPES(ZRAKA_NEAREST)
#undef ZRAKA_NEAREST
}

template <class L, class Shape>
ZRAKA_INLINE typename L::M blocked_by(const FrozenShapes<typename L::Real, Shape>& shapes,
                                      const RayLanes<L>& ray, typename L::M blocked,
                                      typename L::M wanted) {
  using F = typename L::F;
  for (std::int32_t i = 0; i < shapes.count; ++i) {
    F shape[ShapeTraits<Shape>::kReals];
    load_shape<L>(shapes, i, shape);
    const F t = ShapeLanes<Shape, L>::intersect(shape, ray.origin, ray.direction);
    blocked = either(blocked, both(t > F(0), t < ray.t));
    if (!any(but_not(wanted, blocked))) break;
  }
  return blocked;
}

/// Which of the wanted rays meet anything nearer than their t.
template <class L>
ZRAKA_INLINE typename L::M find_blocked(const FrozenScene<typename L::Real>& scene,
                                        const RayLanes<L>& ray, typename L::M wanted) {
  typename L::M blocked = but_not(wanted, wanted);
#define ZRAKA_BLOCKED(Type, plural) blocked = blocked_by<L>(scene.plural, ray, blocked, wanted);
  ZRAKA_SHAPES(ZRAKA_BLOCKED)
#undef ZRAKA_BLOCKED
  return both(blocked, wanted);
}

}  // namespace zraka::ZRAKA_ISA
