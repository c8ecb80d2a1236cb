// SPDX-License-Identifier: Apache-2.0
// Rays over the hemisphere around a normal, for ambient occlusion. Plain loops over arrays, which
// the compiler makes lanes of, each operation rounded by itself: the same bits from all of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "engine/engine.hpp"
#include "engine/sobol_lanes.hpp"
#include "sampling/warp.hpp"

namespace zraka::ZRAKA_ISA {

/// As Services::make_hemisphere(): Malley's method, points of the square to the disc (Shirley and
/// Chiu, "A low distortion map between disk and square", 1997) and up to the hemisphere. Sine and
/// cosine of at most an eighth of a turn are their series.
template <class R>
void make_hemisphere(const Sobol2& points, std::uint32_t first, std::size_t count,
                     const V3<R>& normal, std::size_t at, Scratch<R>& scratch) {
  constexpr std::size_t kChunk = 64;
  constexpr R kQuarter = R(0.78539816339744830962);  // π/4
  constexpr R kUnit = R(0x1p-23), kHalf = R(0x1p-24);
  V3<R> a, b;
  basis_of(normal, a, b);
  for (std::size_t done = 0; done < count; done += kChunk) {
    const std::size_t n = std::min(kChunk, count - done), whole = (n + 15) / 16 * 16;
    alignas(64) std::uint32_t u[kChunk], v[kChunk];
    find_bits(PointsOfOne(points, first + static_cast<std::uint32_t>(done)), whole, u, v);
    R x[kChunk], y[kChunk], z[kChunk];
    for (std::size_t i = 0; i < whole; ++i) {
      // From -1 to 1, the middles of 2^24 intervals: never 0.
      const R s = static_cast<R>(static_cast<std::int32_t>(u[i] >> 8)) * kUnit + (kHalf - 1);
      const R t = static_cast<R>(static_cast<std::int32_t>(v[i] >> 8)) * kUnit + (kHalf - 1);
      const bool wide = std::fabs(s) > std::fabs(t);
      const R r = wide ? s : t, angle = kQuarter * ((wide ? t : s) / r), square = angle * angle;
      const R sine = angle * (1 + square * (R(-1.0 / 6) + square * (R(1.0 / 120) +
                              square * (R(-1.0 / 5040) + square * R(1.0 / 362880)))));
      const R cosine = 1 + square * (R(-1.0 / 2) + square * (R(1.0 / 24) +
                           square * (R(-1.0 / 720) + square * R(1.0 / 40320))));
      const R along = r * cosine, across = r * sine;
      const R on_x = wide ? along : across, on_y = wide ? across : along;
      const R left = 1 - on_x * on_x - on_y * on_y, up = std::sqrt(left > 0 ? left : R(0));
      const V3<R> way = a * on_x + b * on_y + normal * up;
      const R scale = 1 / std::sqrt(dot(way, way));
      x[i] = way.x * scale, y[i] = way.y * scale, z[i] = way.z * scale;
    }
    std::copy_n(x, n, scratch.sdx + at + done);
    std::copy_n(y, n, scratch.sdy + at + done);
    std::copy_n(z, n, scratch.sdz + at + done);
  }
}

}  // namespace zraka::ZRAKA_ISA
