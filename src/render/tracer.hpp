// SPDX-License-Identifier: Apache-2.0
// Rays that stand in level 0 of a workspace, traced by the engine that the scene needs: the
// kernel's, or the general one.
#pragma once

#include <algorithm>
#include <optional>

#include "render/general_memory.hpp"

namespace zraka {

/// So many shadow rays are sorted by direction: enough for neighbours to be found, few enough for
/// the second-level cache.
inline constexpr std::int32_t kWaitingShadowRays = 8192;

/// One thread's memory for either engine.
template <class R>
struct TracerMemory {
  WorkspaceMemory<R> memory;
  std::optional<GeneralMemory<R>> general;

  TracerMemory(std::int32_t batch, const FrozenScene<R>& scene, const TraceSettings& settings,
               bool recorded = false)
      : memory({.batch = batch,
                .max_depth = settings.max_depth,
                .textured = scene.textures != nullptr,
                // Rays leave bumps along the normal before it was bent.
                .recorded = recorded || (scene.optics != nullptr && scene.textures != nullptr),
                .explained = recorded,
                .general = scene.optics != nullptr,
                .shadow_rays = scene.optics == nullptr ? 0 : kWaitingShadowRays,
                .children = scene.optics == nullptr ? 2 : general::most_children(settings)}) {
    if (scene.optics != nullptr)
      general.emplace(batch, std::max(batch, kWaitingShadowRays), scene, settings);
  }
  Workspace<R>& workspace() { return memory.workspace(); }
};

/// As Kernel::trace_rays().
template <class R>
void trace_rays(const Kernel<R>& kernel, const FrozenScene<R>& scene, const TraceSettings& settings,
                TracerMemory<R>& memory, RayCounts& counts) {
  if (memory.general)
    general::trace_rays(scene, settings, *kernel.services, memory.workspace(),
                        memory.general->workspace(), counts);
  else
    kernel.trace_rays(scene, settings, memory.workspace(), counts);
}

}  // namespace zraka
