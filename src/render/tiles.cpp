// SPDX-License-Identifier: Apache-2.0
#include "render/tiles.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/handover.hpp"
#include "core/spread.hpp"
#include "core/threads.hpp"

namespace zraka {

bool each_tile(std::uint32_t picture_width, std::uint32_t picture_height, int tile, int threads,
               bool bind_threads, const std::atomic<bool>* cancel, TileFunction work) {
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
  if (threads == threads_here())
    undisturbed(work_on_all);
  else
    in_arena(threads, work_on_all);
  from_workers.take();
  // The last tiles may have been left unfinished.
  return !cancelled && !(cancel != nullptr && cancel->load(std::memory_order_relaxed));
}

}  // namespace zraka
