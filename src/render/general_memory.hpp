// SPDX-License-Identifier: Apache-2.0
// One thread's memory for the general engine, beside its workspace.
#pragma once

#include "engine/general/general.hpp"
#include "render/workspace.hpp"

namespace zraka {

template <class R>
class GeneralMemory {
 public:
  /// For batches of so many rays, and so many shadow rays at a time.
  GeneralMemory(std::int32_t batch, std::int32_t shadow_rays, const FrozenScene<R>& scene,
                const TraceSettings& settings);

  general::GeneralWorkspace<R>& workspace() { return workspace_; }

 private:
  WorkspaceMemory<R> through_;
  general::GeneralWorkspace<R> workspace_{};
};

}  // namespace zraka
