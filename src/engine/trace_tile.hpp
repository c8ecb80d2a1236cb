// SPDX-License-Identifier: Apache-2.0
// The whole flow: the ray trees of a tile's pixels, grown level by level and folded bottom-up. This
// is the sheet's TraceRay without its recursion; each step below is a file beside this one.
#pragma once

#include "engine/camera_rays.hpp"
#include "engine/coefficients.hpp"
#include "engine/engine.hpp"
#include "engine/fold.hpp"
#include "engine/hits.hpp"
#include "engine/light.hpp"
#include "engine/record.hpp"
#include "engine/rules.hpp"
#include "engine/spawn.hpp"
#include "engine/steps.hpp"

namespace zraka::ZRAKA_ISA {

/// Traces the next rays of a level, as many as a batch holds, and puts their children into `next`;
/// nullptr where rays have reached the greatest depth.
template <class L, class R = typename L::Real, class Recorder = NoRecord, class Stepping = Steps>
void trace_batch(const FrozenScene<R>& scene, const TraceSettings& settings, Level<R>& level,
                 Level<R>* next, Workspace<R>& workspace, RayCounts& counts,
                 const Recorder& record = {}, const Stepping& steps = {}) {
  const std::int32_t left = level.ray_count - level.done;
  level.in_batch = left < workspace.batch ? left : workspace.batch;

  trace_nearest<L>(scene, level, workspace.scratch, steps);
  counts.hits += static_cast<std::uint64_t>(level.hit_count);
  find_surfaces<L>(scene, level, workspace.scratch, steps);
  take_coefficients(scene, level, workspace.scratch, &color_hits<L>);
  light_hits<L>(scene, settings, level, workspace.scratch, counts, record, steps);

  if (settings.terms.silhouette) return;
  if (next == nullptr && settings.sky_beyond) find_shares<L>(settings, level, workspace.scratch);
  if (next == nullptr) return;
  if (!settings.terms.reflection && !settings.terms.refraction) return;
  steps.template spawn_reflected<L>(settings, level, workspace.scratch, *next, counts,
                                    record, steps);
  spawn_refracted<L>(level, workspace.scratch, *next, counts, record, steps);
  if (scene.textures != nullptr) spread_cones(level, workspace.scratch, *next);
  record.children(level, *next);
}

/// Grows and folds the trees of the rays in level 0. A batch has at most two children a ray, so a
/// level never holds more than two batches: memory is bounded by the depth, however the trees
/// branch.
template <class L, class R = typename L::Real, class Recorder = NoRecord, class Stepping = Steps>
void trace_trees(const FrozenScene<R>& scene, const TraceSettings& settings,
                 Workspace<R>& workspace, RayCounts& counts, const Recorder& record = {},
                 const Stepping& steps = {}) {
  // What children bring that are too deep to be traced.
  const V3<R>* const beyond =
      settings.sky_beyond && !settings.terms.silhouette ? &scene.background : nullptr;
  constexpr const V3<R>* kNothing = nullptr;
  for (int depth = 0;;) {
    Level<R>& level = workspace.levels[depth];
    if (level.done < level.ray_count) {
      Level<R>* next = depth < settings.max_depth ? &level + 1 : nullptr;
      if (next != nullptr) next->ray_count = next->done = 0;
      trace_batch<L>(scene, settings, level, next, workspace, counts, record, steps);
      if (next != nullptr && next->ray_count > 0 && record.goes_on())
        ++depth;  // the children first
      else
        fold<L>(settings, level, static_cast<Level<R>*>(nullptr),
                next == nullptr ? beyond : kNothing, record);
    } else if (depth > 0) {
      --depth;  // all the children's colours are known
      fold<L>(settings, workspace.levels[depth], &level, kNothing, record);
    } else {
      return;
    }
  }
}

template <class L, class R = typename L::Real, class Recorder = NoRecord, class Stepping = Steps>
void trace_tile(const FrozenScene<R>& scene, const TraceSettings& settings, const TileRect& tile,
                Workspace<R>& workspace, RayCounts& counts, float* pixels, std::size_t stride,
                const Recorder& record = {}, const Stepping& steps = {}) {
  Level<R>& top = workspace.levels[0];
  top.done = 0;
  make_camera_rays<L>(scene.camera, tile, top);
  if (scene.textures != nullptr) start_cones(scene.camera, top);
  counts.camera += static_cast<std::uint64_t>(top.ray_count);
  trace_trees<L>(scene, settings, workspace, counts, record, steps);

  std::size_t i = 0;
  each_pixel(tile, [&](std::int32_t x, std::int32_t y) {
    float* out = pixels + 3 * (static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x));
    out[0] = static_cast<float>(top.rays.r[i]);
    out[1] = static_cast<float>(top.rays.g[i]);
    out[2] = static_cast<float>(top.rays.b[i]);
    ++i;
  });
}

}  // namespace zraka::ZRAKA_ISA
