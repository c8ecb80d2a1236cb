// SPDX-License-Identifier: Apache-2.0
// Rays from the eye through points of the window, for several samples a pixel. Plain loops over
// arrays, which the compiler makes lanes of, each operation rounded by itself: the same bits from
// all of them, and from one sample alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "engine/engine.hpp"

namespace zraka {

/// Moves pixels' places, `columns` and `rows`, to those of their samples.
template <bool kBox, class R>
ZRAKA_INLINE void place_samples(const InverseFilter& of, const SampleKeys& keys, std::size_t n,
                                R* __restrict columns, R* __restrict rows,
                                std::uint8_t* __restrict negative) {
  const InverseFilter filter = of;
  // One step of many samples after the other: each waits long for what is before it.
  constexpr std::size_t kChunk = 128;
  for (std::size_t first = 0; first < n; first += kChunk) {
    const std::size_t end = std::min(n, first + kChunk);
    std::uint32_t places[kChunk], u[kChunk], v[kChunk];
    const auto points = [&](std::size_t i) {
      return Sobol2(keys.shuffle[i], keys.u[i], keys.v[i]);
    };
    for (std::size_t i = first; i < end; ++i) places[i - first] = points(i).order(keys.number[i]);
    for (std::size_t i = first; i < end; ++i)
      u[i - first] = points(i).first_bits(places[i - first]);
    for (std::size_t i = first; i < end; ++i)
      v[i - first] = points(i).second_bits(places[i - first]);
    for (std::size_t i = first; i < end; ++i) {
      columns[i] += filter.template place<kBox, R>(u[i - first]);
      rows[i] += filter.template place<kBox, R>(v[i - first]);
      if constexpr (!kBox)
        negative[i] = filter.is_negative(u[i - first]) != filter.is_negative(v[i - first]);
    }
  }
}

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

/// As Services::make_window_rays().
template <class R>
ZRAKA_INLINE void make_window_rays(const FrozenCamera<R>& camera, const InverseFilter* filter,
                                   const SampleKeys& keys, std::size_t n, const RayArrays<R>& rays,
                                   std::uint8_t* negative) {
  if (filter != nullptr && filter->places == nullptr)
    place_samples<true>(*filter, keys, n, rays.dx, rays.dy, negative);
  else if (filter != nullptr)
    place_samples<false>(*filter, keys, n, rays.dx, rays.dy, negative);
  look_through_window(camera, n, rays.dx, rays.dy, rays.dz);
  const V3<R> eye = camera.eye;
  for (std::size_t i = 0; i < n; ++i) rays.ox[i] = eye.x;
  for (std::size_t i = 0; i < n; ++i) rays.oy[i] = eye.y;
  for (std::size_t i = 0; i < n; ++i) rays.oz[i] = eye.z;
}

}  // namespace zraka
