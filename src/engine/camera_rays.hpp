// SPDX-License-Identifier: Apache-2.0
// The first level: a ray through each pixel of a tile (sheet 3.1).
#pragma once

#include "engine/engine.hpp"
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

/// The order of a tile's rays: squares of 4×4 pixels row by row, so that rays in neighbouring lanes
/// stay together through the scene. Calls function(column, row) for each pixel of the tile.
template <class Function>
ZRAKA_INLINE void each_pixel(const TileRect& tile, const Function& function) {
  constexpr std::int32_t kSide = 4;
  for (std::int32_t top = 0; top < tile.height; top += kSide)
    for (std::int32_t left = 0; left < tile.width; left += kSide)
      for (std::int32_t y = top; y < tile.height && y < top + kSide; ++y)
        for (std::int32_t x = left; x < tile.width && x < left + kSide; ++x) function(x, y);
}

/// A ray through each pixel, in the order of each_pixel().
template <class L, class R = typename L::Real>
void make_camera_rays(const FrozenCamera<R>& camera, const TileRect& tile, Level<R>& level) {
  using F = typename L::F;
  // The pixels' places wait where the directions will stand.
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
