// SPDX-License-Identifier: Apache-2.0
// Nearest hits of a batch of rays, and the surface at each (sheet 3.3 and 3.7).
#pragma once

#include <algorithm>
#include <limits>
#include <utility>

#include "accel/traverse.hpp"
#include "engine/engine.hpp"
#include "engine/indices.hpp"
#include "engine/load_rays.hpp"
#include "engine/rules.hpp"
#include "engine/surfaces.hpp"

namespace zraka::ZRAKA_ISA {

/// Puts hits on the same primitive beside each other, and those on primitives that stand together
/// in the hierarchy near each other: so do their shadow rays and children begin, and the lanes of a
/// register share their material. Nothing computed for a hit depends on its position.
template <class R>
void sort_hits(const Hierarchy& hierarchy, const Scratch<R>& scratch, std::size_t n,
               std::int32_t* rays) {
  std::int32_t* const keys = scratch.material;          // not in use yet
  std::int32_t* const sorted = scratch.shadow_ray_hit;  // nor this
  std::int32_t first = std::numeric_limits<std::int32_t>::max(), last = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::int32_t slot = scratch.slot[rays[i]];
    keys[i] = hierarchy.rank != nullptr ? hierarchy.rank[slot] : slot;
    first = std::min(first, keys[i]);
    last = std::max(last, keys[i]);
  }
  if (first == last) return;
  constexpr int kBuckets = 1024;
  int shift = 0;
  while ((last - first) >> shift >= kBuckets) ++shift;
  const auto bucket = [&](std::size_t i) { return (keys[i] - first) >> shift; };
  std::int32_t position[kBuckets];
  std::int32_t* const end = position + ((last - first) >> shift) + 1;
  std::fill(position, end, 0);
  for (std::size_t i = 0; i < n; ++i) ++position[bucket(i)];
  std::int32_t before = 0;
  for (std::int32_t* p = position; p != end; ++p) before += std::exchange(*p, before);
  for (std::size_t i = 0; i < n; ++i) sorted[position[bucket(i)]++] = rays[i];
  std::copy(sorted, sorted + n, rays);
}

/// Finds what each ray of the batch hits, lists those that hit something in hits.ray, and gives
/// the others the background's colour.
template <class L, class R = typename L::Real, class Ruling = Rules>
void trace_nearest(const FrozenScene<R>& scene, Level<R>& level, Scratch<R>& scratch,
                   const Ruling& rules = {}) {
  using F = typename L::F;
  using I = typename L::I;
  const auto begin = static_cast<std::size_t>(level.done);
  const auto n = static_cast<std::size_t>(level.in_batch);
  std::size_t hits = 0;
  for (std::size_t first = 0; first < n; first += RayGroup<L>::kRays) {
    RayGroup<L> rays(first, n, [&](std::size_t i) { return load_rays<L>(level.rays, begin + i); });
    rules.template find_nearest<L>(scene, rays);
    each_register(rays, first, n, [&](std::size_t i, const RayLanes<L>& ray, typename L::M active) {
      const auto hit = both(ray.slot >= I(0), active);
      L::store(ray.t, scratch.t + i);
      L::store(ray.slot, scratch.slot + i);
      L::store(F(scene.background.x), level.rays.r + begin + i);
      L::store(F(scene.background.y), level.rays.g + begin + i);
      L::store(F(scene.background.z), level.rays.b + begin + i);
      L::compress_store(L::iota(static_cast<std::int32_t>(i)), hit, level.hits.ray + hits);
      hits += count(hit);
    });
  }
  level.hit_count = static_cast<std::int32_t>(hits);
  if (L::kWidth > 1 && hits > L::kWidth && scene.hierarchy.nodes != nullptr)
    sort_hits(scene.hierarchy, scratch, hits, level.hits.ray);
}

/// Point, normal towards the viewer, and material of each hit.
template <class L, class R = typename L::Real, class Ruling = Rules>
void find_surfaces(const FrozenScene<R>& scene, const Level<R>& level, Scratch<R>& scratch,
                   const Ruling& rules = {}) {
  using F = typename L::F;
  using I = typename L::I;
  const auto n = static_cast<std::size_t>(level.hit_count);
  const R *ox = level.rays.ox + level.done, *oy = level.rays.oy + level.done,
          *oz = level.rays.oz + level.done, *dx = level.rays.dx + level.done,
          *dy = level.rays.dy + level.done, *dz = level.rays.dz + level.done;
  for (std::size_t h = 0; h < n; h += L::kWidth) {
    const Indices<L> ray(
        select(L::first(n - h), L::load(level.hits.ray + h), I(level.hits.ray[h])));
    const V3<F> origin{ray.load(ox), ray.load(oy), ray.load(oz)};
    const V3<F> direction{ray.load(dx), ray.load(dy), ray.load(dz)};
    const auto [surface, material] =
        surfaces_at<L>(scene, ray.load(scratch.slot), origin, direction, ray.load(scratch.t),
                       scratch.paths == nullptr ? nullptr : scratch.paths + h);

    // The normal is turned to the side that the ray comes from (sheet 3.7).
    const auto inside = surface.inside;
    const V3<F> n_view = rules.seen_normal(surface.normal, inside);
    L::store(surface.point.x, scratch.px + h);
    L::store(surface.point.y, scratch.py + h);
    L::store(surface.point.z, scratch.pz + h);
    L::store(n_view.x, scratch.nx + h);
    L::store(n_view.y, scratch.ny + h);
    L::store(n_view.z, scratch.nz + h);
    L::store(-direction.x, scratch.vx + h);
    L::store(-direction.y, scratch.vy + h);
    L::store(-direction.z, scratch.vz + h);
    L::store(rules.offset(surface.offset), scratch.offset + h);
    L::store(select(inside, F(1), F(0)), scratch.inside + h);
    L::store(select(surface.behind, F(-1), F(1)), scratch.mirror_side + h);
    L::store(material, scratch.material + h);
  }
}

}  // namespace zraka::ZRAKA_ISA
