// SPDX-License-Identifier: Apache-2.0
// The list of shapes. Primitives are in world space, a struct of parameters each; what they can do
// stands in src/shapes/NAME.hpp. Bodies are in bodies.hpp. Storage, dispatch and tests are derived
// from ZRAKA_SHAPES.
#pragma once

#include <zraka/bodies.hpp>
#include <zraka/values.hpp>

namespace zraka {

struct Sphere {
  Vec3 center;
  double radius = 1;  ///< greater than 0
};

/// Flat; seen from both sides.
struct Triangle {
  Vec3 a, b, c;
};

/// A triangle whose normal is blended from its corners' (Phong 1975), as patches of curved surfaces
/// have them. The normals need not have unit length; which side they point to tells outside.
struct SmoothTriangle {
  Vec3 a, b, c;
  Vec3 normal_a, normal_b, normal_c;
};

/// The side of a cone, a frustum or a cylinder, without its caps; seen from both sides.
struct Cone {
  Vec3 base;
  double base_radius = 1;  ///< 0 or more, one of the two more
  Vec3 apex;
  double apex_radius = 0;
};

}  // namespace zraka

/// X(Type, plural): every primitive, in the order of their ids.
#define ZRAKA_PRIMITIVES(X)           \
  X(Sphere, spheres)                  \
  X(Triangle, triangles)              \
  X(SmoothTriangle, smooth_triangles) \
  X(Cone, cones)

/// X(Type, plural): every shape, in the order of their ids.
#define ZRAKA_SHAPES(X) \
  ZRAKA_PRIMITIVES(X)   \
  ZRAKA_BODIES(X)
