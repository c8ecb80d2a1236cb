// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion of the general engine.
#include "engine/general/shadows.hpp"
#include "sampling/hash.hpp"
#include "sampling/sobol.hpp"
#include "scene/reals.hpp"

namespace zraka::general {

namespace {

/// Adds to the hits what has arrived of all that wait.
template <class R>
void settle(const Batch<R>& batch) {
  GeneralWorkspace<R>& general = batch.general;
  const Scratch<R>& scratch = batch.scratch;
  const FrozenScene<R>* const deciding = deciding_scene(batch);
  if (deciding == nullptr) {
    trace_waiting(batch, Order::by_direction);
    for (std::size_t i = 0; i < general.waiting; ++i) {
      V3<R>& sum = general.occlusion[static_cast<std::size_t>(scratch.shadow_ray_hit[i])];
      sum = sum + general.filter[i];
    }
  } else {
    batch.counts.shadow += general.waiting;
    batch.services.find_blocked_from_points(*deciding, general.waiting, batch.scratch);
    for (std::size_t i = 0; i < general.waiting;) {
      const std::int32_t hit = scratch.shadow_ray_hit[i];
      std::int32_t free = 0;
      for (; i < general.waiting && scratch.shadow_ray_hit[i] == hit; ++i)
        free += 1 - scratch.blocked[i];
      general.occlusion[static_cast<std::size_t>(hit)].x += static_cast<R>(free);
    }
  }
  general.waiting = 0;
}

}  // namespace

template <class R>
void find_occlusion(const Batch<R>& batch) {
  const FrozenOptics& optics = batch.optics();
  GeneralWorkspace<R>& general = batch.general;
  Scratch<R>& scratch = batch.scratch;
  general.occlusion.assign(batch.hit_count(), V3<R>{R(0), R(0), R(0)});
  general.samples.assign(batch.hit_count(), 1);
  Listener<R>* const listener = general.listener;
  general.listener = nullptr;  // too much to tell
  std::fill_n(scratch.sdistance, general.shadow_room,
              static_cast<R>(std::fmin(optics.occlusion_distance, kFarthest)));
  for (std::size_t h = 0; h < batch.hit_count(); ++h) {
    const R* const row = batch.row(h);
    if (row[kAmbient] == R(0) && row[kAmbient + 1] == R(0) && row[kAmbient + 2] == R(0)) continue;
    const RayState<R>& ray = batch.ray_of(h);
    const Sobol2 points(hash(ray.key, 0xA0u));
    const std::int32_t samples = general.samples[h] = samples_for(optics.occlusion_samples, ray);
    const V3<R> normal = narrowed<R>(batch.smooth_normal(h));
    const std::uint32_t first = ray.sample * static_cast<std::uint32_t>(optics.occlusion_samples);
    for (std::size_t done = 0; done < static_cast<std::size_t>(samples);) {
      const std::size_t n = std::min(static_cast<std::size_t>(samples) - done,
                                     general.shadow_room - general.waiting);
      batch.services.make_hemisphere(points, first + static_cast<std::uint32_t>(done), n, normal,
                                     general.waiting, scratch);
      std::fill_n(scratch.shadow_ray_hit + general.waiting, n, static_cast<std::int32_t>(h));
      general.waiting += n;
      done += n;
      if (general.waiting == general.shadow_room) settle(batch);
    }
  }
  settle(batch);
  general.listener = listener;
  const V3<R> color = narrowed<R>(optics.occlusion_color);
  for (std::size_t h = 0; h < batch.hit_count(); ++h) {
    V3<R>& sum = general.occlusion[h];
    if (deciding_scene(batch) != nullptr) sum = {sum.x, sum.x, sum.x};
    sum = sum * (R(1) / static_cast<R>(general.samples[h])) * color;
  }
}

#define ZRAKA_FOR(R) template void find_occlusion(const Batch<R>&);
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka::general
