// SPDX-License-Identifier: Apache-2.0
#include "scene/depth_cue.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "core/in_parallel.hpp"
#include "scene/bounds_of.hpp"

namespace zraka {
namespace {

struct Depths {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
};

/// How far shapes are ahead of the eye, along a unit vector.
Depths depths_of(const Scene& scene, const Vec3& ahead) {
  const Whereabouts where(scene);
  Depths all;
  std::mutex joining;
  const auto look = [&](const auto& objects) {
    in_parallel(objects.size(), [&](std::size_t begin, std::size_t end) {
      Depths part;
      for (std::size_t i = begin; i != end; ++i) {
        const Bounds box = where.bounds(objects[i]);
        if (!box.bounded()) continue;
        const Vec3 &low = box.lower, &high = box.upper, &eye = scene.camera.eye;
        const double middle = ahead.x * ((low.x + high.x) / 2 - eye.x) +
                              ahead.y * ((low.y + high.y) / 2 - eye.y) +
                              ahead.z * ((low.z + high.z) / 2 - eye.z);
        // Half of a ball's box is as deep as the ball from every side.
        const double deep = std::max({high.x - low.x, high.y - low.y, high.z - low.z}) / 2;
        part.least = std::min(part.least, middle - deep);
        part.most = std::max(part.most, middle + deep);
      }
      const std::lock_guard lock(joining);
      all = {std::min(all.least, part.least), std::max(all.most, part.most)};
    });
  };
#define ZRAKA_LOOK(Type, plural) look(scene.plural);
  ZRAKA_SHAPES(ZRAKA_LOOK)
#undef ZRAKA_LOOK
  return all;
}

}  // namespace

bool add_depth_cue(Scene& scene) {
  constexpr double kLeft = 0.2;
  const Vec3 &eye = scene.camera.eye, &center = scene.camera.window_center;
  Vec3 ahead{center.x - eye.x, center.y - eye.y, center.z - eye.z};
  const double length = std::sqrt(ahead.x * ahead.x + ahead.y * ahead.y + ahead.z * ahead.z);
  if (!(length > 0)) return false;
  ahead = {ahead.x / length, ahead.y / length, ahead.z / length};
  const Depths depths = depths_of(scene, ahead);
  const double start = std::max(depths.least, 0.0);
  if (!(depths.most > start)) return false;
  scene.fog = {.kind = Fog::Kind::linear,
               .start = start,
               .end = start + (depths.most - start) / (1 - kLeft),
               .color = scene.background,
               .planar = true};
  return true;
}

}  // namespace zraka
