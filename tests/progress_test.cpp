// SPDX-License-Identifier: Apache-2.0
#include "progress.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

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

/// Whether a bar is drawn, where standard error is this file and TERM says that.
bool draws(int standard_error, const char* terminal, bool quiet) {
  const int kept = ::dup(STDERR_FILENO);
  EXPECT_EQ(::dup2(standard_error, STDERR_FILENO), STDERR_FILENO);
  EXPECT_EQ(terminal != nullptr ? ::setenv("TERM", terminal, 1) : ::unsetenv("TERM"), 0);
  const bool draws = static_cast<bool>(Progress(quiet).callback());
  EXPECT_EQ(::dup2(kept, STDERR_FILENO), STDERR_FILENO);
  ::close(kept);
  return draws;
}

TEST(Progress, IsSilentWhereNobodyWatches) {
  const int outside = ::posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(outside, 0);
  ASSERT_EQ(::grantpt(outside), 0);
  ASSERT_EQ(::unlockpt(outside), 0);
  const int terminal = ::open(::ptsname(outside), O_RDWR | O_NOCTTY);
  ASSERT_GE(terminal, 0);
  const int file = ::open("/dev/null", O_WRONLY);
  EXPECT_TRUE(draws(terminal, "xterm", false));
  EXPECT_FALSE(draws(terminal, "xterm", true));
  EXPECT_FALSE(draws(terminal, "dumb", false));
  EXPECT_FALSE(draws(terminal, nullptr, false));
  EXPECT_FALSE(draws(file, "xterm", false));
  for (const int each : {file, terminal, outside}) ::close(each);
}

}  // namespace
}  // namespace zraka::app
