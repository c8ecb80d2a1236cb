// SPDX-License-Identifier: Apache-2.0
// Rays from the eye through the points of a window; or from points of a thin lens around the eye to
// where the eye's ray meets the plane in focus (Potmesil and Chakravarty, "Synthetic image
// generation with a lens and aperture camera model", 1982; Cook, Porter and Carpenter 1984).
#pragma once

#include "cameras/camera_ray.hpp"

namespace zraka {

struct PinholeCamera {
  template <class R>
  static bool ray(const FrozenCamera<R>& camera, const PicturePoint& at, CameraRay& ray) {
    const V3<double> through = (in_double(camera.first) + in_double(camera.down) * at.row) +
                               in_double(camera.right) * at.column;
    ray.origin = in_double(camera.eye);
    ray.direction = through;
    if (camera.has_lens()) {
      const DiscPoint on_lens = concentric_disc(at.lens);
      const V3<double> aside =
          in_double(camera.lens_right) * on_lens.x + in_double(camera.lens_down) * on_lens.y;
      ray.origin = ray.origin + aside;
      ray.direction = through * camera.focus - aside;
    }
    ray.direction = normalized(ray.direction);
    return true;
  }

  /// A pixel is as wide as the window's is where it is nearest to the eye; away from there it looks
  /// smaller, which the cosine to the window's normal says.
  template <class R>
  static CameraCone cone(const FrozenCamera<R>& camera, const PicturePoint&, const CameraRay& ray) {
    const V3<double> normal = cross(in_double(camera.right), in_double(camera.down));
    const double area = std::sqrt(dot(normal, normal));
    const double away = std::fabs(dot(in_double(camera.first), normal)) / area;
    const double cosine = std::fabs(dot(ray.direction, normal)) / area;
    return {0, std::sqrt(area) / away * cosine * std::sqrt(cosine)};
  }
};

}  // namespace zraka
