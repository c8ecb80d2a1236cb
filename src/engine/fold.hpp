// SPDX-License-Identifier: Apache-2.0
// From the deepest level up: what a ray brings back (sheet 3.6).
#pragma once

#include "engine/engine.hpp"
#include "engine/indices.hpp"
#include "engine/record.hpp"

namespace zraka::ZRAKA_ISA {

/// sum + share·colour of the child, where there is one. A hit without a child adds nothing.
template <class L, class R = typename L::Real>
ZRAKA_INLINE V3<typename L::F> add_child(const V3<typename L::F>& sum, const R* shares,
                                         const std::int32_t* children, const RayArrays<R>& rays) {
  using F = typename L::F;
  using I = typename L::I;
  const I child = L::load(children);
  const auto there = child >= I(0);
  if (!any(there)) return sum;
  const Indices<L> children_of(select(there, child, I(0)));
  const F share = L::load(shares);
  const V3<F> color{children_of.load(rays.r), children_of.load(rays.g), children_of.load(rays.b)};
  const V3<F> more = sum + color * share;
  return {select(there, more.x, sum.x), select(there, more.y, sum.y), select(there, more.z, sum.z)};
}

/// C = local + k1·Crefl + k2·Crefr for each hit of the level's batch, which is then done; the
/// components are clamped to 0…1 where the profile says so. Without children `next` is not looked
/// at; where there is a sky beyond, they would have brought its colour.
template <class L, class R = typename L::Real, class Recorder = NoRecord>
void fold(const TraceSettings& settings, Level<R>& level, const Level<R>* next,
          const V3<R>* sky_beyond, const Recorder& record = {}) {
  using F = typename L::F;
  using I = typename L::I;
  const auto n = static_cast<std::size_t>(level.hit_count);
  const HitArrays<R>& hits = level.hits;
  for (std::size_t h = 0; h < n; h += L::kWidth) {
    V3<F> color{L::load(hits.r + h), L::load(hits.g + h), L::load(hits.b + h)};
    if (next != nullptr) {
      color = add_child<L>(color, hits.reflection + h, hits.reflected + h, next->rays);
      color = add_child<L>(color, hits.refraction + h, hits.refracted + h, next->rays);
    }
    if (sky_beyond != nullptr) {
      const V3<F> sky = broadcast<L>(*sky_beyond);
      color = color + sky * L::load(hits.reflection + h) + sky * L::load(hits.refraction + h);
    }
    record.keep(Quantity::unclamped, h, color);
    if (settings.clamp_levels) {
      const auto clamp = [](const F& c) { return min(max(c, F(0)), F(1)); };
      color = {clamp(color.x), clamp(color.y), clamp(color.z)};
    }
    const auto exists = L::first(n - h);
    const Indices<L> ray(L::load(hits.ray + h) + I(level.done));
    ray.store(color.x, exists, level.rays.r);
    ray.store(color.y, exists, level.rays.g);
    ray.store(color.z, exists, level.rays.b);
  }
  level.done += level.in_batch;
  record.folded(level);
  level.in_batch = 0;
}

}  // namespace zraka::ZRAKA_ISA
