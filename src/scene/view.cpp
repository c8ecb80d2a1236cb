// SPDX-License-Identifier: Apache-2.0
#include "scene/view.hpp"

#include <algorithm>
#include <cmath>

namespace zraka {
namespace {

Vec3 scaled(const Vec3& a, double s) {
  return {a.x * s, a.y * s, a.z * s};
}
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(const Vec3& a) {
  return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}

double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Unit vectors along the view and to the right of the picture.
struct Axes {
  Vec3 along, right;
};
std::optional<Axes> axes_of(const Vec3& eye, const Vec3& target, const Vec3& up) {
  Vec3 along{target.x - eye.x, target.y - eye.y, target.z - eye.z};
  if (!(length(along) > 0)) return std::nullopt;
  along = scaled(along, 1 / length(along));
  const Vec3 right = cross(along, up);
  if (!(length(right) > 0)) return std::nullopt;
  return Axes{along, scaled(right, 1 / length(right))};
}

/// The window is 1 away, but where the sum of that and the eye's place would lose its digits.
double away_from(const Vec3& eye) {
  const double most = std::max({std::fabs(eye.x), std::fabs(eye.y), std::fabs(eye.z)});
  int exponent = 0;
  if (most > 0x1p20) std::frexp(most, &exponent);
  return std::ldexp(1, exponent);
}

}  // namespace

std::optional<Camera> look_at(const Vec3& eye, const Vec3& target, const Vec3& up, double fov_deg,
                              double aspect) {
  const std::optional<Axes> axes = axes_of(eye, target, up);
  if (!axes) return std::nullopt;
  const auto& [along, right] = *axes;
  const double tall = 2 * std::tan(fov_deg * 3.14159265358979323846 / 360);
  const double away = away_from(eye);
  return Camera{eye,
                {eye.x + along.x * away, eye.y + along.y * away, eye.z + along.z * away},
                scaled(right, tall * aspect * away),
                scaled(cross(right, along), tall * away)};
}

std::optional<Camera> look_along(const Vec3& eye, const Vec3& target, const Vec3& up, double height,
                                 double aspect) {
  const std::optional<Axes> axes = axes_of(eye, target, up);
  if (!axes) return std::nullopt;
  const auto& [along, right] = *axes;
  const double away = away_from(eye);
  return Camera{eye,
                {eye.x + along.x * away, eye.y + along.y * away, eye.z + along.z * away},
                scaled(right, height * aspect),
                scaled(cross(right, along), height),
                CameraKind::orthographic};
}

double depth_of(const Vec3& point, const Camera& camera) {
  const auto from_eye = [&](const Vec3& p) {
    return Vec3{p.x - camera.eye.x, p.y - camera.eye.y, p.z - camera.eye.z};
  };
  const Vec3 normal = cross(camera.window_right, camera.window_up);
  const double side = dot(from_eye(camera.window_center), normal) < 0 ? -1 : 1;
  return dot(from_eye(point), normal) * side / length(normal);
}

bool spans_a_plane(const Vec3& a, const Vec3& b) {
  return length(cross(a, b)) > 0;
}

}  // namespace zraka
