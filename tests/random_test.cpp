// SPDX-License-Identifier: Apache-2.0
// Random numbers are the same everywhere, and none is drawn more often than another.
#include "core/random.hpp"

#include <gtest/gtest.h>

#include <map>
#include <vector>

namespace zraka {
namespace {

TEST(Random, IsSplitMix64) {
  Random random(1234567);
  for (const std::uint64_t want :
       {6457827717110365317u, 3203168211198807973u, 9817491932198370423u})
    EXPECT_EQ(random.next(), want);
}

TEST(Random, FavoursNoNumber) {
  Random random(5);
  // Of 2^64 numbers a third would be drawn twice as often without drawing again.
  const std::uint64_t n = (std::uint64_t{3} << 62) + 1;
  int low = 0;
  for (int i = 0; i < 4000; ++i) {
    const std::uint64_t drawn = random.below(n);
    ASSERT_LT(drawn, n);
    low += drawn < n / 3;
  }
  EXPECT_NEAR(low, 4000 / 3.0, 150);
  EXPECT_EQ(random.below(1), 0u);
}

TEST(Random, ShufflesIntoEveryOrder) {
  Random random(2);
  std::map<std::vector<int>, int> seen;
  for (int i = 0; i < 6000; ++i) {
    std::vector<int> list{1, 2, 3};
    random.shuffle(list);
    ++seen[list];
  }
  EXPECT_EQ(seen.size(), 6u);
  for (const auto& [order, times] : seen) EXPECT_NEAR(times, 1000, 150);
}

}  // namespace
}  // namespace zraka
