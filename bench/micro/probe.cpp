// SPDX-License-Identifier: Apache-2.0
#include "probe.hpp"

#include "accel/traverse.hpp"
#include "engine/trace_tile.hpp"
#include "math/power.hpp"

namespace zraka::ZRAKA_ISA {
namespace {

using L = WideLanes;
using F = L::F;
using micro::Rays;

RayLanes<L> ray_at(const Rays& rays, std::size_t i, float far) {
  return {{L::load(rays.ox + i), L::load(rays.oy + i), L::load(rays.oz + i)},
          {L::load(rays.dx + i), L::load(rays.dy + i), L::load(rays.dz + i)},
          F(far),
          L::I(-1)};
}

template <class Shape>
void intersect(const float* numbers, const Rays& rays, float* t) {
  constexpr int kReals = ShapeTraits<Shape>::kHitReals;
  F shape[kReals];
  for (int k = 0; k < kReals; ++k) shape[k] = F(numbers[k]);
  for (std::size_t i = 0; i < rays.count; i += L::kWidth) {
    const RayLanes<L> ray = ray_at(rays, i, 0);
    L::store(ShapeLanes<Shape, L>::intersect(shape, ray.origin, ray.direction), t + i);
  }
}

RayGroup<L> group_at(const Rays& rays, std::size_t first, float far) {
  return RayGroup<L>(first, rays.count, [&](std::size_t i) { return ray_at(rays, i, far); });
}

std::size_t nearest(const FrozenScene<float>& scene, const Rays& rays) {
  std::size_t hits = 0;
  for (std::size_t first = 0; first < rays.count; first += RayGroup<L>::kRays) {
    RayGroup<L> group = group_at(rays, first, kFarAway<float>);
    find_nearest<L>(scene, group);
    for (std::size_t r = 0; r < kRegisters<L>; ++r)
      hits += count(both(group.active[r], group.ray[r].slot >= L::I(0)));
  }
  return hits;
}

std::size_t blocked(const FrozenScene<float>& scene, const Rays& rays, float far) {
  std::size_t hits = 0;
  LastBlocker last;
  for (std::size_t first = 0; first < rays.count; first += RayGroup<L>::kRays) {
    RayGroup<L> group = group_at(rays, first, far);
    hits += static_cast<std::size_t>(__builtin_popcount(find_blocked<L>(scene, last, group)));
  }
  return hits;
}

void powers(const float* x, const float* n, float* out, std::size_t count) {
  for (std::size_t i = 0; i < count; i += L::kWidth)
    L::store(power(L::load(x + i), L::load(n + i)), out + i);
}

void hits(const FrozenScene<float>& scene, const TileRect& tile, Workspace<float>& workspace) {
  Level<float>& level = workspace.levels[0];
  level.done = 0;
  make_camera_rays<L>(scene.camera, tile, level);
  level.in_batch = level.ray_count;
  trace_nearest<L>(scene, level, workspace.scratch);
}

void surfaces(const FrozenScene<float>& scene, Workspace<float>& workspace) {
  find_surfaces<L>(scene, workspace.levels[0], workspace.scratch);
  take_coefficients(scene, workspace.levels[0], workspace.scratch);
}

void light(const FrozenScene<float>& scene, const TraceSettings& settings,
           Workspace<float>& workspace) {
  RayCounts counts;
  light_hits<L>(scene, settings, workspace.levels[0], workspace.scratch, counts, NoRecord{},
                Steps{});
}

void spawn(const FrozenScene<float>&, const TraceSettings& settings,
           Workspace<float>& workspace) {
  RayCounts counts;
  Level<float>&level = workspace.levels[0], &next = workspace.levels[1];
  next.ray_count = next.done = 0;
  spawn_reflected<L>(settings, level, workspace.scratch, next, counts);
  spawn_refracted<L>(level, workspace.scratch, next, counts);
}

void fold_level(const TraceSettings& settings, Workspace<float>& workspace) {
  Level<float>& level = workspace.levels[0];
  level.done = 0;
  level.in_batch = level.ray_count;
  fold<L>(settings, level, &workspace.levels[1], static_cast<const V3<float>*>(nullptr));
}

}  // namespace

micro::Probe probe();
micro::Probe probe() {
  micro::Probe probe;
#define ZRAKA_INTERSECT(Type, plural) probe.intersect[kKindOf##Type] = intersect<Type>;
  ZRAKA_INLINED_KINDS(ZRAKA_INTERSECT)
#undef ZRAKA_INTERSECT
  probe.nearest = nearest;
  probe.blocked = blocked;
  probe.power = powers;
  probe.hits = hits;
  probe.surfaces = surfaces;
  probe.light = light;
  probe.spawn = spawn;
  probe.fold = fold_level;
  return probe;
}

}  // namespace zraka::ZRAKA_ISA
