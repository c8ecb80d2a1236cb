// SPDX-License-Identifier: Apache-2.0
// All round in an equirectangular picture: columns are longitudes from the left of what is behind
// to its right, rows latitudes from straight up to straight down, its middle is straight ahead.
#pragma once

#include "cameras/camera_ray.hpp"

namespace zraka {

struct PanoramaCamera {
  template <class R>
  static bool ray(const FrozenCamera<R>& camera, const PicturePoint& at, CameraRay& ray) {
    const double longitude = camera.angle_right + camera.step_right * at.column;
    const double below = camera.angle_down + camera.step_down * at.row;
    const elementary::SineCosine height = elementary::sine_cosine(below);
    const elementary::SineCosine round = elementary::sine_cosine(longitude);
    const double level = height.cosine;
    ray.origin = in_double(camera.eye);
    ray.direction = normalized(in_double(camera.first) * (level * round.cosine) +
                               in_double(camera.right) * (level * round.sine) +
                               in_double(camera.down) * height.sine);
    ray.shrink = std::fabs(level);
    return true;
  }

  template <class R>
  static CameraCone cone(const FrozenCamera<R>& camera, const PicturePoint&, const CameraRay& ray) {
    return {0, std::sqrt(camera.step_right * camera.step_down * ray.shrink)};
  }
};

}  // namespace zraka
