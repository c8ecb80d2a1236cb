// SPDX-License-Identifier: Apache-2.0
// A picture's tiles over threads.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstdint>

#include "core/handover.hpp"
#include "engine/engine.hpp"

namespace zraka {

/// Small enough for the arrays of a tile's trees to stay in the second-level cache.
inline constexpr int kDefaultTile = 32;

/// Calls work(tile) for each tile of a picture, on so many threads of oneTBB. False if `cancel` was
/// set on the way.
template <class Work>
bool each_tile(std::uint32_t picture_width, std::uint32_t picture_height, int tile, int threads,
               const std::atomic<bool>* cancel, const Work& work) {
  const auto width = static_cast<std::int32_t>(picture_width);
  const auto height = static_cast<std::int32_t>(picture_height);
  const std::int32_t columns = (width + tile - 1) / tile;
  const std::int32_t rows = (height + tile - 1) / tile;
  std::atomic<bool> cancelled{false};
  Handover to_workers, from_workers;
  const auto work_on = [&](std::int32_t index) {
    to_workers.take();
    if (cancelled.load(std::memory_order_relaxed)) return;
    if (cancel != nullptr && cancel->load(std::memory_order_relaxed)) {
      cancelled = true;
      return;
    }
    const std::int32_t x = index % columns * tile, y = index / columns * tile;
    work(TileRect{x, y, std::min(tile, width - x), std::min(tile, height - y)});
    from_workers.give();
  };
  tbb::task_arena arena(threads);
  to_workers.give();
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::int32_t>(0, columns * rows),
        [&](const tbb::blocked_range<std::int32_t>& range) {
          for (std::int32_t i = range.begin(); i < range.end(); ++i) work_on(i);
        },
        tbb::simple_partitioner());
  });
  from_workers.take();
  return !cancelled;
}

}  // namespace zraka
