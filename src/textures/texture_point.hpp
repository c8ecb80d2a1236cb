// SPDX-License-Identifier: Apache-2.0
// Where on a surface a texture is looked up.
#pragma once

#include "math/vec.hpp"

namespace zraka {

/// A hit as textures see it, in the space that its shape is described in. A footprint is the patch
/// of the surface that a pixel, or a ray that comes from one, looks at: two half axes of an
/// ellipse, each from the patch's middle to its edge, half a pixel; both 0 where nobody knows.
struct TexturePoint {
  V3<double> point{};                         ///< in the shape's space
  V3<double> footprint[2]{};                  ///< along the surface, in the shape's space
  double u = 0, v = 0;                        ///< of the surface
  double footprint_u[2]{}, footprint_v[2]{};  ///< the same half axes in u and v
  /// How far rounding may have moved the point: what lies so close below a face between two cells
  /// counts to the cell above, so that a wall that stands on such a face is no salt and pepper.
  double error = 0;
  double distance = 0;  ///< of the way from the eye, over all mirrors, in the scene's unit
  /// v goes from 0 to 1 and not round, as on a sphere: images that fit do not repeat at its ends.
  bool v_ends = false;
};

/// What a texture gives: linear, of a colour or three times a number.
using TextureValue = V3<double>;

}  // namespace zraka
