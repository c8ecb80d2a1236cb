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
#include "core/spread.hpp"
#include "engine/engine.hpp"

namespace zraka {

/// So many tiles a thread are worth waiting for the thread.
inline constexpr std::uint64_t kTilesPerThread = 16;

/// Side of a picture's tiles where none is asked for: the larger a tile, the more of its rays find
/// company on their way; small enough for the arrays of its trees to stay in the second-level
/// cache, and for every thread to have some.
inline int chosen_tile(std::uint32_t width, std::uint32_t height, int threads) {
  constexpr int kLarge = 48, kSmall = 32;
  const std::uint64_t tiles = std::uint64_t{width} * height / (kLarge * kLarge);
  return tiles >= kTilesPerThread * static_cast<std::uint64_t>(threads) ? kLarge : kSmall;
}

/// Calls work(tile) for each tile of a picture, on so many threads of oneTBB: the caller's arena if
/// it has as many. False if `cancel` was set on the way.
template <class Work>
bool each_tile(std::uint32_t picture_width, std::uint32_t picture_height, int tile, int threads,
               bool bind_threads, const std::atomic<bool>* cancel, const Work& work) {
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
  const auto work_on_all = [&] {
    if (bind_threads && threads > 1 &&
        static_cast<std::uint64_t>(columns * rows) >=
            kTilesPerThread * static_cast<std::uint64_t>(threads))
      spread_workers(threads);
    tbb::parallel_for(
        tbb::blocked_range<std::int32_t>(0, columns * rows),
        [&](const tbb::blocked_range<std::int32_t>& range) {
          for (std::int32_t i = range.begin(); i < range.end(); ++i) work_on(i);
        },
        tbb::simple_partitioner());
  };
  to_workers.give();
  // A caller's arena has the threads and processors that it wants; while it waits for tiles, it
  // takes up no other work there.
  if (threads == tbb::this_task_arena::max_concurrency())
    tbb::this_task_arena::isolate(work_on_all);
  else
    tbb::task_arena(threads).execute(work_on_all);
  from_workers.take();
  // The last tiles may have been left unfinished.
  return !cancelled && !(cancel != nullptr && cancel->load(std::memory_order_relaxed));
}

}  // namespace zraka
