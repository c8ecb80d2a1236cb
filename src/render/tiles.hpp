// SPDX-License-Identifier: Apache-2.0
// A picture's tiles over threads.
#pragma once

#include <atomic>
#include <cstdint>

#include "core/function_ref.hpp"
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
using TileFunction = FunctionRef<void(const TileRect& tile)>;
bool each_tile(std::uint32_t picture_width, std::uint32_t picture_height, int tile, int threads,
               bool bind_threads, const std::atomic<bool>* cancel, TileFunction work);

}  // namespace zraka
