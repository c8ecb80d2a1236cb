// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/in_parallel.hpp"
#include "scene/bounds_of.hpp"
#include "scene/freeze_optics.hpp"

namespace zraka {

void find_body_sizes(const Scene& scene, const Whereabouts& where, const Frame& frame,
                     StoredOptics& optics) {
  double largest = 0;
  std::mutex joining;
  in_parallel(scene.spheres.size(), [&](std::size_t begin, std::size_t end) {
    double part = 0;
    for (std::size_t i = begin; i != end; ++i)
      part = std::max(part, 2 * scene.spheres[i].shape.radius);
    const std::lock_guard lock(joining);
    largest = std::max(largest, part);
  });
  largest = frame.length(largest);
  const auto add = [&](const auto& objects) {
    for (const auto& object : objects) {
      const Bounds box = where.bounds(object);
      const double x = box.upper.x - box.lower.x, y = box.upper.y - box.lower.y,
                   z = box.upper.z - box.lower.z;
      const double size = box.bounded() ? frame.length(std::sqrt(x * x + y * y + z * z)) : 0;
      optics.body_sizes.push_back(static_cast<float>(size));
      largest = std::max(largest, size);
    }
  };
#define ZRAKA_ADD(Type, plural) add(scene.plural);
  ZRAKA_BODIES(ZRAKA_ADD)
#undef ZRAKA_ADD
  optics.frozen.body_sizes = optics.body_sizes.data();
  optics.frozen.largest_body = largest;
}

}  // namespace zraka
