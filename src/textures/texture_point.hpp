// SPDX-License-Identifier: Apache-2.0
// Where on a surface a texture is looked up.
#pragma once

#include "math/vec.hpp"

namespace zraka {

/// A hit as textures see it, in the space that its shape is described in. A footprint is the patch
/// of the surface that a pixel, or a ray that comes from one, looks at: the two half axes of an
/// ellipse, the longer one first; both 0 where nobody knows.
struct TexturePoint {
  V3<double> point{};                      ///< in the shape's space
  V3<double> footprint[2]{};               ///< along the surface, in the shape's space
  double u = 0, v = 0;                     ///< of the surface
  double footprint_u[2]{}, footprint_v[2]{};  ///< the same half axes in u and v
};

/// What a texture gives: linear, of a colour or three times a number.
using TextureValue = V3<double>;

}  // namespace zraka
