// SPDX-License-Identifier: Apache-2.0
// One thread's memory for the engine.
#pragma once

#include <memory>

#include "engine/engine.hpp"

namespace zraka {

/// All the arrays of a Workspace in one allocation.
template <class R>
class WorkspaceMemory {
 public:
  /// For tiles of at most `batch` pixels and rays down to `max_depth`, with the arrays that
  /// textures need, or without; and with those that only explanations read.
  WorkspaceMemory(std::int32_t batch, int max_depth, bool textured, bool recorded = false);

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
