// SPDX-License-Identifier: Apache-2.0
// The equidistant fisheye: the angle to the view is the distance from the picture's middle times
// the angle of a pixel. Farther than 180° there is nothing to see.
#pragma once

#include "cameras/camera_ray.hpp"

namespace zraka {

struct FisheyeCamera {
  template <class R>
  static double angle(const FrozenCamera<R>& camera, const PicturePoint& at, double& x, double& y) {
    x = camera.angle_right + camera.step_right * at.column;
    y = camera.angle_down + camera.step_down * at.row;
    return std::sqrt(x * x + y * y);
  }

  template <class R>
  static bool ray(const FrozenCamera<R>& camera, const PicturePoint& at, CameraRay& ray) {
    constexpr double kHalfTurn = 3.14159265358979323846;
    double x = 0, y = 0;
    const double away = angle(camera, at, x, y);
    if (away > kHalfTurn) return false;
    const elementary::SineCosine of = elementary::sine_cosine(away);
    const double aside = away > 0 ? of.sine / away : 1;
    ray.origin = in_double(camera.eye);
    ray.direction =
        normalized(in_double(camera.first) * of.cosine + in_double(camera.right) * (x * aside) +
                   in_double(camera.down) * (y * aside));
    ray.shrink = away > 0 ? std::fmax(0.0, of.sine) / away : 1;
    return true;
  }

  /// As wide along the radius everywhere; across it circles are as long as their angle's sine.
  template <class R>
  static CameraCone cone(const FrozenCamera<R>& camera, const PicturePoint&, const CameraRay& ray) {
    return {0, camera.step_down * std::sqrt(ray.shrink)};
  }
};

}  // namespace zraka
