// SPDX-License-Identifier: Apache-2.0
// oneTBB's threads: how many, where they work, and what each has for itself.
#pragma once

#include <functional>
#include <memory>

#include "core/function_ref.hpp"

namespace zraka {

/// As many as oneTBB has threads for.
int processor_count();
/// As many as the caller's arena may have.
int threads_here();
/// As many as a ThreadLimit leaves.
int threads_allowed();

/// Calls work() in an arena of so many threads.
void in_arena(int threads, FunctionRef<void()> work);

/// Calls work() so that the caller, while it waits for parts of it, takes up nothing else.
void undisturbed(FunctionRef<void()> work);

/// The whole program has at most so many threads, or leave for so many, as long as this lives.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Something for each thread that asks for it.
class ThreadSlots {
 public:
  using Slot = std::unique_ptr<void, void (*)(void*)>;
  explicit ThreadSlots(std::function<Slot()> make);
  ~ThreadSlots();
  ThreadSlots(const ThreadSlots&) = delete;
  ThreadSlots& operator=(const ThreadSlots&) = delete;

  /// The calling thread's, which is made if it has none.
  void* local();
  /// Those of all threads.
  void each(FunctionRef<void(void*)> look) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// A T for each thread that asks for it.
template <class T>
class PerThread {
 public:
  PerThread() : PerThread([] { return T(); }) {}
  /// make() returns one.
  template <class Make>
  explicit PerThread(const Make& make)
      : slots_([make] {
          return ThreadSlots::Slot(new T(make()), [](void* t) { delete static_cast<T*>(t); });
        }) {}

  T& local() { return *static_cast<T*>(slots_.local()); }
  template <class Look>
  void each(const Look& look) const {
    slots_.each([&](void* t) { look(*static_cast<T*>(t)); });
  }

 private:
  ThreadSlots slots_;
};

}  // namespace zraka
