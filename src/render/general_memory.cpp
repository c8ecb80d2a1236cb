// SPDX-License-Identifier: Apache-2.0
#include "render/general_memory.hpp"

#include <algorithm>

#include "scene/reals.hpp"

namespace zraka {

template <class R>
GeneralMemory<R>::GeneralMemory(std::int32_t batch, std::int32_t shadow_rays,
                                const FrozenScene<R>& scene, const TraceSettings& settings)
    : through_({.batch = batch,
                .max_depth = 0,
                .textured = scene.textures != nullptr,
                .general = true}) {
  const auto size = static_cast<std::size_t>(batch);
  const auto levels = static_cast<std::size_t>(settings.max_depth) + 1;
  const auto children = static_cast<std::size_t>(general::most_children(settings));
  workspace_.rays.resize(levels);
  workspace_.hits.resize(levels);
  workspace_.columns.resize(levels);
  if (has_media(*scene.optics)) workspace_.insides.resize(levels);
  for (std::size_t i = 0; i < levels; ++i) {
    const std::size_t rays = i == 0 ? size : size * children;
    workspace_.rays[i].resize(rays);
    workspace_.hits[i].resize(size);
    workspace_.columns[i].parents.reserve(size);
    if (scene.optics->fog.kind != Fog::Kind::none)
      workspace_.columns[i].clear.resize(size + kArrayPadding);
    if (!has_media(*scene.optics)) continue;
    workspace_.insides[i].resize(rays);
    for (std::vector<R>& channel : workspace_.columns[i].transmittance)
      channel.resize(size + kArrayPadding);
  }
  workspace_.blocked_hits.resize(size + kArrayPadding);
  if (has_media(*scene.optics)) workspace_.in_absorber.resize(size);
  for (std::vector<double>* numbers : {&workspace_.exponents, &workspace_.powers})
    numbers->resize(3 * size + kArrayPadding);
  const FrozenBodies& bodies = scene.bodies;
  workspace_.has_groups = std::any_of(bodies.type, bodies.type + bodies.count,
                                      [](std::int32_t type) { return type == kTypeInstance; });
  workspace_.draws =
      scene.optics->occlusion_samples > 0 ||
      std::any_of(scene.optics->lights, scene.optics->lights + scene.light_count,
                  [](const OpticalLight& light) { return light.kind >= LightKind::rectangle; });
  workspace_.through = through_.workspace().levels[0];
  workspace_.through_scratch = through_.workspace().scratch;
  workspace_.room = batch;
  workspace_.shadow_room = static_cast<std::size_t>(shadow_rays);
  workspace_.filter.reserve(workspace_.shadow_room);
  workspace_.of_waiting.resize(workspace_.shadow_room + kArrayPadding);
  for (std::vector<double>* of_hits : {&workspace_.distance, &workspace_.strength, &workspace_.l_n,
                                       &workspace_.cosine, &workspace_.highlight})
    of_hits->resize(size + kArrayPadding);
}

#define ZRAKA_FOR(R) template class GeneralMemory<R>;
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka
