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

/// Row by row: ray row·width + column belongs to that pixel of the tile.
template <class L, class R = typename L::Real>
void make_camera_rays(const FrozenCamera<R>& camera, const TileRect& tile, Level<R>& level) {
  using F = typename L::F;
  const V3<F> eye = broadcast<L>(camera.eye);
  const V3<F> first = broadcast<L>(camera.first);
  const V3<F> right = broadcast<L>(camera.right);
  const V3<F> down = broadcast<L>(camera.down);
  std::size_t out = 0;
  for (std::int32_t y = 0; y < tile.height; ++y, out += static_cast<std::size_t>(tile.width)) {
    const F row(static_cast<R>(tile.y + y));
    const V3<F> start = first + down * row;
    // Whole vectors; what a row writes past its end, the next row overwrites.
    for (std::int32_t x = 0; x < tile.width; x += static_cast<std::int32_t>(L::kWidth)) {
      const F column = L::to_real(L::iota(tile.x + x));
      const V3<F> direction = normalized(start + right * column);
      const std::size_t i = out + static_cast<std::size_t>(x);
      L::store(eye.x, level.rays.ox + i);
      L::store(eye.y, level.rays.oy + i);
      L::store(eye.z, level.rays.oz + i);
      L::store(direction.x, level.rays.dx + i);
      L::store(direction.y, level.rays.dy + i);
      L::store(direction.z, level.rays.dz + i);
    }
  }
  level.ray_count = static_cast<std::int32_t>(out);
}

}  // namespace zraka::ZRAKA_ISA
