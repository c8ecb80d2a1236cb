// SPDX-License-Identifier: Apache-2.0
// What every shape's file provides (HACKING.md says how to add one).
#pragma once

#include "math/bounds.hpp"
#include "math/frame.hpp"
#include "math/vec.hpp"
#ifdef ZRAKA_ISA
#include "math/lanes.hpp"
#endif

namespace zraka {

/// Specialised by each shape with
///   kName                          for messages
///   kNouns                         what it is called in English and in Croatian, in the
///                                  nominative, the accusative, the genitive and the locative
///   kReals                         how many numbers the engine needs
///   kHitReals                      how many of these, the first, intersect() needs
///   bounds(shape)                  a box around it, in world space
///   distance_to(shape, point)      how far its surface is from a point, or a lower bound of that
///   check(shape)                   what is wrong with its parameters, or nullptr
///   freeze(shape, frame, out)      the engine's numbers, in the engine's frame
///   frozen_bounds(numbers)         a box around it, of the numbers, in the engine's frame
template <class Shape>
struct ShapeTraits;

#ifdef ZRAKA_ISA
namespace ZRAKA_ISA {

/// Specialised by each shape, over lanes L, with
///   intersect(s, origin, direction)        distance along a unit direction to the nearest
///                                          intersection in front of the origin; 0 or less, or
///                                          NaN, where there is none
///   surface(s, origin, direction, point)   the SurfacePoint of a hit that intersect() found there
/// where s are the shape's numbers, the first kHitReals for intersect() and all of them for
/// surface(): one shape for all lanes, or a shape for each.
template <class Shape, class L>
struct ShapeLanes;

/// How far beyond a shape's exact surface its arithmetic may put a hit: a third of what the boxes
/// of the hierarchy are enlarged by (refer_to() in scene/reorder_by_leaf.cpp), for rays from the
/// eye as for those from within the scene.
template <class L>
ZRAKA_INLINE typename L::F hit_margin(const V3<typename L::F>& origin) {
  using F = typename L::F;
  return F(0x1p-22f) * (F(1.0f) + max(abs(origin.x), max(abs(origin.y), abs(origin.z))));
}

/// A point of a surface in the engine's frame, moved onto the surface as well as its numbers can
/// say.
template <class L>
struct SurfacePoint {
  using F = typename L::F;
  using M = typename L::M;
  V3<F> point;
  V3<F> normal;  ///< unit length, outward
  F offset;      ///< a ray that starts this far along the normal surely starts outside
  M inside;      ///< the ray came from within
  /// Mirrored rays go on behind the surface: a blended normal may lean that far from the face's.
  M behind = L::first(0);
};

}  // namespace ZRAKA_ISA
#endif

}  // namespace zraka
