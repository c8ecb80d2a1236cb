// SPDX-License-Identifier: Apache-2.0
// Tiles cover a picture once, with any size and any number of threads.
#include "render/tiles.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace zraka {
namespace {

TEST(Tiles, AreLargeWhereEveryThreadGetsSixteen) {
  EXPECT_EQ(chosen_tile(48 * 16, 48, 1), 48);
  EXPECT_EQ(chosen_tile(48 * 16 - 1, 48, 1), 32);
  EXPECT_EQ(chosen_tile(48 * 16, 48, 2), 32);
  EXPECT_EQ(chosen_tile(512, 512, 7), 48);
  EXPECT_EQ(chosen_tile(512, 512, 8), 32);
  EXPECT_EQ(chosen_tile(1, 1, 64), 32);
  EXPECT_EQ(chosen_tile(1u << 20, 1u << 20, 4096), 48) << "more pixels than 32 bits count";
}

TEST(Tiles, CoverEveryPixelOnce) {
  for (const int tile : {1, 7, 32, 64})
    for (const int threads : {1, 2}) {
      constexpr std::uint32_t kWidth = 65, kHeight = 31;
      std::vector<std::atomic<int>> times(kWidth * kHeight);
      EXPECT_TRUE(
          each_tile(kWidth, kHeight, tile, threads, false, nullptr, [&](const TileRect& rect) {
            for (std::int32_t y = rect.y; y < rect.y + rect.height; ++y)
              for (std::int32_t x = rect.x; x < rect.x + rect.width; ++x)
                ++times.at(static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x));
          }));
      for (const std::atomic<int>& one : times) ASSERT_EQ(one, 1) << tile << ", " << threads;
    }
}

TEST(Tiles, EndEarlyWhereThatIsWanted) {
  std::atomic<bool> cancel{false};
  std::atomic<int> tiles{0};
  EXPECT_FALSE(each_tile(640, 640, 10, 2, false, &cancel, [&](const TileRect&) {
    if (++tiles == 5) cancel = true;
  }));
  EXPECT_LT(tiles, 8);
}

}  // namespace
}  // namespace zraka
