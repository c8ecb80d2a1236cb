// SPDX-License-Identifier: Apache-2.0
// The first level: a ray through each pixel of a tile (sheet 3.1).
#pragma once

#include "engine/engine.hpp"
#include "engine/tile_order.hpp"
#include "math/lanes.hpp"

namespace zraka::ZRAKA_ISA {

template <class F>
ZRAKA_INLINE V3<F> normalized(const V3<F>& v) {
  return v * (F(1) / sqrt(dot(v, v)));
}

template <class L, class R>
ZRAKA_INLINE V3<typename L::F> broadcast(const V3<R>& v) {
  using F = typename L::F;
  return {F(v.x), F(v.y), F(v.z)};
}

/// A ray through each pixel, in the order of each_pixel().
template <class L, class R = typename L::Real>
void make_camera_rays(const FrozenCamera<R>& camera, const TileRect& tile, Level<R>& level) {
  using F = typename L::F;
  // The pixels' coordinates wait where the directions will stand.
  std::size_t count = 0;
  each_pixel(tile, [&](std::int32_t x, std::int32_t y) {
    level.rays.dx[count] = static_cast<R>(tile.x + x);
    level.rays.dy[count] = static_cast<R>(tile.y + y);
    ++count;
  });
  const V3<F> eye = broadcast<L>(camera.eye);
  const V3<F> first = broadcast<L>(camera.first);
  const V3<F> right = broadcast<L>(camera.right);
  const V3<F> down = broadcast<L>(camera.down);
  for (std::size_t i = 0; i < count; i += L::kWidth) {
    const F column = L::load(level.rays.dx + i), row = L::load(level.rays.dy + i);
    const V3<F> direction = normalized((first + down * row) + right * column);
    L::store(eye.x, level.rays.ox + i);
    L::store(eye.y, level.rays.oy + i);
    L::store(eye.z, level.rays.oz + i);
    L::store(direction.x, level.rays.dx + i);
    L::store(direction.y, level.rays.dy + i);
    L::store(direction.z, level.rays.dz + i);
  }
  level.ray_count = static_cast<std::int32_t>(count);
}

}  // namespace zraka::ZRAKA_ISA
