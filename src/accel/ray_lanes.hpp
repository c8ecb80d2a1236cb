// SPDX-License-Identifier: Apache-2.0
// Rays in lanes, as every acceleration structure takes them.
#pragma once

#include <type_traits>

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
  typename L::F t;     ///< nearest hit so far
  typename L::I slot;  ///< its primitive, -1 for none
};

/// So many registers of rays go through the scene together, up to the 32 rays that an integer has
/// bits for: what they have in common is done once.
template <class L>
inline constexpr std::size_t kRegisters = L::kWidth >= 8 ? 32 / L::kWidth : 1;

/// Rays that go through the scene together, and which of them there are.
template <class L>
struct RayGroup {
  static constexpr std::size_t kRays = kRegisters<L> * L::kWidth;
  static constexpr std::uint32_t kAll =
      static_cast<std::uint32_t>((std::uint64_t{1} << kRays) - 1);  ///< a bit each
  RayLanes<L> ray[kRegisters<L>];
  typename L::M active[kRegisters<L>];

  RayGroup() = default;  // any values
  /// The rays [first, first + kRays) of n, where load(i) gives the rays [i, i + kWidth).
  template <class Load>
  ZRAKA_INLINE RayGroup(std::size_t first, std::size_t n, const Load& load) {
    for (std::size_t r = 0; r < kRegisters<L>; ++r) {
      const std::size_t i = first + r * L::kWidth;
      active[r] = L::first(i < n ? n - i : 0);
      ray[r] = load(i < n ? i : first);
    }
  }
};

/// The shapes that blocked a ray last, as a leaf: what throws a shadow on one point mostly throws
/// it on its neighbours too.
struct LastBlocker {
  std::int32_t child = 0, leaf = 0;
};

/// A register's bits among those of its group.
template <class L>
ZRAKA_INLINE std::uint32_t group_bits(typename L::M lanes, std::size_t r) {
  return bits(lanes) << (r * L::kWidth);
}
/// The lanes of register r whose bits are set in the group's.
template <class L>
ZRAKA_INLINE typename L::M lanes_of(std::uint32_t group, std::size_t r) {
  return L::from_bits(group >> (r * L::kWidth));
}

/// The bits of those of the rays that a register holds.
template <class L>
ZRAKA_INLINE std::uint32_t in_register(std::uint32_t rays, std::size_t r) {
  constexpr std::uint32_t kOne = static_cast<std::uint32_t>((std::uint64_t{1} << L::kWidth) - 1);
  return rays & kOne << (r * L::kWidth);
}

/// Which rays are rays at all: what overflows on its way becomes no number, and hits nothing.
template <class L>
ZRAKA_INLINE typename L::M are_numbers(const RayLanes<L>& ray) {
  const typename L::F zero = (ray.origin.x + ray.origin.y + ray.origin.z + ray.direction.x +
                              ray.direction.y + ray.direction.z) *
                             typename L::F(0);
  return zero == typename L::F(0);
}

