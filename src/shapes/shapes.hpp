// SPDX-License-Identifier: Apache-2.0
// All shapes' files. The list itself is ZRAKA_SHAPES in include/zraka/shapes.hpp.
#pragma once

#include "shapes/bodies.hpp"
#include "shapes/cone.hpp"
#include "shapes/smooth_triangle.hpp"
#include "shapes/sphere.hpp"
#include "shapes/triangle.hpp"

/// X(Type, plural): every kind of shape that is inlined in the engine. A scene's spheres are all of
/// the one kind or all of the other, and so are its cones.
#define ZRAKA_INLINED_KINDS(X)        \
  ZRAKA_PRIMITIVES(X)                 \
  X(AnchoredSphere, anchored_spheres) \
  X(Cylinder, cylinders)

/// Every kind of shape that the hierarchy knows: bodies of all types are one.
#define ZRAKA_KINDS(X)   \
  ZRAKA_INLINED_KINDS(X) \
  X(Body, bodies)

/// The same kinds in the order of their shapes' ids.
#define ZRAKA_KINDS_BY_ID(X)          \
  X(AnchoredSphere, anchored_spheres) \
  ZRAKA_PRIMITIVES(X)                 \
  X(Cylinder, cylinders)              \
  X(Body, bodies)
