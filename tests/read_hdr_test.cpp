// SPDX-License-Identifier: Apache-2.0
// Radiance's pictures: every order and kind of runs, and files that mean harm.
#include <gtest/gtest.h>

#include <cmath>
#include <zraka/image.hpp>

#include "picture_files.hpp"

namespace zraka {
namespace {

using Bytes = std::vector<unsigned char>;

/// Pixels with and without runs: in the middle of each line all are the same.
Bytes pixels_of(std::uint32_t width, std::uint32_t height) {
  Bytes bytes;
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) {
      const std::uint32_t i = x > width / 4 && x < width - 3 ? 5 : x;
      for (const std::uint32_t v : {3 * i + y + 2, 250 - i % 200, 40 + y, 120 + i % 16})
        bytes.push_back(static_cast<unsigned char>(v));
    }
  return bytes;
}

/// What the header's line about the size and one pixel, line after line, make of "#?RADIANCE\n\n".
std::string flat_file(const std::string& size, const Bytes& pixels) {
  return "#?RADIANCE\n\n" + size + "\n" + std::string(pixels.begin(), pixels.end());
}

TEST(ReadHdr, ReadsEveryKindOfRuns) {
  for (const std::uint32_t width : {1u, 7u, 8u, 300u, 1000u})
    for (const HdrRuns runs : {HdrRuns::none, HdrRuns::of_pixels, HdrRuns::of_bytes}) {
      if (runs == HdrRuns::of_bytes && width < 8) continue;
      const Bytes pixels = pixels_of(width, 5);
      const Result<ReadImage> read = parse_image(hdr_file(width, 5, runs, pixels), "a");
      ASSERT_TRUE(read) << width << ": " << to_string(read.error().front());
      EXPECT_EQ(read->format, "Radiance HDR");
      EXPECT_TRUE(read->floats);
      EXPECT_EQ(read->bits, 32);
      ASSERT_EQ(read->image.width, width);
      ASSERT_EQ(read->image.height, 5u);
      for (std::size_t i = 0; i < pixels.size() / 4; ++i)
        for (std::size_t c = 0; c < 3; ++c)
          ASSERT_EQ(read->image.pixels[3 * i + c],
                    std::ldexp(static_cast<float>(pixels[4 * i + c]), pixels[4 * i + 3] - 136))
              << width << ", " << i;
    }
}

TEST(ReadHdr, KnowsTheSmallestAndLargestNumbers) {
  const Bytes pixels = {255, 0, 1, 255, 255, 9, 1, 0, 1, 255, 0, 1, 128, 64, 0, 129};
  const ReadImage read = parse_image(flat_file("-Y 1 +X 4", pixels), "a").value();
  EXPECT_EQ(read.image.pixels, (std::vector<float>{0x1.FEp126f, 0, 0x1p119f, 0, 0, 0, 0x1p-135f,
                                                   0x1.FEp-128f, 0, 1, 0.5f, 0}));
}

TEST(ReadHdr, TakesNoPixelForTheMarkOfALineOfRuns) {
  // The mark is 2, 2 and a length of two bytes; short lines have none, nor is there one of 32768.
  const Bytes short_line = {2, 2, 0, 2, 5, 6, 7, 136};
  EXPECT_EQ(parse_image(flat_file("-Y 1 +X 2", short_line), "a").value().image.pixels[5], 7);
  Bytes line = {2, 2, 128, 136};
  for (unsigned char i = 1; i < 9; ++i) line.insert(line.end(), {i, 0, 0, 136});
  EXPECT_EQ(parse_image(flat_file("-Y 1 +X 9", line), "a").value().image.pixels[24], 8);
}

TEST(ReadHdr, StartsRunsAnewBehindAPixel) {
  const Bytes line = {9, 0, 0, 136, 1, 1, 1, 1, 8, 0, 0, 136, 1, 1, 1, 2};
  const ReadImage read = parse_image(flat_file("-Y 1 +X 5", line), "a").value();
  std::vector<float> reds;
  for (std::size_t i = 0; i < 15; i += 3) reds.push_back(read.image.pixels[i]);
  EXPECT_EQ(reds, (std::vector<float>{9, 9, 8, 8, 8}));
}

TEST(ReadHdr, PutsLinesWhereTheySayTheyAre) {
  // Six pixels whose reds count from 1; what must be in the picture, row by row from the top.
  const Bytes pixels = {1, 0, 0, 136, 2, 0, 0, 136, 3, 0, 0, 136,
                        4, 0, 0, 136, 5, 0, 0, 136, 6, 0, 0, 136};
  const struct {
    std::string size;
    std::uint32_t width;
    std::vector<float> reds;
  } cases[] = {
      {"-Y 2 +X 3", 3, {1, 2, 3, 4, 5, 6}}, {"-Y 2 -X 3", 3, {3, 2, 1, 6, 5, 4}},
      {"+Y 2 +X 3", 3, {4, 5, 6, 1, 2, 3}}, {"+Y 2 -X 3", 3, {6, 5, 4, 3, 2, 1}},
      {"+X 2 -Y 3", 2, {1, 4, 2, 5, 3, 6}}, {"-X 2 -Y 3", 2, {4, 1, 5, 2, 6, 3}},
      {"+X 2 +Y 3", 2, {3, 6, 2, 5, 1, 4}}, {"-X 2 +Y 3", 2, {6, 3, 5, 2, 4, 1}},
  };
  for (const auto& c : cases) {
    const ReadImage read = parse_image(flat_file(c.size, pixels), "a").value();
    EXPECT_EQ(read.image.width, c.width) << c.size;
    std::vector<float> reds;
    for (std::size_t i = 0; i < read.image.pixels.size(); i += 3)
      reds.push_back(read.image.pixels[i]);
    EXPECT_EQ(reds, c.reds) << c.size;
  }
}

TEST(ReadHdr, PassesOverWhatTheHeaderSaysBesides) {
  const Bytes pixels = {128, 0, 0, 129};
  for (const std::string header :
       {"#?RGBE\n\n", "#?RADIANCE\r\n# a comment\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n",
        "#?RADIANCE\nEXPOSURE=2\nGAMMA=1\nrpict -vp 0 0 0\n\n"})
    EXPECT_EQ(
        parse_image(hdr_file(1, 1, HdrRuns::none, pixels, header), "a").value().image.pixels[0], 1)
        << header;
}

TEST(ReadHdr, SaysWhatIsWrongWithAHeader) {
  EXPECT_EQ(error_of("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n1234"),
            "a:2: error: the format '32-bit_rle_xyze' cannot be read: expected 32-bit_rle_rgbe\n"
            "  save it with red, green and blue\n");
  EXPECT_EQ(error_of("#?RADIANCE\nFORMAT=32-bit"),
            "a: error: is cut off: its header does not end\n");
  EXPECT_EQ(error_of("#?RADIANCE\n\n-Y 4"), "a: error: is cut off: it does not say its size\n");
  for (const std::string size : {"", "4 4", "-Y 4", "-Y 4 +X", "-Y 4 +X ", "-Y 4 +Y 4", "+X 1 +X 1",
                                 "-Y -4 +X 4", "-Y 4  +X 4", "-Y 4 +X 4 ", "-Z 4 +X 4",
                                 "-Y 2147483648 +X 1", "-Y 99999999999999999999999 +X 1"})
    EXPECT_EQ(error_of("#?RADIANCE\n\n" + size + "\n1234"),
              "a:3: error: '" + size + "' is no size: expected something like -Y 480 +X 640\n");
}

TEST(ReadHdr, RefusesSizesBeforeItTakesMemory) {
  EXPECT_EQ(error_of("#?RADIANCE\n\n-Y 0 +X 4\n"), "a: error: has no pixels: 4×0\n");
  EXPECT_EQ(
      error_of("#?RADIANCE\n\n-Y 2147483647 +X 1\n"),
      "a: error: is too large: 1×2147483647 pixels, where at most 134217728 in all are read\n");
  EXPECT_EQ(
      error_of("#?RADIANCE\n\n+X 46341 +Y 46341\n"),
      "a: error: is too large: 46341×46341 pixels, where at most 134217728 in all are read\n");
  EXPECT_EQ(error_of("#?RADIANCE\n\n-Y 100000 +X 1000\n123456789"),
            "a: error: is cut off: 9 bytes cannot hold 1000×100000 pixels\n");
}

TEST(ReadHdr, SaysWhatIsWrongWithALine) {
  const std::string begin = "#?RADIANCE\n\n-Y 2 +X 8\n";
  const auto runs = [](std::string bytes) { return "\2\2" + std::string("\0\10", 2) + bytes; };
  const std::string channel = "\210x", line = runs(channel + channel + channel + channel);
  EXPECT_EQ(error_of(begin + line + runs(channel + "\210")),
            "a: error: is cut off: the file ends in line 2 of pixels\n");
  EXPECT_EQ(error_of(begin + line + runs("\10abc")),
            "a: error: is cut off: the file ends in line 2 of pixels\n");
  EXPECT_EQ(error_of(begin + line + runs("\211xx")),
            "a: error: line 2 of pixels has a run beyond its end\n");
  EXPECT_EQ(error_of(begin + line + runs("\200xx")),
            "a: error: line 2 of pixels has a run beyond its end\n");
  EXPECT_EQ(error_of(begin + line + runs(std::string("\0x", 2))),
            "a: error: line 2 of pixels has a run of no pixels\n");
  EXPECT_EQ(error_of(begin + line + std::string("\2\2\0\11xx", 6)),
            "a: error: line 2 of pixels says that it has 9 pixels, where 8 were expected\n");
  EXPECT_EQ(error_of(begin + line + "abcd"),
            "a: error: is cut off: the file ends in line 2 of pixels\n");
  EXPECT_EQ(error_of(begin + line + "\1\1\1\3"), "a: error: line 2 of pixels begins with a run\n");
  EXPECT_EQ(error_of(begin + line + "abcd\1\1\1\10"),
            "a: error: line 2 of pixels has a run beyond its end\n");
  // The bytes of one number, each of a pixel: 4 + 256·1 are too many, however many come.
  EXPECT_EQ(error_of(begin + line + "abcd\1\1\1\4\1\1\1\1"),
            "a: error: line 2 of pixels has a run beyond its end\n");
  std::string zeros = begin + line + "abcd";
  for (int i = 0; i < 100; ++i) zeros += std::string("\1\1\1\0", 4);
  EXPECT_EQ(error_of(zeros), "a: error: is cut off: the file ends in line 2 of pixels\n");
}

}  // namespace
}  // namespace zraka
