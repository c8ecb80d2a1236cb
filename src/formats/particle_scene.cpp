// SPDX-License-Identifier: Apache-2.0
// A scene for a file of particles (docs/particles.md), which has neither light nor camera: these
// are chosen so that one sees all of it.
#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "core/in_parallel.hpp"
#include "core/text.hpp"
#include "formats/formats.hpp"
#include "formats/framing.hpp"
#include "formats/vectors.hpp"
#include "math/bounds.hpp"
#include "particles/look.hpp"

namespace zraka {
namespace {

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
ViewDirection direction_of(const Bounds& box) {
  constexpr double kThin = 0.7;
  const double x = box.upper.x - box.lower.x, y = box.upper.y - box.lower.y,
               z = box.upper.z - box.lower.z;
  const double right = 0.28, above = 0.2;
  if (y < kThin * z && y <= x) return {unit({right, -1, above}), {0, 0, 1}};
  if (x < kThin * z && x < y) return {unit({1, right, above}), {0, 0, 1}};
  return {unit({right, above, 1}), {0, 1, 0}};
}

Camera framing(const Scene& scene, const ViewDirection& direction, double aspect) {
  const Framing framing(direction, aspect);
  Framing::Distances most = framing.none();
  for_each_ball(
      scene, most,
      [&](Framing::Distances& part, const Vec3& center, double radius) {
        framing.include(center, radius, part);
      },
      [&](const Framing::Distances& part) {
        for (std::size_t i = 0; i < 4; ++i) most[i] = std::max(most[i], part[i]);
      });
  return framing.camera(most);
}

}  // namespace

Likeness likeness_to_particles(std::string_view text) {
  return particle_format_of(text) != nullptr ? Likeness::sure : Likeness::none;
}

Result<ReadScene> parse_particle_scene(std::string_view bytes, const std::string& name,
                                       const ReadOptions& options) {
  ParticleStyle style;
  style.color_by = options.color_by;
  if (!options.color_map.empty()) {
    const auto* const map = std::find(std::begin(kColorMapNames), std::end(kColorMapNames),
                                      std::string_view(options.color_map));
    if (map == std::end(kColorMapNames))
      return failure(name, fmt::format("no map of colours is called '{}'", options.color_map),
                     fmt::format("known are {}", fmt::join(kColorMapNames, ", ")));
    style.color_map = static_cast<ColorMap>(map - std::begin(kColorMapNames));
  }
  Result<Particles> particles =
      parse_particles(bytes, name, {has_column(style) ? style.color_by : "", 1});
  if (!particles) return tl::make_unexpected(particles.error());
  const bool has_more = particles->has_more;
  ReadScene read;
  Scene& scene = read.scene;
  Result<AddedParticles> added =
      add_particles(std::move(*particles), style, particle_material(), 0, name, scene, scene);
  if (!added) return tl::make_unexpected(added.error());
  if (added->legend) read.legends.push_back(std::move(*added->legend));
  const Bounds box = bounds_of(scene);
  const Vec3 middle = (box.lower + box.upper) * 0.5;
  const ViewDirection direction = direction_of(box);
  scene.resolution = kFramedResolution;
  scene.camera = framing(scene, direction,
                         static_cast<double>(kFramedResolution.width) / kFramedResolution.height);
  add_studio_lights(scene, direction, middle, box.reach());
  scene.ambient_light = {0.22, 0.22, 0.22};
  scene.background = {0.006, 0.007, 0.01};
  scene.defaults.max_depth = 0;
  read.warnings = std::move(added->notes);
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