/// Calls function(shapes) for the kind of shapes that a number stands for.
template <class R, class Function>
ZRAKA_INLINE void with_kind(const FrozenScene<R>& scene, std::int32_t kind,
                            const Function& function) {
#define ZRAKA_IF(Type, plural) \
  if (kind == kKindOf##Type) return function(scene.plural);
  ZRAKA_KINDS(ZRAKA_IF)
#undef ZRAKA_IF
}

/// The index in the scene as it was read of a slot's primitive.
template <class R>
ZRAKA_INLINE std::int32_t id_of(const FrozenScene<R>& scene, std::int32_t slot) {
#define ZRAKA_IF(Type, plural)                                                         \
  if (const std::int32_t at = slot - scene.plural.first_slot;                          \
      static_cast<std::uint32_t>(at) < static_cast<std::uint32_t>(scene.plural.count)) \
    return scene.plural.id[at];
  ZRAKA_KINDS(ZRAKA_IF)
#undef ZRAKA_IF
  return slot;
}

/// The numbers that intersect() needs, of one shape for all lanes or of a shape for each; of bodies
/// which ones they are.
template <class L>
struct BodiesInLanes {
  const FrozenShapes<typename L::Real, Body>* bodies;
  typename L::I which;
};
template <class Shape, class L>
struct NumbersFor {
  using Type = typename L::F[ShapeTraits<Shape>::kHitReals];
};
template <class L>
struct NumbersFor<Body, L> {
  using Type = BodiesInLanes<L>;
};
template <class Shape, class L>
using NumbersOf = typename NumbersFor<Shape, L>::Type;

/// Bodies are intersected out of line (accel/bodies.cpp): a body for all lanes or a body for each.
template <class L>
typename L::F intersect_bodies(const BodiesInLanes<L>& bodies, const V3<typename L::F>& origin,
                               const V3<typename L::F>& direction, typename L::F limit, bool any);

/// One shape for all lanes.
template <class L, class Shape>
ZRAKA_INLINE void broadcast_shape(const FrozenShapes<typename L::Real, Shape>& shapes,
                                  std::int32_t i, NumbersOf<Shape, L>& out) {
  if constexpr (std::is_same_v<Shape, Body>)
    out = {&shapes, typename L::I(i)};
  else
    for (int k = 0; k < ShapeTraits<Shape>::kHitReals; ++k)
      out[k] = typename L::F(shapes.column[k][i]);
}

/// The shapes [i, i + kWidth), one a lane.
template <class L, class Shape>
ZRAKA_INLINE void load_shapes(const FrozenShapes<typename L::Real, Shape>& shapes, std::int32_t i,
                              NumbersOf<Shape, L>& out) {
  if constexpr (std::is_same_v<Shape, Body>)
    out = {&shapes, L::iota(i)};
  else
    for (int k = 0; k < ShapeTraits<Shape>::kHitReals; ++k) out[k] = L::load(shapes.column[k] + i);
}

/// Distances to the nearest intersections in front of the origins, of rays that look no farther
/// than their limits; 0 or less, or NaN, where there is none, and anything where a limit is not
/// above 0. With kAny, to any intersection that is nearer than the limit.
template <bool kAny, class Shape, class L>
ZRAKA_INLINE typename L::F intersect_shape(const NumbersOf<Shape, L>& shape,
                                           const V3<typename L::F>& origin,
                                           const V3<typename L::F>& direction,
                                           typename L::F limit) {
  if constexpr (std::is_same_v<Shape, Body>)
    return intersect_bodies<L>(shape, origin, direction, limit, kAny);
  else
    return ShapeLanes<Shape, L>::intersect(shape, origin, direction);
}

/// Which rays hit a shape nearer than their limits, and beyond 0. By what intersect_shape() finds,
/// or by what a shape knows of that without finding it.
template <class Shape, class L>
ZRAKA_INLINE typename L::M blocks(const NumbersOf<Shape, L>& shape, const V3<typename L::F>& origin,
                                  const V3<typename L::F>& direction, typename L::F limit) {
  if constexpr (requires { ShapeLanes<Shape, L>::blocks(shape, origin, direction, limit); }) {
    return ShapeLanes<Shape, L>::blocks(shape, origin, direction, limit);
  } else {
    const auto t = intersect_shape<true, Shape, L>(shape, origin, direction, limit);
    return both(t > typename L::F(0), t < limit);
  }
}

/// Rays in lanes hit one shape at these distances, or not at all; a nearer hit, or an equal one of
/// a lower id, replaces theirs.
template <class L, class Shape>
ZRAKA_INLINE void keep_nearer(const FrozenScene<typename L::Real>& scene,
                              const FrozenShapes<typename L::Real, Shape>& shapes, std::int32_t i,
                              typename L::F t, RayLanes<L>& ray) {
  using F = typename L::F;
  auto nearer = both(t > F(0), t <= ray.t);
  if (!any(nearer)) return;
  const auto equal = both(nearer, t >= ray.t);
  if (any(equal)) {
    // Of equal hits the shape that was read first counts, in whatever order they are found.
    const std::int32_t id = shapes.id[i];
    std::int32_t slots[L::kWidth];
    typename L::Real wins[L::kWidth];
    L::store(ray.slot, slots);
    for (std::size_t lane = 0; lane < L::kWidth; ++lane)
      wins[lane] = slots[lane] < 0 || id < id_of(scene, slots[lane]) ? 1 : 0;
    nearer = both(nearer, either(t<ray.t, L::load(wins)> F(0)));
  }
  ray.t = select(nearer, t, ray.t);
  ray.slot = select(nearer, typename L::I(shapes.first_slot + i), ray.slot);
}

/// Tests one shape against the rays in lanes.
template <class L, class Shape>
ZRAKA_INLINE void intersect_one(const FrozenScene<typename L::Real>& scene,
                                const FrozenShapes<typename L::Real, Shape>& shapes, std::int32_t i,
                                RayLanes<L>& ray) {
  NumbersOf<Shape, L> shape;
  broadcast_shape<L>(shapes, i, shape);
  keep_nearer<L>(scene, shapes, i,
                 intersect_shape<false, Shape, L>(shape, ray.origin, ray.direction, ray.t), ray);
}

}  // namespace zraka::ZRAKA_ISA
