// SPDX-License-Identifier: Apache-2.0
// What rays find where they hit: point, normal, side and material, by the shape's kind.
#pragma once

#include "accel/ray_lanes.hpp"

namespace zraka::ZRAKA_ISA {

/// The surface of those lanes whose primitive is of this kind; others stay as they are.
template <class L, class Shape>
ZRAKA_INLINE void surface_of(const FrozenShapes<typename L::Real, Shape>& shapes,
                             typename L::I slot, const V3<typename L::F>& origin,
                             const V3<typename L::F>& direction, const V3<typename L::F>& point,
                             SurfacePoint<L>& surface, typename L::I& material) {
  using F = typename L::F;
  using I = typename L::I;
  if (shapes.count == 0) return;
  const auto mine =
      but_not(slot >= I(shapes.first_slot), slot >= I(shapes.first_slot + shapes.count));
  if (!any(mine)) return;
  const I index = select(mine, slot + I(-shapes.first_slot), I(0));
  const std::int32_t one = first_lane(index);
  const bool shared = all(index == I(one));
  F shape[ShapeTraits<Shape>::kReals];
  for (int k = 0; k < ShapeTraits<Shape>::kReals; ++k)
    shape[k] = shared ? F(shapes.column[k][one]) : L::gather(shapes.column[k], index);
  const SurfacePoint<L> found = ShapeLanes<Shape, L>::surface(shape, origin, direction, point);
  const auto pick = [&](const V3<F>& a, const V3<F>& b) {
    return V3<F>{select(mine, a.x, b.x), select(mine, a.y, b.y), select(mine, a.z, b.z)};
  };
  surface.point = pick(found.point, surface.point);
  surface.normal = pick(found.normal, surface.normal);
  surface.offset = select(mine, found.offset, surface.offset);
  surface.inside = either(both(mine, found.inside), but_not(surface.inside, mine));
  material =
      select(mine, shared ? I(shapes.material[one]) : L::gather(shapes.material, index), material);
}

/// Where rays hit the primitives of their slots.
template <class L>
struct Surfaces {
  SurfacePoint<L> at;
  typename L::I material;
};

/// The surfaces of bodies, out of line (accel/bodies.cpp); lanes of other slots stay as they are.
template <class L>
void surfaces_of_bodies(const FrozenShapes<typename L::Real, Body>& bodies, typename L::I slot,
                        const V3<typename L::F>& origin, const V3<typename L::F>& direction,
                        typename L::F t, Surfaces<L>& surfaces);

template <class L, class R = typename L::Real>
ZRAKA_INLINE Surfaces<L> surfaces_at(const FrozenScene<R>& scene, typename L::I slot,
                                     const V3<typename L::F>& origin,
                                     const V3<typename L::F>& direction, typename L::F t) {
  using F = typename L::F;
  const V3<F> point = origin + direction * t;
  Surfaces<L> all{{point, -direction, F(0), L::first(0)}, typename L::I(0)};
#define ZRAKA_SURFACE(Type, plural) \
  surface_of<L>(scene.plural, slot, origin, direction, point, all.at, all.material);
  ZRAKA_INLINED_KINDS(ZRAKA_SURFACE)
#undef ZRAKA_SURFACE
  if (scene.bodies.count > 0)
    surfaces_of_bodies<L>(scene.bodies, slot, origin, direction, t, all);
  return all;
}

}  // namespace zraka::ZRAKA_ISA
