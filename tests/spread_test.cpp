// SPDX-License-Identifier: Apache-2.0
#include "core/spread.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace zraka {
namespace {

cpu_set_t processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  EXPECT_EQ(sched_getaffinity(0, sizeof(set), &set), 0);
  return set;
}

/// How many come, where only a broken function would not wait long enough for them.
int workers_that_come(int threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  return tbb::task_arena(threads).execute(
      [&] { return spread_workers(threads, std::chrono::minutes(1)); });
}

TEST(SpreadWorkers, BringsAWorkerForEachProcessor) {
  const cpu_set_t set = processors();
  const int all = CPU_COUNT(&set);
  EXPECT_EQ(workers_that_come(1), 0);
  EXPECT_EQ(workers_that_come(all), all - 1);
  EXPECT_EQ(workers_that_come(all + 1), 0) << "they would only wait for each other";
}

TEST(SpreadWorkers, LeavesEveryThreadAsFreeAsItWas) {
  const cpu_set_t before = processors();
  const int all = CPU_COUNT(&before);
  for (const int threads : {1, 2, all, all + 1, 40}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    arena.execute([&] {
      spread_workers(threads);
      std::atomic<int> bound = 0;
      tbb::parallel_for(0, 1000, [&](int) {
        const cpu_set_t now = processors();
        if (!CPU_EQUAL(&now, &before)) ++bound;
      });
      EXPECT_EQ(bound, 0) << threads;
    });
  }
}

// In a process of its own, as ctest runs it.
TEST(SpreadWorkers, LetsOneTbbCountAllProcessors) {
  const cpu_set_t all = processors();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(CPU_COUNT(&all)));
  spread_workers(CPU_COUNT(&all));
  EXPECT_EQ(tbb::info::default_concurrency(), CPU_COUNT(&all));
}

TEST(SpreadWorkers, KeepsToTheProcessorsThatItIsAllowed) {
  std::thread([] {
    const cpu_set_t all = processors();
    cpu_set_t one;
    CPU_ZERO(&one);
    for (std::size_t i = 0; i < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++i)
      if (CPU_ISSET(i, &all)) CPU_SET(i, &one);
    ASSERT_EQ(sched_setaffinity(0, sizeof(one), &one), 0);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 2);
    tbb::task_arena(2).execute([] { spread_workers(2); });
    const cpu_set_t after = processors();
    EXPECT_TRUE(CPU_EQUAL(&after, &one));
  }).join();
}

}  // namespace
}  // namespace zraka
