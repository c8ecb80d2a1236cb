// SPDX-License-Identifier: Apache-2.0
#include "core/spread.hpp"

#include <sched.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace zraka {
namespace {

/// The processors that the calling thread may run on, which are put back at the end of its life.
class Processors {
 public:
  Processors() : known_(::sched_getaffinity(0, sizeof(all_), &all_) == 0) {}
  ~Processors() {
    if (moved_) ::sched_setaffinity(0, sizeof(all_), &all_);
  }
  Processors(const Processors&) = delete;
  Processors& operator=(const Processors&) = delete;

  /// 0 if not known.
  int count() const { return known_ ? CPU_COUNT(&all_) : 0; }

  /// Moves the calling thread to one of them.
  void move_to(int processor) {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(static_cast<std::size_t>(processor), &one);
    moved_ = ::sched_setaffinity(0, sizeof(one), &one) == 0;
  }

  /// Moves it to the one that comes `index` + 1 after another, in a circle.
  void move_away_from(int other, int index) {
    for (int step = 1; known_ && step < CPU_SETSIZE; ++step) {
      const int processor = (other + step) % CPU_SETSIZE;
      if (CPU_ISSET(static_cast<std::size_t>(processor), &all_) && index-- == 0)
        return move_to(processor);
    }
  }

 private:
  cpu_set_t all_{};
  bool known_, moved_ = false;
};

/// Says that it is over, however that came.
struct AtEnd {
  std::atomic<bool>& over;
  ~AtEnd() { over = true; }
};

}  // namespace

int spread_workers(int threads, std::chrono::microseconds patience) {
  const int workers = threads - 1;
  if (workers < 1) return 0;
  // oneTBB counts the processors once, and must not do so while this thread is bound to one.
  (void)tbb::info::default_concurrency();
  Processors mine;
  if (threads > mine.count()) return 0;  // they would only wait for each other
  const int here = ::sched_getcpu();
  const bool one_each = here >= 0 && mine.count() == threads;
  // Else a thread that wakes goes to where the one that woke it is; so until all tasks have ended.
  if (one_each) mine.move_to(here);

  // Isolated, for a thread that is bound must not begin with other work of its arena.
  std::atomic<int> come = 0;
  tbb::this_task_arena::isolate([&] {
    std::mutex mutex;
    std::condition_variable changed;
    std::atomic<bool> over = false;
    tbb::task_group group;
    {
      const AtEnd end{over};
      for (int i = 0; i < workers; ++i)
        group.run([&] {
          if (over) return;
          {
            const std::lock_guard<std::mutex> lock(mutex);
            const int index = come++;
            if (one_each) Processors().move_away_from(here, index);
            changed.notify_one();
          }
          // A worker that left now might come twice.
          while (!over && come < workers) std::this_thread::yield();
        });
      std::unique_lock<std::mutex> lock(mutex);
      changed.wait_for(lock, patience, [&] { return come == workers; });
    }
    group.wait();
  });
  return come;
}

}  // namespace zraka
