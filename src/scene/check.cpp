// SPDX-License-Identifier: Apache-2.0
// What can be wrong with a scene that a program has put together.
#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <zraka/render.hpp>

#include "core/in_parallel.hpp"
#include "shapes/shapes.hpp"

namespace zraka {

std::uint64_t Scene::shape_count() const {
  std::uint64_t count = 0;
#define ZRAKA_COUNT(Type, plural) count += plural.size();
  ZRAKA_SHAPES(ZRAKA_COUNT)
#undef ZRAKA_COUNT
  return count;
}

namespace {

/// Squares and products of what is this far stay finite.
constexpr double kFarthest = 1e100;

bool finite_material(const Material& m) {
  return finite(m.ambient) && finite(m.diffuse) && finite(m.specular) && finite(m.shininess) &&
         finite(m.reflection) && finite(m.refraction) && finite(m.ior);
}

template <class Shape>
bool within_reach(const Shape& shape) {
  const Box box = ShapeTraits<Shape>::bounds(shape);
  for (const double side :
       {box.lower.x, box.lower.y, box.lower.z, box.upper.x, box.upper.y, box.upper.z})
    if (!(std::fabs(side) <= kFarthest)) return false;
  return true;
}

template <class Shape>
void check_objects(const Scene& scene, const std::vector<Object<Shape>>& objects,
                   const auto& complain) {
  using Traits = ShapeTraits<Shape>;
  // Mostly nothing is wrong, which is soon known; what is said otherwise must come in order.
  std::atomic<bool> good = true;
  in_parallel(objects.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (Traits::check(objects[i].shape) != nullptr || !within_reach(objects[i].shape) ||
          objects[i].material >= scene.materials.size())
        good = false;
  });
  if (good) return;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (const char* problem = Traits::check(objects[i].shape))
      complain(fmt::format("{} {}: {}", Traits::kName, i + 1, problem));
    if (!within_reach(objects[i].shape))
      complain(fmt::format("{} {}: it reaches farther than {} from the origin", Traits::kName,
                           i + 1, kFarthest));
    if (objects[i].material >= scene.materials.size())
      complain(fmt::format("{} {}: it has material {}, but there are {}", Traits::kName, i + 1,
                           objects[i].material, scene.materials.size()));
  }
}

}  // namespace

Diagnostics check(const Scene& scene) {
  constexpr std::size_t kEnough = 20;
  Diagnostics found;
  const auto complain = [&](std::string message) {
    if (found.size() < kEnough) found.push_back({.message = std::move(message)});
  };
  const std::uint64_t pixels = std::uint64_t{scene.resolution.width} * scene.resolution.height;
  if (pixels == 0) complain("the picture has no pixels");
  if (pixels > kMaxPixels)
    complain(fmt::format("a picture of {}×{} pixels is too large: at most {} pixels fit",
                         scene.resolution.width, scene.resolution.height, kMaxPixels));
  const Camera& camera = scene.camera;
  if (!finite(camera.eye) || !finite(camera.window_center) || !finite(camera.window_right) ||
      !finite(camera.window_up))
    complain("the camera is not finite");
  if (!finite(scene.background) || !finite(scene.ambient_light))
    complain("the background or the ambient light is not finite");
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    if (!finite(scene.lights[i].position) || !finite(scene.lights[i].color))
      complain(fmt::format("light {} is not finite", i + 1));
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    if (!finite_material(scene.materials[i])) complain(fmt::format("material {} is not finite", i));
  if (scene.shape_count() > static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max()))
    complain(fmt::format("{} shapes are too many: at most {} fit", scene.shape_count(),
                         std::numeric_limits<std::int32_t>::max()));
  constexpr std::uint64_t kMostMaterials = std::uint64_t{1} << 26;
  if (scene.materials.size() > kMostMaterials || scene.lights.size() > kMostMaterials)
    complain(fmt::format("{} materials and {} lights are too many: at most {} of each fit",
                         scene.materials.size(), scene.lights.size(), kMostMaterials));
#define ZRAKA_CHECK(Type, plural) check_objects(scene, scene.plural, complain);
  ZRAKA_SHAPES(ZRAKA_CHECK)
#undef ZRAKA_CHECK
  return found;
}

}  // namespace zraka
