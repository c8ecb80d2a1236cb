// SPDX-License-Identifier: Apache-2.0
// Shadow rays of many hits, traced in the order of their directions: rays that go the same way ask
// the same boxes. What comes of each is its own, whatever the order.
#pragma once

#include <algorithm>
#include <cmath>

#include "accel/called.hpp"
#include "engine/engine.hpp"
#include "engine/indices.hpp"

namespace zraka::ZRAKA_ISA {

/// Along each side of a cube there are so many squares; a part of all directions goes through one.
inline constexpr std::int32_t kSquares = 4;
inline constexpr std::int32_t kParts = 6 * kSquares * kSquares;

/// Which part each direction is in. A plain loop, which the compiler makes lanes of.
template <class R>
ZRAKA_INLINE void find_parts(std::size_t n, const R* dx, const R* dy, const R* dz,
                             std::int32_t* parts) {
  constexpr R kHalf = R(kSquares) / 2;
  for (std::size_t i = 0; i < n; ++i) {
    const R x = std::fabs(dx[i]), y = std::fabs(dy[i]), z = std::fabs(dz[i]);
    const bool by_x = x >= y && x >= z, by_y = !by_x && y >= z;
    const R along = by_x ? dx[i] : by_y ? dy[i] : dz[i];
    const R first = by_x ? dy[i] : dx[i], second = by_x || by_y ? dz[i] : dy[i];
    const R scale = kHalf / std::fabs(along);
    const auto square = [&](R at) {
      const auto q = static_cast<std::int32_t>(at * scale + kHalf);
      return q < kSquares ? q : kSquares - 1;  // and not below 0: |at| is at most |along|
    };
    const std::int32_t side = (by_x ? 0 : by_y ? 2 : 4) + (along < 0 ? 0 : 1);
    parts[i] = (side * kSquares + square(first)) * kSquares + square(second);
  }
}

/// Sorts the first n shadow rays: scratch.shadow_order, with numbers of rays behind its end, too.
template <class R>
ZRAKA_INLINE void order_by_direction(std::size_t n, Scratch<R>& scratch) {
  find_parts(n, scratch.sdx, scratch.sdy, scratch.sdz, scratch.part);
  std::int32_t start[kParts + 1] = {};
  // Directions that are no numbers go anywhere.
  const auto part = [&](std::size_t i) { return std::clamp(scratch.part[i], 0, kParts - 1); };
  for (std::size_t i = 0; i < n; ++i) ++start[part(i) + 1];
  for (std::int32_t p = 1; p <= kParts; ++p) start[p] += start[p - 1];
  for (std::size_t i = 0; i < n; ++i)
    scratch.shadow_order[start[part(i)]++] = static_cast<std::int32_t>(i);
  std::fill_n(scratch.shadow_order + n, kArrayPadding, 0);
}

/// As Services::find_blocked().
template <class L, class R = typename L::Real>
void find_blocked_in_order(const FrozenScene<R>& scene, std::size_t n, Scratch<R>& scratch) {
  using I = typename L::I;
  order_by_direction(n, scratch);
  LastBlocker last;
  for (std::size_t first = 0; first < n; first += RayGroup<L>::kRays) {
    RayGroup<L> rays(first, n, [&](std::size_t i) -> RayLanes<L> {
      const I ray = L::load(scratch.shadow_order + i), hit = L::gather(scratch.shadow_ray_hit, ray);
      return {{L::gather(scratch.sox, hit), L::gather(scratch.soy, hit),
               L::gather(scratch.soz, hit)},
              {L::gather(scratch.sdx, ray), L::gather(scratch.sdy, ray),
               L::gather(scratch.sdz, ray)},
              L::gather(scratch.sdistance, ray),
              I(-1)};
    });
    const std::uint32_t blocked = find_blocked_called<L>(scene, last, rays);
    const std::size_t count = std::min(n - first, RayGroup<L>::kRays);
    for (std::size_t i = 0; i < count; ++i)
      scratch.blocked[scratch.shadow_order[first + i]] =
          static_cast<std::int32_t>(blocked >> i & 1);
  }
}

/// As Services::find_blocked_as_listed().
template <class L, class R = typename L::Real>
void find_blocked_as_listed(const FrozenScene<R>& scene, std::size_t n, Scratch<R>& scratch) {
  using F = typename L::F;
  using I = typename L::I;
  LastBlocker last;
  for (std::size_t first = 0; first < n; first += RayGroup<L>::kRays) {
    RayGroup<L> rays(first, n, [&](std::size_t i) -> RayLanes<L> {
      const std::int32_t h = scratch.shadow_ray_hit[i];
      const I hit = select(L::first(n - i), L::load(scratch.shadow_ray_hit + i), I(h));
      V3<F> origin{F(scratch.sox[h]), F(scratch.soy[h]), F(scratch.soz[h])};
      if (!all(hit == I(h))) {
        const Indices<L> at(hit);
        origin = {at.load(scratch.sox), at.load(scratch.soy), at.load(scratch.soz)};
      }
      return {origin,
              {L::load(scratch.sdx + i), L::load(scratch.sdy + i), L::load(scratch.sdz + i)},
              L::load(scratch.sdistance + i),
              I(-1)};
    });
    const std::uint32_t blocked = find_blocked_called<L>(scene, last, rays);
    const std::size_t count = std::min(n - first, RayGroup<L>::kRays);
    for (std::size_t i = 0; i < count; ++i)
      scratch.blocked[first + i] = static_cast<std::int32_t>(blocked >> i & 1);
  }
}

/// As Services::drop_blocked(): neighbouring hits' ways to one light need no order.
template <class L>
std::size_t drop_blocked(const FrozenScene<typename L::Real>& scene, std::size_t n,
                         Scratch<typename L::Real>& scratch, std::int32_t* blocked_hits) {
  using F = typename L::F;
  using I = typename L::I;
  std::int32_t* const hits = scratch.shadow_ray_hit;
  LastBlocker last;
  std::size_t kept = 0, dropped = 0;
  for (std::size_t first = 0; first < n; first += RayGroup<L>::kRays) {
    RayGroup<L> rays(first, n, [&](std::size_t i) -> RayLanes<L> {
      const Indices<L> hit(select(L::first(n - i), L::load(hits + i), I(hits[i])));
      return {{hit.load(scratch.sox), hit.load(scratch.soy), hit.load(scratch.soz)},
              {hit.load(scratch.lx), hit.load(scratch.ly), hit.load(scratch.lz)},
              hit.load(scratch.sdistance),
              I(-1)};
    });
    const std::uint32_t blocked = find_blocked_called<L>(scene, last, rays);
    for (std::size_t r = 0; r < kRegisters<L> && first + r * L::kWidth < n; ++r) {
      const std::size_t i = first + r * L::kWidth;
      const auto exists = L::first(n - i), by = both(lanes_of<L>(blocked, r), exists);
      const I hit = L::load(hits + i);
      L::compress_store(hit, but_not(exists, by), hits + kept);
      kept += count(but_not(exists, by));
      if (!any(by)) continue;
      L::scatter(F(0), by, scratch.lit, hit);
      L::compress_store(hit, by, blocked_hits + dropped);
      dropped += count(by);
    }
  }
  return kept;
}

}  // namespace zraka::ZRAKA_ISA
