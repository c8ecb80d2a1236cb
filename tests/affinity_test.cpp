// SPDX-License-Identifier: Apache-2.0
// A library moves no thread to another processor unless it is asked to.
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>

#include "scenes.hpp"

namespace {
std::atomic<int> moves{0};
}

/// In place of the system's, for the library and for us: does the same, and counts.
extern "C" int sched_setaffinity(pid_t thread, std::size_t size, const cpu_set_t* set) noexcept {
  ++moves;
  return static_cast<int>(::syscall(SYS_sched_setaffinity, thread, size, set));
}

namespace zraka {
namespace {

int moves_while_rendering(bool bind_threads) {
  RenderOptions options{.threads = 2, .tile = 8};
  options.bind_threads = bind_threads;
  EXPECT_TRUE(render(lab_scene(200), options));  // oneTBB's own threads start here
  const int before = moves;
  EXPECT_TRUE(render(lab_scene(200), options));
  return moves - before;
}

TEST(Affinity, IsChangedOnlyWhereThatIsAskedFor) {
  cpu_set_t all;
  ASSERT_EQ(::sched_getaffinity(0, sizeof(all), &all), 0);
  EXPECT_EQ(moves_while_rendering(false), 0);
  // Two threads are not bound to two of many processors.
  if (CPU_COUNT(&all) == 2) {
    EXPECT_GT(moves_while_rendering(true), 0);
  }
}

}  // namespace
}  // namespace zraka
