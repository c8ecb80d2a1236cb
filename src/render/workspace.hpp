// SPDX-License-Identifier: Apache-2.0
// One thread's memory for the engine.
#pragma once

#include <memory>

#include "engine/engine.hpp"

namespace zraka {

/// What arrays there must be.
struct WorkspaceNeeds {
  std::int32_t batch = 0;  ///< tiles of at most so many pixels
  int max_depth = 0;
  bool textured = false;
  bool recorded = false;  ///< with what only explanations read
  bool explained = false;  ///< Scratch::explained
  bool general = false;   ///< with what only the general engine uses
  std::int32_t shadow_rays = 0;  ///< at a time, if more than `batch`
  int children = 2;       ///< the most of one hit
};

/// All the arrays of a Workspace in one allocation.
template <class R>
class WorkspaceMemory {
 public:
  explicit WorkspaceMemory(const WorkspaceNeeds& needs);
  WorkspaceMemory(std::int32_t batch, int max_depth, bool textured, bool recorded = false)
      : WorkspaceMemory(WorkspaceNeeds{batch, max_depth, textured, recorded, recorded}) {}

  Workspace<R>& workspace() { return workspace_; }

 private:
  struct Free {
    void operator()(std::byte* p) const;
  };
  std::unique_ptr<std::byte[], Free> memory_;
  std::unique_ptr<Level<R>[]> levels_;
  Workspace<R> workspace_{};
};

}  // namespace zraka
