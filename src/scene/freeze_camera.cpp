// SPDX-License-Identifier: Apache-2.0
#include "scene/freeze_camera.hpp"

#include <algorithm>
#include <cmath>

#include "scene/narrow.hpp"
#include "scene/reals.hpp"
#include "scene/view_axes.hpp"

namespace zraka {
namespace {

constexpr double kPi = 3.14159265358979323846;

template <class R>
V3<R> narrowed(const V3<double>& v) {
  return {narrow<R>(v.x), narrow<R>(v.y), narrow<R>(v.z)};
}

/// A pinhole's window, wherever its squares stay finite: only directions count.
struct Window {
  V3<double> center, right, up;
  double scale;  ///< of the world

  explicit Window(const Camera& camera) {
    center = vector_between(camera.eye, camera.window_center);
    int exponent = 0;
    std::frexp(std::max({std::fabs(center.x), std::fabs(center.y), std::fabs(center.z)}),
               &exponent);
    scale = std::ldexp(1.0, -exponent);
    right = as_vector(camera.window_right);
    up = as_vector(camera.window_up);
  }
};

/// The sheet's pixel is its upper left corner, i = column - resolution/2; others look through
/// centres.
double place_in_pixel(const Profile& profile) {
  return profile.pixel_centers ? 0.5 : 0.0;
}

template <class R>
void add_lens(const Camera& camera, const Window& window, const Frame& frame,
              FrozenCamera<R>& frozen) {
  // The lens and what is in focus are parallel to the window, which is perpendicular to the view in
  // most cameras, and shifted in others.
  const V3<double> u = unit_vector(window.right),
                   v = unit_vector(window.up - u * dot(window.up, u));
  const double radius = frame.length(camera.aperture) / 2;
  frozen.lens_right = narrowed<R>(u * radius);
  frozen.lens_down = narrowed<R>(v * -radius);
  const V3<double> center = window.center * window.scale;
  frozen.focus = frame.length(camera.focus_distance) / std::sqrt(dot(center, center));
  frozen.beyond = narrow<R>(radius);
}

}  // namespace

template <class R>
FrozenCamera<R> freeze_camera(const Scene& scene, const Profile& profile, const Frame& frame) {
  const Camera& camera = scene.camera;
  const double width = scene.resolution.width;
  const double height = scene.resolution.height;
  const double in_pixel = place_in_pixel(profile);
  const Window window(camera);
  FrozenCamera<R> frozen{};
  frozen.kind = camera.kind;
  const V3<double> ahead =
      window.center * (frame.eye_shift / std::sqrt(dot(window.center, window.center)));
  const Vec3 eye = frame.eye_shift > 0 ? Vec3{camera.eye.x + ahead.x, camera.eye.y + ahead.y,
                                              camera.eye.z + ahead.z}
                                       : camera.eye;
  frozen.eye = narrow<R>(frame.point(eye));

  if (camera.kind == CameraKind::pinhole || camera.kind == CameraKind::orthographic) {
    const bool parallel = camera.kind == CameraKind::orthographic;
    const double scale = parallel ? frame.scale : window.scale;
    const V3<double> column = window.right * (scale / width);
    const V3<double> row = window.up * (-scale / height);
    const V3<double> middle = parallel ? V3<double>{0, 0, 0} : window.center * scale;
    frozen.first =
        narrowed<R>(middle + column * (in_pixel - width / 2) + row * (in_pixel - height / 2));
    frozen.right = narrowed<R>(column);
    frozen.down = narrowed<R>(row);
    if (camera.aperture > 0 && !parallel) add_lens(camera, window, frame, frozen);
    if (!parallel) return frozen;
    frozen.ahead = narrowed<R>(unit_vector(window.center));
    const V3<double> all = window.right * scale, tall = window.up * scale;
    frozen.beyond = narrow<R>(std::sqrt(dot(all, all)) + std::sqrt(dot(tall, tall)));
    return frozen;
  }
  const ViewAxes axes(camera);
  frozen.first = narrowed<R>(axes.ahead);
  frozen.right = narrowed<R>(axes.right);
  frozen.down = narrowed<R>(axes.up * -1.0);
  const bool all_round = camera.kind == CameraKind::panorama;
  const auto radians = [](double degrees) { return degrees * (kPi / 180); };
  frozen.step_down = radians(all_round ? camera.latitude_deg : camera.fov_deg) / height;
  frozen.step_right = all_round ? radians(camera.longitude_deg) / width : frozen.step_down;
  frozen.angle_right = frozen.step_right * (in_pixel - width / 2);
  frozen.angle_down = frozen.step_down * (in_pixel - height / 2);
  if (all_round) frozen.angle_down -= radians(camera.latitude_middle_deg);
  return frozen;
}

#define ZRAKA_FOR(R) \
  template FrozenCamera<R> freeze_camera(const Scene&, const Profile&, const Frame&);
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka
