// SPDX-License-Identifier: Apache-2.0
// Listening to all tiles of a picture at once: a listener for each thread.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/threads.hpp"
#include "render/isa.hpp"
#include "render/prepare.hpp"
#include "render/tiles.hpp"

namespace zraka {

/// The instruction set that a picture is rendered with. Fails as render() does, and for the oracle.
inline Result<Isa> isa_to_listen_to(const Scene& scene, const RenderOptions& options) {
  Diagnostics problems = check_request(scene, options);
  if (!problems.empty()) return tl::make_unexpected(std::move(problems));
  Result<Isa> isa = choose_isa(options.isa);
  if (isa && *isa == Isa::oracle)
    return failure("", "the oracle's numbers are doubles, and no picture's: it explains nothing",
                   "ask for avx512, avx2 or portable");
  return isa;
}

/// make(batch) gives a listener that can take tiles with so many rays, read(listener, tile) lets it
/// listen to one; then all listeners, or none where options.cancel was set on the way.
template <class Listener, class Make, class Read>
std::optional<std::vector<std::unique_ptr<Listener>>> listen_to_tiles(const Resolution& size,
                                                                      const RenderOptions& options,
                                                                      const Make& make,
                                                                      const Read& read) {
  const int threads = options.threads == 0 ? processor_count() : options.threads;
  const int tile = options.tile == 0 ? chosen_tile(size.width, size.height, threads) : options.tile;
  const std::int32_t side = tile + (options.profile.average_corners ? 1 : 0);
  const ThreadLimit limit(threads);
  PerThread<std::unique_ptr<Listener>> of_threads([&] { return make(side * side); });
  if (!each_tile(size.width, size.height, tile, threads, options.bind_threads, options.cancel,
                 [&](const TileRect& rect) { read(*of_threads.local(), rect); }))
    return std::nullopt;
  std::vector<std::unique_ptr<Listener>> listeners;
  of_threads.each(
      [&](std::unique_ptr<Listener>& listener) { listeners.push_back(std::move(listener)); });
  return listeners;
}

}  // namespace zraka
