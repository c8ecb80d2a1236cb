// SPDX-License-Identifier: Apache-2.0
#include "progress.hpp"

#include <gtest/gtest.h>

namespace zraka::app {
namespace {

TEST(Progress, SaysPercentSpeedAndTimeLeft) {
  EXPECT_EQ(Progress::line(0.5, 12.34e6, 42),
            "████████████░░░░░░░░░░░░  50 %  12.3 M rays/s  42 s left");
  EXPECT_EQ(Progress::line(1, 1e6, 0), "████████████████████████ 100 %  1.0 M rays/s  0 s left");
  EXPECT_EQ(Progress::line(0, 1e6, 61),
            "░░░░░░░░░░░░░░░░░░░░░░░░   0 %  1.0 M rays/s  1:01 min left");
  EXPECT_EQ(Progress::line(0, 1e6, 7260),
            "░░░░░░░░░░░░░░░░░░░░░░░░   0 %  1.0 M rays/s  2:01 h left");
}

TEST(Progress, IsSilentWhereNobodyWatches) {
  Progress progress(false);  // the tests' standard error is no terminal with a name
  EXPECT_FALSE(Progress(true).callback());
}

}  // namespace
}  // namespace zraka::app
