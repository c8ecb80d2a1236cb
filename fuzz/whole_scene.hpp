// SPDX-License-Identifier: Apache-2.0
// What every scene that a reader gives has to be, whatever it has read.
#pragma once

#include <cstdlib>
#include <zraka/diagnostic.hpp>
#include <zraka/scene.hpp>

namespace zraka {

/// Ends the target where a result is neither a scene nor a reason.
inline void expect_reason(const Diagnostics& problems) {
  if (problems.empty()) std::abort();
}

/// Ends it where a scene names textures or corners that it does not have, or has no pixels.
inline void expect_whole(const Scene& scene) {
  for (const Material& material : scene.materials)
    for (const TextureUse& use : material.textures)
      if (use.texture >= scene.textures.size()) std::abort();
  const auto expect_uvs = [](const ShapeLists& shapes) {
    if (!shapes.triangle_uvs.empty() && shapes.triangle_uvs.size() != shapes.triangles.size())
      std::abort();
    if (!shapes.smooth_triangle_uvs.empty() &&
        shapes.smooth_triangle_uvs.size() != shapes.smooth_triangles.size())
      std::abort();
  };
  expect_uvs(scene);
  for (const Group& group : scene.groups) expect_uvs(group);
  if (scene.resolution.width == 0 || scene.resolution.height == 0) std::abort();
}

}  // namespace zraka
