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
    const double level = elementary::cos(below);
    ray.origin = in_double(camera.eye);
    ray.direction = normalized(in_double(camera.first) * (level * elementary::cos(longitude)) +
                               in_double(camera.right) * (level * elementary::sin(longitude)) +
                               in_double(camera.down) * elementary::sin(below));
    return true;
  }

  template <class R>
  static CameraCone cone(const FrozenCamera<R>& camera, const PicturePoint& at, const CameraRay&) {
    const double below = camera.angle_down + camera.step_down * at.row;
    return {0, std::sqrt(camera.step_right * camera.step_down * std::fabs(elementary::cos(below)))};
  }
};

}  // namespace zraka
