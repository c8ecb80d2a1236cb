// SPDX-License-Identifier: Apache-2.0
// What rays find where they hit: point, normal, side and material, by the shape's kind.
#pragma once

#include "accel/ray_lanes.hpp"
#include "engine/hit_path.hpp"

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
  surface.behind = either(both(mine, found.behind), but_not(surface.behind, mine));
  material =
      select(mine, shared ? I(shapes.material[one]) : L::gather(shapes.material, index), material);
}

/// Where rays hit the primitives of their slots.
template <class L>
struct Surfaces {
  SurfacePoint<L> at;
  typename L::I material;
};

/// The surfaces of bodies, out of line (engine/bodies.cpp); lanes of other slots stay as they are.
/// With `paths`, those of the lanes are kept, too.
template <class L>
void surfaces_of_bodies(const FrozenShapes<typename L::Real, Body>& bodies, typename L::I slot,
                        const V3<typename L::F>& origin, const V3<typename L::F>& direction,
                        typename L::F t, Surfaces<L>& surfaces, HitPath* paths);

/// As if all lanes had hit primitives of the scene.
template <class L>
void start_paths(typename L::I slot, HitPath* paths) {
  alignas(64) std::int32_t slots[L::kWidth];
  L::store(slot, slots);
  for (std::size_t i = 0; i < L::kWidth; ++i) {
    paths[i].group = nullptr;
    paths[i].slot = slots[i];
    paths[i].body = -1;
    paths[i].depth = 0;
    for (int k = 0; k < 12; ++k) paths[i].to_frame[k] = k % 4 == 0 && k < 9 ? 1 : 0;
  }
}

/// What the hits of rays are, in all kinds.
template <class L, class R = typename L::Real>
ZRAKA_INLINE Surfaces<L> surfaces_at(const FrozenScene<R>& scene, typename L::I slot,
                                     const V3<typename L::F>& origin,
                                     const V3<typename L::F>& direction, typename L::F t,
                                     HitPath* paths = nullptr) {
  using F = typename L::F;
  const V3<F> point = origin + direction * t;
  Surfaces<L> all{{point, -direction, F(0), L::first(0)}, typename L::I(0)};
#define ZRAKA_SURFACE(Type, plural) \
  surface_of<L>(scene.plural, slot, origin, direction, point, all.at, all.material);
  ZRAKA_INLINED_KINDS(ZRAKA_SURFACE)
#undef ZRAKA_SURFACE
  if (paths != nullptr) start_paths<L>(slot, paths);
  if (scene.bodies.count > 0)
    surfaces_of_bodies<L>(scene.bodies, slot, origin, direction, t, all, paths);
  return all;
}

}  // namespace zraka::ZRAKA_ISA
