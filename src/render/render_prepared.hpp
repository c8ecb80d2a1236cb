// SPDX-License-Identifier: Apache-2.0
// The way from a frozen scene to its picture, for scenes that are frozen once and rendered often.
#pragma once

#include <algorithm>
#include <optional>
#include <zraka/render.hpp>

#include "core/threads.hpp"
#include "render/picture_job.hpp"
#include "render/prepare.hpp"

namespace zraka {

/// Traces the picture of a frozen scene into `rendering`; `scene` is read only where need_scene()
/// says so, `frozen` is the prepared one or a copy with another camera. False if it was cancelled.
template <class R>
bool render_prepared(const Scene* scene, const PreparedScene<R>& prepared,
                     const FrozenScene<R>& frozen, const Kernel<R>& kernel,
                     const RenderOptions& options, const Resolution& resolution, int threads,
                     const Variation& variation, const TileOfImage& tile_done,
                     Rendering& rendering);

/// As render(); tells of parts of the image that are done.
Result<Rendering> render_with_tiles(const Scene& scene, const RenderOptions& options,
                                    const TileOfImage& tile_done);
Result<Rendering> render_with_tiles(Scene&& scene, const RenderOptions& options,
                                    const TileOfImage& tile_done);

/// So many threads work where options say `wanted`: 0 means those of the caller's arena.
inline int threads_for(int wanted) {
  return std::clamp(wanted == 0 ? threads_here() : wanted, 1, kMaxThreads);
}

/// Calls work() in the caller's arena, or in one of so many threads if the caller wants another
/// number: nothing else in the program is held to it.
inline void with_threads(int wanted, FunctionRef<void()> work) {
  if (wanted == 0) return work();
  const int threads = threads_for(wanted);
  // Only a number that oneTBB has no threads for needs its leave.
  std::optional<ThreadLimit> limit;
  if (threads > processor_count()) limit.emplace(threads);
  in_arena(threads, work);
}

}  // namespace zraka
