// SPDX-License-Identifier: Apache-2.0
// What every kind of camera makes.
#pragma once

#include <cmath>

#include "math/vec.hpp"
#include "sampling/warp.hpp"
#include "scene/frozen.hpp"

namespace zraka {

/// A place in the picture, in pixels, (0, 0) being where the first pixel's ray goes; and one on the
/// lens.
struct PicturePoint {
  double column, row;
  Point2 lens;
};

/// In the engine's frame; the direction is a unit vector.
struct CameraRay {
  V3<double> origin, direction;
  double shrink = 1;  ///< of a fisheye or panorama: how much shorter circles are than in the picture
};

/// The cone that holds what a pixel sees: its width where the ray starts, and per unit from there.
struct CameraCone {
  double width, spread;
};

template <class T>
V3<double> in_double(const V3<T>& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

inline V3<double> normalized(const V3<double>& v) {
  return v * (1 / std::sqrt(dot(v, v)));
}

}  // namespace zraka
