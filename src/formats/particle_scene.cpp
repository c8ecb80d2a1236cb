// SPDX-License-Identifier: Apache-2.0
// A scene for a file of particles (docs/particles.md), which has neither light nor camera: these
// are chosen so that one sees all of it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/in_parallel.hpp"
#include "core/text.hpp"
#include "formats/formats.hpp"
#include "math/bounds.hpp"
#include "particles/look.hpp"
#include "scene/view.hpp"

namespace zraka {
namespace {

constexpr double kFovDeg = 25;
constexpr double kMargin = 1.04;  ///< of the picture over what is in it
constexpr Resolution kResolution = {1280, 720};

Vec3 sum(const Vec3& a, const Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vec3 scaled(const Vec3& a, double s) {
  return {a.x * s, a.y * s, a.z * s};
}
double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vec3 unit(const Vec3& a) {
  return scaled(a, 1 / std::sqrt(dot(a, a)));
}

/// function(centre, radius) for what each shape is in; by all threads, a copy of `empty` for each
/// part, joined by join(part).
template <class Part, class Function, class Join>
void for_each_ball(const Scene& scene, const Part& empty, const Function& function,
                   const Join& join) {
  std::mutex joining;
  const auto go = [&](const auto& list, const auto& ball_of) {
    in_parallel(list.size(), [&](std::size_t begin, std::size_t end) {
      Part part = empty;
      for (std::size_t i = begin; i != end; ++i) {
        const Sphere ball = ball_of(list[i]);
        function(part, ball.center, ball.radius);
      }
      const std::lock_guard lock(joining);
      join(part);
    });
  };
  go(scene.spheres, [](const Object<Sphere>& object) { return object.shape; });
  go(scene.ellipsoids, [&](const Object<Ellipsoid>& object) {
    const Vec3& r = object.shape.radii;
    return Sphere{scene.transforms[object.transform - 1].origin, std::max({r.x, r.y, r.z})};
  });
}

Bounds bounds_of(const Scene& scene) {
  Bounds all;
  for_each_ball(
      scene, Bounds{},
      [](Bounds& box, const Vec3& c, double r) {
        box.include({{c.x - r, c.y - r, c.z - r}, {c.x + r, c.y + r, c.z + r}});
      },
      [&](const Bounds& part) { all.include(part); });
  return all;
}

/// From where one looks, and what is up: along the axis by which all is thinnest, else along z, and
/// a little from above and from the right, so that depth is seen.
struct Direction {
  Vec3 to_eye, up;
};
Direction direction_of(const Bounds& box) {
  constexpr double kThin = 0.7;
  const double x = box.upper.x - box.lower.x, y = box.upper.y - box.lower.y,
               z = box.upper.z - box.lower.z;
  const double right = 0.28, above = 0.2;
  if (y < kThin * z && y <= x) return {unit({right, -1, above}), {0, 0, 1}};
  if (x < kThin * z && x < y) return {unit({1, right, above}), {0, 0, 1}};
  return {unit({right, above, 1}), {0, 1, 0}};
}

/// The nearest place of an eye, looking against `to_eye`, from which all balls are in the picture:
/// each of the four planes of the view touches one.
Camera framing(const Scene& scene, const Direction& direction, double aspect) {
  const Vec3 along = scaled(direction.to_eye, -1);
  const Vec3 right = unit(cross(along, direction.up)), up = cross(right, along);
  const double tall = std::tan(kFovDeg * 3.14159265358979323846 / 360), wide = tall * aspect;
  const double angles[] = {std::atan(wide), std::atan(wide), std::atan(tall), std::atan(tall)};
  const Vec3 aside[] = {right, scaled(right, -1), up, scaled(up, -1)};
  std::array<Vec3, 4> normals;  // of the planes, outwards
  for (std::size_t i = 0; i < 4; ++i)
    normals[i] = sum(scaled(aside[i], std::cos(angles[i])), scaled(along, -std::sin(angles[i])));
  using Distances = std::array<double, 4>;
  Distances most;
  most.fill(-Bounds::kInfinity);
  for_each_ball(
      scene, most,
      [&](Distances& part, const Vec3& center, double radius) {
        for (std::size_t i = 0; i < 4; ++i)
          part[i] = std::max(part[i], dot(normals[i], center) + radius);
      },
      [&](const Distances& part) {
        for (std::size_t i = 0; i < 4; ++i) most[i] = std::max(most[i], part[i]);
      });
  // The eye at r·right + u·up + a·along is on both planes of a pair where, for the first pair,
  // ±r·cos - a·sin is the most of each.
  const double r = (most[0] - most[1]) / (2 * std::cos(angles[0]));
  const double u = (most[2] - most[3]) / (2 * std::cos(angles[2]));
  const double a = std::min(-(most[0] + most[1]) / (2 * std::sin(angles[0])),
                            -(most[2] + most[3]) / (2 * std::sin(angles[2])));
  const Vec3 eye = sum(sum(scaled(right, r), scaled(up, u)), scaled(along, a));
  Camera camera = look_at(eye, sum(eye, along), direction.up, kFovDeg, aspect).value_or(Camera{});
  camera.window_right = scaled(camera.window_right, kMargin);
  camera.window_up = scaled(camera.window_up, kMargin);
  return camera;
}

/// A key light from the upper left, and one that fills its shadows from the right; both far away.
void add_lights(Scene& scene, const Direction& direction, const Vec3& middle, double size) {
  const Vec3 right = unit(cross(scaled(direction.to_eye, -1), direction.up));
  const Vec3 up = cross(direction.to_eye, right);
  const auto add = [&](double to_right, double above, double to_eye, double strength) {
    const Vec3 way =
        sum(sum(scaled(right, to_right), scaled(up, above)), scaled(direction.to_eye, to_eye));
    scene.lights.push_back({.position = sum(middle, scaled(unit(way), 8 * size)),
                            .color = {strength, strength, strength}});
  };
  add(-0.6, 0.9, 1, 0.75);
  add(1, 0.1, 0.7, 0.25);
  scene.ambient_light = {0.22, 0.22, 0.22};
  scene.background = {0.006, 0.007, 0.01};
}

}  // namespace

Likeness likeness_to_particles(std::string_view text) {
  return particle_format_of(text) != nullptr ? Likeness::sure : Likeness::none;
}

Result<ReadScene> parse_particle_scene(std::string_view bytes, const std::string& name,
                                       const ReadOptions&) {
  Result<Particles> particles = parse_particles(bytes, name);
  if (!particles) return tl::make_unexpected(particles.error());
  const bool has_more = particles->has_more;
  ReadScene read;
  Scene& scene = read.scene;
  const Result<Diagnostics> notes = add_particles(std::move(*particles), ParticleStyle{},
                                                  particle_material(), 0, name, scene, scene);
  if (!notes) return tl::make_unexpected(notes.error());
  const Bounds box = bounds_of(scene);
  const Vec3 middle = scaled(sum(box.lower, box.upper), 0.5);
  const Direction direction = direction_of(box);
  scene.resolution = kResolution;
  scene.camera =
      framing(scene, direction, static_cast<double>(kResolution.width) / kResolution.height);
  add_lights(scene, direction, middle, box.reach());
  scene.defaults.max_depth = 0;
  read.warnings = *notes;
  std::string message = fmt::format("{} particles; light, camera and colours are chosen here",
                                    grouped(scene.spheres.size() + scene.ellipsoids.size()));
  if (has_more) message += ", and of several frames the first is drawn";
  read.warnings.push_back({.severity = Severity::note,
                           .file = name,
                           .message = std::move(message),
                           .hint = "a scene with a shape of kind 'particles' chooses otherwise: "
                                   "zraka help particles"});
  return read;
}

}  // namespace zraka
