// SPDX-License-Identifier: Apache-2.0
// OpenEXR's reader against files that its own library wrote, and files that mean harm.
#include <gtest/gtest.h>

#include <zraka/image.hpp>

#include "picture_files.hpp"

namespace zraka {
namespace {

TEST(ReadExr, ReadsHalvesAndFloatsOfEveryLosslessCompression) {
  for (const bool half : {false, true})
    for (const bool tiled : {false, true})
      for (const int compression : {0, 1, 2, 3, 4}) {
        const ExrKind kind{.channels = {"A", "B", "G", "R", "Z"},
                           .half = half,
                           .tiled = tiled,
                           .compression = compression};
        const Result<ReadImage> read = parse_image(exr_file(kind, exr_sample), "a");
        ASSERT_TRUE(read) << to_string(read.error().front());
        EXPECT_EQ(read->format, "OpenEXR");
        EXPECT_EQ(read->bits, half ? 16 : 32);
        EXPECT_TRUE(read->floats);
        ASSERT_EQ(read->image.width, 16u);
        ASSERT_EQ(read->image.height, 12u);
        for (int y = 0; y < 12; ++y)
          for (int x = 0; x < 16; ++x)
            for (int c = 0; c < 3; ++c)
              ASSERT_EQ(read->image.row(static_cast<std::uint32_t>(y))[3 * x + c],
                        exr_sample(c == 0   ? "R"
                                   : c == 1 ? "G"
                                            : "B",
                                   x, y))
                  << x << ", " << y << " compression " << compression << (tiled ? " tiled" : "");
      }
}

TEST(ReadExr, GivesTheDisplayWindowWithBlackWhereNothingIs) {
  for (const bool tiled : {false, true}) {
    const ExrKind kind{.tiled = tiled, .display = {-2, 3, 9, 12}, .data = {-7, 5, 4, 30}};
    const ReadImage read = parse_image(exr_file(kind, exr_sample), "a").value();
    ASSERT_EQ(read.image.width, 12u);
    ASSERT_EQ(read.image.height, 10u);
    for (int y = 3; y <= 12; ++y)
      for (int x = -2; x <= 9; ++x) {
        const bool there = x <= 4 && y >= 5;
        ASSERT_EQ(read.image.row(static_cast<std::uint32_t>(y - 3))[3 * (x + 2)],
                  there ? exr_sample("R", x, y) : 0.0f)
            << x << ", " << y;
      }
  }
}

TEST(ReadExr, ReadsGreyAndRefusesWhatIsNoColor) {
  const ReadImage grey = parse_image(exr_file({.channels = {"Y"}}, exr_sample), "a").value();
  EXPECT_EQ(grey.image.row(2)[3 * 4], exr_sample("Y", 4, 2));
  EXPECT_EQ(grey.image.row(2)[3 * 4 + 2], exr_sample("Y", 4, 2));
  EXPECT_EQ(error_of(exr_file({.channels = {"G", "R", "beauty.B"}}, exr_sample)),
            "a: error: is an OpenEXR without R, G and B: it has G, R, beauty.B\n");
}

TEST(ReadExr, RefusesLossyCompression) {
  for (const int compression : {6, 7, 8, 9})
    EXPECT_EQ(error_of(exr_file({.half = true, .compression = compression}, exr_sample)),
              "a: error: is an OpenEXR with lossy compression (B44 or DWA)\n  save it with ZIP or "
              "PIZ\n");
}

TEST(ReadExr, SaysWhatIsWrong) {
  const std::string good = exr_file({}, exr_sample);
  EXPECT_EQ(error_of(good, 100),
            "a: error: is too large: 16×12 pixels, where at most 100 in all are read\n");
  EXPECT_EQ(error_of(good.substr(0, 6)), "a: error: is an OpenEXR that is cut off\n");
  EXPECT_TRUE(error_of(good.substr(0, good.size() - 20))
                  .starts_with("a: error: is no OpenEXR that can be read: "))
      << error_of(good.substr(0, good.size() - 20));
  std::string deep = good, parts = good;
  deep[5] = 0x08;
  parts[5] = 0x10;
  EXPECT_EQ(error_of(deep), "a: error: is an OpenEXR with deep pixels\n  flatten it\n");
  EXPECT_EQ(error_of(parts),
            "a: error: is an OpenEXR with several parts\n  save the one that counts alone\n");
  // A display window as large as integers go.
  std::string huge = good;
  const std::size_t window = huge.find("displayWindow");
  const char largest[16] = {0, 0, 0, 0, 0, 0, 0, 0, '\xFE', '\xFF', '\xFF', '\x7F', 0, 0, 0, 0};
  huge.replace(window + 14 + 6 + 4, 16, largest, 16);
  EXPECT_TRUE(error_of(huge).starts_with("a: error: is")) << error_of(huge);
}

}  // namespace
}  // namespace zraka
