// SPDX-License-Identifier: Apache-2.0
// Whose threads are left where they are: a library binds none unless it is asked to.
#include <gtest/gtest.h>
#include <sched.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <mutex>
#include <set>

#include "scenes.hpp"

namespace zraka {
namespace {

/// How many processors the calling thread may run on.
int processors() {
  cpu_set_t set;
  return ::sched_getaffinity(0, sizeof(set), &set) == 0 ? CPU_COUNT(&set) : 0;
}

/// The fewest processors that a thread may run on that calls back from a render.
int fewest_while_rendering(bool bind_threads) {
  Scene scene = lab_scene(300);
  RenderOptions options{.tile = 8};
  options.bind_threads = bind_threads;
  std::mutex mutex;
  int fewest = processors();
  options.progress = [&](std::uint64_t, std::uint64_t, std::uint64_t) {
    const std::lock_guard<std::mutex> lock(mutex);
    fewest = std::min(fewest, processors());
  };
  EXPECT_TRUE(render(scene, options));
  return fewest;
}

TEST(Affinity, OfNoThreadIsChangedUnlessAskedFor) {
  if (processors() < 2) GTEST_SKIP() << "there is one processor only";
  EXPECT_EQ(fewest_while_rendering(false), processors());
}

TEST(Affinity, IsOneProcessorEachWhereThatIsAskedFor) {
  if (processors() < 2 || processors() > 64) GTEST_SKIP() << "threads are bound on few processors";
  const int before = processors();
  EXPECT_EQ(fewest_while_rendering(true), 1);
  EXPECT_EQ(processors(), before) << "the caller's thread gets its own back";
}

}  // namespace
}  // namespace zraka
