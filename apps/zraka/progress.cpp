// SPDX-License-Identifier: Apache-2.0
#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace zraka::app {
namespace {

constexpr std::int64_t kBetweenDrawsMs = 100;
std::atomic<bool> line_is_shown{false};

void write_to_terminal(std::string_view text) {
  // A bar that cannot be drawn is no reason to stop.
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

std::string duration(double seconds) {
  const auto whole = static_cast<std::uint64_t>(seconds < 1e6 ? seconds + 0.5 : 1e6);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  return fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

}  // namespace

Progress::Progress(bool quiet) {
  const char* terminal = std::getenv("TERM");
  shown_ = !quiet && ::isatty(STDERR_FILENO) == 1 && terminal != nullptr &&
           std::string_view(terminal) != "dumb";
}

Progress::~Progress() {
  clear_line();
}

std::function<void(std::uint64_t, std::uint64_t, std::uint64_t)> Progress::callback() {
  if (!shown_) return {};
  return [this](std::uint64_t pixels, std::uint64_t all_pixels, std::uint64_t rays) {
    update(pixels, all_pixels, rays);
  };
}

std::string Progress::line(double fraction, double rays_per_second, double seconds_left) {
  constexpr int kWidth = 24;
  const int filled = static_cast<int>(fraction * kWidth);
  std::string bar;
  for (int i = 0; i < kWidth; ++i) bar += i < filled ? "█" : "░";
  return fmt::format("{} {:3.0f} %  {:.1f} M rays/s  {} left", bar, fraction * 100,
                     rays_per_second / 1e6, duration(seconds_left));
}

void Progress::clear_line() noexcept {
  if (line_is_shown.exchange(false)) write_to_terminal("\r\x1b[K");
}

void Progress::update(std::uint64_t pixels, std::uint64_t all_pixels, std::uint64_t rays) {
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const auto now_ms = static_cast<std::int64_t>(seconds * 1000);
  std::int64_t due = next_draw_ms_.load();
  // Of the threads that find a drawing due, one draws.
  if (now_ms < due || !next_draw_ms_.compare_exchange_strong(due, now_ms + kBetweenDrawsMs)) return;
  const double fraction = static_cast<double>(pixels) / static_cast<double>(all_pixels);
  line_is_shown = true;
  write_to_terminal("\r\x1b[K" + line(fraction, static_cast<double>(rays) / seconds,
                                      seconds * (1 - fraction) / fraction));
}

}  // namespace zraka::app
