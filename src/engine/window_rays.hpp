// SPDX-License-Identifier: Apache-2.0
// Rays from the eye through points of the window, for several samples a pixel. Plain loops over
// arrays, which the compiler makes lanes of, each operation rounded by itself: the same bits from
// all of them, and from one sample alone.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "engine/engine.hpp"

namespace zraka {

/// Unit directions through places in the picture, where these have been.
template <class R>
ZRAKA_INLINE void look_through_window(const FrozenCamera<R>& camera, std::size_t n, R* __restrict x,
                                      R* __restrict y, R* __restrict z) {
  const V3<R> first = camera.first, right = camera.right, down = camera.down;
  for (std::size_t i = 0; i < n; ++i) {
    const V3<R> way = (first + down * y[i]) + right * x[i];
    const R scale = R(1) / std::sqrt(dot(way, way));
    x[i] = way.x * scale, y[i] = way.y * scale, z[i] = way.z * scale;
  }
}

}  // namespace zraka
