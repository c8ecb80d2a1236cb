// SPDX-License-Identifier: Apache-2.0
// Rays from the eye for the general engine, as render/ makes them.
#pragma once

#include <cmath>

#include "engine/coefficients.hpp"
#include "engine/tile_order.hpp"

namespace zraka {

/// Puts a ray for each pixel of a tile into level 0, in the order of each_pixel(): sample `number`
/// of each.
inline void put_camera_rays(const FrozenScene<float>& scene, const TileRect& tile,
                            std::uint32_t number, Workspace<float>& workspace) {
  const FrozenCamera<float>& c = scene.camera;
  RayArrays<float>& rays = workspace.levels[0].rays;
  std::size_t i = 0;
  each_pixel(tile, [&](std::int32_t column, std::int32_t row) {
    const std::int32_t x = tile.x + column, y = tile.y + row;
    workspace.samples[i] = {x, y, number};
    V3<float> d =
        (c.first + c.down * static_cast<float>(y)) + c.right * static_cast<float>(x);
    d = d * (1 / std::sqrt(dot(d, d)));
    rays.ox[i] = c.eye.x, rays.oy[i] = c.eye.y, rays.oz[i] = c.eye.z;
    rays.dx[i] = d.x, rays.dy[i] = d.y, rays.dz[i] = d.z;
    ++i;
  });
  workspace.levels[0].ray_count = static_cast<std::int32_t>(i);
  if (scene.textures != nullptr) start_cones(c, workspace.levels[0]);
}

}  // namespace zraka
