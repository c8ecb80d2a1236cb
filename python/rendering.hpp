// SPDX-License-Identifier: Apache-2.0
// Pictures for Python: options by keyword, NumPy's memory, and a thread that can be interrupted.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "arguments.hpp"

namespace zraka::python {

/// What all pictures have as keywords; None is what the scene says.
struct Keywords {
  py::object samples, depth, threads, transparent, outlines, progress, dtype;
};

/// Raises ValueError where there is nothing to be seen from there.
View view_of(const py::object& eye, const py::object& target, const py::object& fov,
             const py::object& up, const Resolution& resolution);

RenderOptions options_of(const RenderDefaults& defaults, const Keywords& keywords);

/// An array of height × width × 3 or 4, and the buffer that it is.
struct Picture {
  py::array array;
  PixelBuffer buffer;
};
Picture new_picture(const Resolution& size, const Keywords& keywords, bool transparent);

/// Calls work(options) in a thread of its own, without Python's lock, while this one tells
/// `progress` how far it is and looks for Ctrl-C, which cancels it.
template <class Work>
auto interruptible(RenderOptions options, const py::object& progress, const Work& work)
    -> decltype(work(options)) {
  using namespace std::chrono_literals;
  std::atomic<bool> cancel{false};
  std::atomic<std::uint64_t> done{0}, all{0};
  options.cancel = &cancel;
  if (!progress.is_none())
    options.progress = [&](std::uint64_t pixels, std::uint64_t of, std::uint64_t) {
      std::uint64_t before = done.load();
      while (before < pixels && !done.compare_exchange_weak(before, pixels)) {
      }
      all = of;
    };
  std::optional<decltype(work(options))> result;
  std::exception_ptr thrown;
  std::mutex mutex;
  std::condition_variable changed;
  bool ended = false;
  std::thread thread([&] {
    try {
      result.emplace(work(options));
    } catch (...) {
      thrown = std::current_exception();
    }
    const std::lock_guard lock(mutex);
    ended = true;
    changed.notify_one();
  });
  std::uint64_t told = 0;
  const auto tell = [&] {
    const std::uint64_t now = done.load();
    if (progress.is_none() || now == told) return;
    told = now;
    progress(now, all.load());
  };
  std::exception_ptr from_python;
  for (bool finished = false; !finished;) {
    {
      const py::gil_scoped_release release;
      std::unique_lock lock(mutex);
      finished = changed.wait_for(lock, 50ms, [&] { return ended; });
    }
    if (from_python) continue;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      tell();
    } catch (...) {
      from_python = std::current_exception();
      cancel = true;
    }
  }
  thread.join();
  if (from_python) std::rethrow_exception(from_python);
  if (thrown) std::rethrow_exception(thrown);
  return std::move(*result);
}

}  // namespace zraka::python
