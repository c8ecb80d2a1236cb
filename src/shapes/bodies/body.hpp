// SPDX-License-Identifier: Apache-2.0
// What every body's file provides (HACKING.md says how to add one).
//
// A body's formulas are in its own space, where its middle is the origin and its size about 1: a
// sphere there is the unit sphere, whatever ellipsoid it is in the world. They are computed in
// double, and a ray comes to them from where it is nearest the middle: so they lose next to
// nothing, wherever the ray began.
#pragma once

#include <zraka/bodies.hpp>

#include "shapes/shape.hpp"
#ifdef ZRAKA_ISA
#include "math/double_lanes.hpp"
#endif

namespace zraka {

/// At most so many numbers does a body have besides its placement.
inline constexpr int kMostBodyNumbers = 20;

/// From a body's own space into that which it is described in, and what its formulas need besides.
struct Placement {
  Transform from_own;
  double numbers[kMostBodyNumbers] = {};
};

/// A point of a body's surface, in its own space.
struct BodySurface {
  V3<double> normal;  ///< outwards, of any length
  double u = 0, v = 0;
  /// How the point moves with u and with v, for bent normals.
  V3<double> along_u{1, 0, 0}, along_v{0, 1, 0};
  bool v_ends = false;   ///< v goes from one end to another, and not round
};

/// ShapeTraits of a body has, in the space that it is described in,
///   kName, bounds(shape), distance_to(shape, point), check(shape)    as of every shape; bounds
///                                of what is unbounded are infinite
///   kNouns                       what people call it, in English and in Croatian: nominative,
///                                accusative, genitive, locative
///   kClosed                      whether it has an inside
///   check_member(shape)          where not all of them have one: nullptr, or why this one has none
///                                and so can be no member of CSG
///   bounds_under(shape, t)       where it is tighter than around the box of bounds(shape): a box
///                                around its image under an affine map
///   kComposed                    whether it is made of other shapes (csg.hpp, instance.hpp), and
///                                has none of what follows
///   kNumbers                     how many of Placement's numbers it needs
///   place(shape)                 its Placement
///   surface(numbers, point)      the BodySurface nearest to a point of its own space
///   kCurvature                   where it has any that counts: 1 over its least radius there,
///                                roughly, which says how much it spreads what it mirrors

#ifdef ZRAKA_ISA
namespace ZRAKA_ISA {

inline constexpr double kNever = __builtin_huge_val();

/// A ray in a body's own space: a unit direction, and as its origin the point of the ray that is
/// nearest to the body's middle.
template <class F>
struct BodyRay {
  V3<F> origin, direction;
  F begin;          ///< where along it the ray itself begins
  bool first_only;  ///< no crossing counts but the first after `begin`
  /// Where it ends, give or take `about`; of bodies with kAsksForEnd. With first_only no crossing
  /// counts after it, and with `any` one between begin and end is as good as another.
  F end{kNever}, about{0.0};
  bool any = false;
  /// Where all crossings are asked for: those before it may be anywhere as long as they stay there,
  /// and those after the end, too.
  F from{-kNever};
};

/// Specialised by each body, over double lanes D, with
///   kMost                        how many crossings a ray may have with it at most, 1 or more
///   cross(numbers, ray, at)      sets at[0…kMost) to the distances, forwards and backwards, at
///                                which the ray crosses it, ascending, kNever where there are no
///                                more. Of a closed body at[0] and at[1], at[2] and at[3]… are
///                                where it goes in and comes out; -kNever where a ray has been
///                                inside forever. With ray.first_only all but the first
///                                after ray.begin may be left out, or be anywhere as long as
///                                they stay on their side of it; that one keeps its parity
///   kAsksForEnd                  where it spares work to know ray.end, ray.about and ray.any
///   normal(numbers, p)           where it can be told in lanes: the normal that surface() gives
///                                a point, of the same bits
/// where numbers(k) is the number k of its Placement in lanes.
template <class Shape, class D>
struct BodyLanes;

}  // namespace ZRAKA_ISA
#endif

/// Vec3 as a vector that can be computed with, and back.
inline V3<double> vector_of(const Vec3& v) {
  return {v.x, v.y, v.z};
}
inline Vec3 vec3_of(const V3<double>& v) {
  return {v.x, v.y, v.z};
}

}  // namespace zraka
