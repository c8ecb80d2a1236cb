// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion of the general engine.
#include "engine/general/shadows.hpp"
#include "sampling/hash.hpp"
#include "sampling/sobol.hpp"
#include "sampling/warp.hpp"

namespace zraka::general {

template <class R>
void find_occlusion(const Batch<R>& batch) {
  const FrozenOptics& optics = batch.optics();
  GeneralWorkspace<R>& general = batch.general;
  general.occlusion.assign(batch.hit_count(), V3<R>{R(0), R(0), R(0)});
  general.samples.assign(batch.hit_count(), 1);
  Listener<R>* const listener = general.listener;
  general.listener = nullptr;  // too much to tell
  const auto distance = static_cast<R>(std::fmin(optics.occlusion_distance, kFarthest));
  const auto settle = [&] {
    trace_waiting(batch);
    for (std::size_t i = 0; i < general.waiting.size(); ++i) {
      V3<R>& sum = general.occlusion[static_cast<std::size_t>(general.waiting[i].hit)];
      sum = sum + general.filter[i];
    }
    general.waiting.clear();
  };
  for (std::size_t h = 0; h < batch.hit_count(); ++h) {
    const R* const row = batch.row(h);
    if (row[kAmbient] == R(0) && row[kAmbient + 1] == R(0) && row[kAmbient + 2] == R(0)) continue;
    const RayState<R>& ray = batch.ray_of(h);
    const Sobol2 points(hash(ray.key, 0xA0u));
    const std::int32_t samples = general.samples[h] = samples_for(optics.occlusion_samples, ray);
    V3<double> a{}, b{};
    const V3<double> normal = batch.smooth_normal(h);
    const V3<R> origin = shadow_origin(batch, h);
    basis_of(normal, a, b);
    for (std::int32_t s = 0; s < samples; ++s) {
      const auto number = ray.sample * static_cast<std::uint32_t>(optics.occlusion_samples) +
                          static_cast<std::uint32_t>(s);
      const DiscPoint on = quick_concentric_disc(points[number]);
      const double up = std::sqrt(std::fmax(1 - on.x * on.x - on.y * on.y, 0.0));
      const V3<double> way = unit(a * on.x + b * on.y + normal * up);
      general.waiting.push_back(
          {static_cast<std::int32_t>(h), s, origin, narrowed<R>(way), distance, R(0), V3<R>{}});
      if (general.waiting.size() == general.shadow_room) settle();
    }
  }
  settle();
  general.listener = listener;
  const V3<R> color = narrowed<R>(optics.occlusion_color);
  for (std::size_t h = 0; h < batch.hit_count(); ++h)
    general.occlusion[h] =
        general.occlusion[h] * (R(1) / static_cast<R>(general.samples[h])) * color;
}

#define ZRAKA_FOR(R) template void find_occlusion(const Batch<R>&);
ZRAKA_FOR(float)
ZRAKA_FOR(double)
#undef ZRAKA_FOR

}  // namespace zraka::general
