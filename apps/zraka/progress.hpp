// SPDX-License-Identifier: Apache-2.0
// A progress bar on standard error, where somebody watches.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

namespace zraka::app {

/// Nothing is drawn if standard error is no terminal, or `quiet`, or in the first tenths of a
/// second.
class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// For RenderOptions::progress; empty where nothing is to be drawn.
  std::function<void(std::uint64_t, std::uint64_t, std::uint64_t)> callback();

  /// The bar's text: percent, rays a second, time left.
  static std::string line(double fraction, double rays_per_second, double seconds_left);

  /// Wipes the bar if one is shown. Safe in a signal handler.
  static void clear_line() noexcept;

 private:
  void update(std::uint64_t pixels, std::uint64_t all_pixels, std::uint64_t rays);

  bool shown_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::atomic<std::int64_t> next_draw_ms_{300};
};

}  // namespace zraka::app
