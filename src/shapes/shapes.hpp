// SPDX-License-Identifier: Apache-2.0
// All shapes' files. The list itself is ZRAKA_SHAPES in include/zraka/shapes.hpp.
#pragma once

#include "shapes/cone.hpp"
#include "shapes/smooth_triangle.hpp"
#include "shapes/sphere.hpp"
#include "shapes/triangle.hpp"

/// X(Type, plural): every kind of shape that the engine knows. A scene's spheres are all of the one
/// kind or all of the other, and so are its cones.
#define ZRAKA_KINDS(X)                \
  ZRAKA_SHAPES(X)                     \
  X(AnchoredSphere, anchored_spheres) \
  X(Cylinder, cylinders)

/// The same kinds in the order of their shapes' ids.
#define ZRAKA_KINDS_BY_ID(X)          \
  X(AnchoredSphere, anchored_spheres) \
  ZRAKA_SHAPES(X)                     \
  X(Cylinder, cylinders)
