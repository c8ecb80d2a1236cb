// SPDX-License-Identifier: Apache-2.0
#include "scene/view_cone.hpp"

#include <algorithm>
#include <cmath>

#include "math/elementary.hpp"
#include "scene/view_axes.hpp"

namespace zraka {

double length_of(const V3<double>& v) {
  return std::hypot(v.x, v.y, v.z);
}

ViewCone::ViewCone(const Camera& camera, const Resolution& resolution) : eye(camera.eye) {
  const V3<double> center = vector_between(camera.eye, camera.window_center);
  axis_ = center * (1 / length_of(center));
  const V3<double> right = as_vector(camera.window_right), up = as_vector(camera.window_up);
  switch (camera.kind) {
    case CameraKind::pinhole: {
      for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5}) {
          const V3<double> corner = center + right * x + up * y;
          cosine_ = std::min(cosine_, dot(corner, axis_) / length_of(corner));
        }
      sine_ = std::sqrt(std::max(0.0, 1 - cosine_ * cosine_));
      known_ = cosine_ > 0 && length_of(center) > 0;
      if (!(camera.aperture > 0)) return;
      // Rays from the lens' rim through the point in focus are that much steeper.
      radius_ = camera.aperture / 2;
      const double steeper = elementary::atan2(radius_, camera.focus_distance);
      const double angle = elementary::atan2(sine_, cosine_) + steeper;
      cosine_ = elementary::cos(angle), sine_ = elementary::sin(angle);
      known_ = known_ && cosine_ > 0;
      return;
    }
    case CameraKind::orthographic:
      parallel_ = true;
      radius_ = (length_of(right) + length_of(up)) / 2;
      known_ = length_of(center) > 0;
      return;
    case CameraKind::fisheye: {
      const double aspect = static_cast<double>(resolution.width) / resolution.height;
      const double angle =
          camera.fov_deg / 2 * (3.14159265358979323846 / 180) * std::sqrt(1 + aspect * aspect);
      cosine_ = elementary::cos(std::min(angle, 3.0)),
      sine_ = elementary::sin(std::min(angle, 3.0));
      known_ = cosine_ > 0 && length_of(center) > 0;
      return;
    }
    case CameraKind::panorama:
      return;
  }
}

bool ViewCone::may_see(const Bounds& box) const {
  if (!known_ || !box.bounded()) return true;
  const Vec3 middle{box.lower.x / 2 + box.upper.x / 2, box.lower.y / 2 + box.upper.y / 2,
                    box.lower.z / 2 + box.upper.z / 2};
  const double radius = length_of(vector_between(box.lower, box.upper)) / 2 + radius_;
  const V3<double> way = vector_between(eye, middle);
  const double along = dot(way, axis_), across = length_of(way - axis_ * along);
  if (parallel_) return along >= -radius && across <= radius;
  // From the cone's side; or from its tip, where that is nearest.
  return along * cosine_ + across * sine_ >= 0 ? across * cosine_ - along * sine_ <= radius
                                               : length_of(way) <= radius;
}

Vec3 ViewCone::point_at(double distance) const {
  return known_ ? Vec3{eye.x + axis_.x * distance, eye.y + axis_.y * distance,
                       eye.z + axis_.z * distance}
                : eye;
}

double ViewCone::width_at(double distance) const {
  if (!known_) return distance;
  if (parallel_) return 2 * radius_;
  return 2 * distance * sine_ / std::max(cosine_, 0.1);
}

}  // namespace zraka
