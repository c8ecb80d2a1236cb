// SPDX-License-Identifier: Apache-2.0
#include "formats/framing.hpp"

#include <algorithm>
#include <cmath>

#include "formats/vectors.hpp"
#include "scene/view.hpp"

namespace zraka {
namespace {

constexpr double kFovDeg = 25;
constexpr double kMargin = 1.04;  ///< of the picture over what is in it

}  // namespace

Framing::Framing(const ViewDirection& direction, double aspect)
    : direction_(direction), aspect_(aspect), along_(direction.to_eye * -1) {
  right_ = unit(cross(along_, direction.up));
  up_ = cross(right_, along_);
  const double tall = std::tan(kFovDeg * 3.14159265358979323846 / 360), wide = tall * aspect;
  angles_ = {std::atan(wide), std::atan(wide), std::atan(tall), std::atan(tall)};
  const Vec3 aside[] = {right_, right_ * -1, up_, up_ * -1};
  for (std::size_t i = 0; i < 4; ++i)
    normals_[i] = aside[i] * std::cos(angles_[i]) + along_ * -std::sin(angles_[i]);
}

Framing::Distances Framing::none() const {
  Distances most;
  most.fill(-HUGE_VAL);
  return most;
}

void Framing::include(const Vec3& center, double radius, Distances& most) const {
  for (std::size_t i = 0; i < 4; ++i)
    most[i] = std::max(most[i], dot(normals_[i], center) + radius);
}

Camera Framing::camera(const Distances& most) const {
  // The eye at r·right + u·up + a·along is on both planes of a pair where, for the first pair,
  // ±r·cos - a·sin is the most of each.
  const double r = (most[0] - most[1]) / (2 * std::cos(angles_[0]));
  const double u = (most[2] - most[3]) / (2 * std::cos(angles_[2]));
  const double a = std::min(-(most[0] + most[1]) / (2 * std::sin(angles_[0])),
                            -(most[2] + most[3]) / (2 * std::sin(angles_[2])));
  const Vec3 eye = right_ * r + up_ * u + along_ * a;
  Camera camera = look_at(eye, eye + along_, direction_.up, kFovDeg, aspect_).value_or(Camera{});
  camera.window_right = camera.window_right * kMargin;
  camera.window_up = camera.window_up * kMargin;
  return camera;
}

Camera camera_around(std::span<const Vec3> points, const ViewDirection& direction, double aspect) {
  const Framing framing(direction, aspect);
  Framing::Distances most = framing.none();
  for (const Vec3& point : points) framing.include(point, 0, most);
  return framing.camera(most);
}

void add_studio_lights(Scene& scene, const ViewDirection& direction, const Vec3& middle,
                       double size) {
  const Vec3 right = unit(cross(direction.to_eye * -1, direction.up));
  const Vec3 up = cross(direction.to_eye, right);
  const auto add = [&](double to_right, double above, double to_eye, double strength) {
    const Vec3 way = right * to_right + up * above + direction.to_eye * to_eye;
    scene.lights.push_back(
        {.position = middle + unit(way) * (8 * size), .color = {strength, strength, strength}});
  };
  add(-0.6, 0.9, 1, 0.75);
  add(1, 0.1, 0.7, 0.25);
}

}  // namespace zraka
