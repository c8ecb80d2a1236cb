// SPDX-License-Identifier: Apache-2.0
// The scene as the engine reads it: plain numbers in the engine's frame (math/frame.hpp), nothing
// that owns memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <zraka/cameras.hpp>

#include "math/vec.hpp"
#include "scene/frozen_bodies.hpp"
#include "scene/frozen_optics.hpp"
#include "scene/frozen_textures.hpp"
#include "scene/hierarchy.hpp"
#include "shapes/shapes.hpp"

namespace zraka {

/// A material as rows of kMaterialReals numbers; the names of the columns follow.
enum MaterialColumn {
  kAmbient = 0,    // ka, three numbers
  kDiffuse = 3,    // kd
  kSpecular = 6,   // ks
  kShininess = 9,  // n
  kReflection,     // k1
  kRefraction,     // k2
  kRatioIn,        // n1/n2 where a ray enters
  kRatioOut,       // n1/n2 where a ray leaves
  kBlinn,          // 1 where the highlight is Blinn's, 0 where it is Phong's
  kMaterialReals = 16
};

/// What distance and a spot's cone leave of a light: 1/(c + l·d + q·d²), and from 1 at the inner
/// angle to 0 at the outer one. Angles from the axis are in chords of the unit sphere, whose squares
/// are 2 - 2·cos: floats have those of narrow cones, too.
template <class R>
struct FrozenFading {
  bool any;                        ///< the rest is not set where there is none
  R constant, linear, quadratic;  ///< by lengths of the engine's frame
  bool has_cone, linear_edge;
  V3<R> axis;                     ///< unit length, of travel
  R inner_square, outer_square;   ///< squared chords
  R outer;                        ///< radians, where the edge is linear
  R slope;  ///< 1 by the edge's width: by squared chords, or where it is linear by radians
};

template <class R>
struct FrozenLight {
  V3<R> position;
  V3<R> color;
  FrozenFading<R> fading;
};

/// What src/cameras/ makes rays of; what a kind does not need is 0.
template <class R>
struct FrozenCamera {
  V3<R> eye;
  /// pinhole: pixel (column, row) looks along first + right·column + down·row, not normalised.
  /// orthographic: its ray starts there, from the eye on. fisheye, panorama: unit vectors, `first`
  /// straight ahead.
  V3<R> first, right, down;
  CameraKind kind;
  /// pinhole: the lens' axes, as long as its radius; so many times first + right·column +
  /// down·row is in focus.
  V3<R> lens_right, lens_down;
  double focus;
  V3<R> ahead;  ///< orthographic: unit direction of all rays
  /// fisheye, panorama: angles to the right and down of pixel (0, 0), and from pixel to pixel.
  double angle_right, angle_down, step_right, step_down;
  R beyond;  ///< no coordinate of a ray's origin is farther off than the eye's and so much

  bool has_lens() const {
    return lens_right.x != R(0) || lens_right.y != R(0) || lens_right.z != R(0);
  }
  /// A ray from the eye through each point of the window, which is all that trace_tile() knows.
  bool is_plain() const { return kind == CameraKind::pinhole && !has_lens(); }
};

/// Number of each kind of shape, in the order of the list.
enum Kind : std::int32_t {
#define ZRAKA_KIND(Type, plural) kKindOf##Type,
  ZRAKA_KINDS(ZRAKA_KIND)
#undef ZRAKA_KIND
      kKinds
};
static_assert(kKinds <= kMostKinds);

/// The kind in the list of shapes.
constexpr std::int32_t kind_as_read(std::int32_t kind) {
  return kind == kKindOfAnchoredSphere ? kKindOfSphere
         : kind == kKindOfCylinder     ? kKindOfCone
                                       : kind;
}

/// Columns have room for reads of this many values past their end.
inline constexpr std::size_t kColumnPadding = 16;

/// The shapes of one kind, in the order of the hierarchy's leaves: each of its numbers in an array
/// of its own.
template <class R, class Shape>
struct FrozenShapes {
  const R* column[ShapeTraits<Shape>::kReals];
  /// The numbers that intersect() needs once more, shape by shape, kRowReals for each: for lanes
  /// that hold a shape each. nullptr where there is no hierarchy, in large scenes, and in the
  /// oracle's.
  const R* rows;
  static constexpr std::int32_t kRowReals = (ShapeTraits<Shape>::kHitReals + 3) / 4 * 4;
  const std::int32_t* material;
  const std::int32_t* id;  ///< index in the scene as it was read, counted over all kinds; of equal
                           ///< hits the least wins
  std::int32_t count;
  /// Slots number the primitives of all kinds in the order of these arrays.
  std::int32_t first_slot;
  std::int32_t first_id;  ///< the least id
  FrozenMapping mapping;
};

template <class R>
struct FrozenScene;

template <class R>
struct FrozenShapes<R, Body> : FrozenBodies {
  const FrozenScene<R>* groups;  ///< that instances name: shapes and hierarchy, each in its own frame
};

template <class R>
struct FrozenScene {
  FrozenCamera<R> camera;
  R reach;  ///< at least as large as all coordinates of shapes, and as 1
  V3<R> background;
  V3<R> ambient_light;
  const FrozenLight<R>* lights;
  std::int32_t light_count;
  const R* materials;  ///< rows of kMaterialReals
  /// By material, 1 where shadow rays go through its shapes. nullptr: nowhere, or the general engine
  /// traces them, which knows of it by itself.
  const std::uint8_t* shadowless;
  const FrozenTextures* textures;  ///< nullptr: no material has any
  const FrozenOptics* optics;      ///< nullptr: there is nothing but what the lab has
  double frame_scale;              ///< the frame that all of this is in
  Vec3 frame_center;
#define ZRAKA_STORE(Type, plural) FrozenShapes<R, Type> plural;
  ZRAKA_KINDS(ZRAKA_STORE)
#undef ZRAKA_STORE
  Hierarchy hierarchy;
  /// For shadow rays of the general engine: the same, where they go through all shapes that they may
  /// pass; and where they meet only those of these that take something of their light, in scenes with
  /// cuts all that do. nullptr: there are none such, or they are parts of wholes.
  const FrozenScene *opaque, *filtering;
};

}  // namespace zraka
