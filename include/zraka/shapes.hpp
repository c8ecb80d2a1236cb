// SPDX-License-Identifier: Apache-2.0
// The list of shapes: one struct of parameters each, in world space. Storage, dispatch and tests
// are derived from ZRAKA_SHAPES; what a shape can do stands in src/shapes/NAME.hpp.
#pragma once

#include <zraka/values.hpp>

namespace zraka {

struct Sphere {
  Vec3 center;
  double radius = 1;  ///< greater than 0
};

}  // namespace zraka

/// X(type, plural): every shape, in the order of primitive ids.
#define ZRAKA_SHAPES(X) X(Sphere, spheres)
