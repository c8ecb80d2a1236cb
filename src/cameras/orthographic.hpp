// SPDX-License-Identifier: Apache-2.0
// Parallel rays from the points of a window whose middle is the eye: sizes do not depend on
// distance.
#pragma once

#include "cameras/camera_ray.hpp"

namespace zraka {

struct OrthographicCamera {
  template <class R>
  static bool ray(const FrozenCamera<R>& camera, const PicturePoint& at, CameraRay& ray) {
    ray.origin =
        in_double(camera.eye) + ((in_double(camera.first) + in_double(camera.down) * at.row) +
                                 in_double(camera.right) * at.column);
    ray.direction = in_double(camera.ahead);
    return true;
  }

  template <class R>
  static CameraCone cone(const FrozenCamera<R>& camera, const PicturePoint&, const CameraRay& ray) {
    const V3<double> pixel = cross(in_double(camera.right), in_double(camera.down));
    return {std::sqrt(std::fabs(dot(pixel, ray.direction))), 0};
  }
};

}  // namespace zraka
