// SPDX-License-Identifier: Apache-2.0
// BMP and TGA, byte by byte: every number of bits, both orders of rows, runs, palettes, how opaque
// pixels are, and files that end too early.
#include <gtest/gtest.h>

#include <zraka/image.hpp>

#include "image/readers.hpp"

namespace zraka {
namespace {

std::string little(std::uint32_t value, int bytes) {
  std::string text;
  for (int k = 0; k < bytes; ++k) text += static_cast<char>(value >> 8 * k & 255);
  return text;
}
std::string bytes_of(std::initializer_list<int> values) {
  std::string text;
  for (const int v : values) text += static_cast<char>(v);
  return text;
}

/// A BMP with Windows' header of 40 bytes.
std::string bmp(std::int32_t width, std::int32_t height, std::uint32_t bits,
                const std::string& pixels, const std::string& palette = "",
                std::uint32_t encoding = 0, std::uint32_t header = 40) {
  const auto at = static_cast<std::uint32_t>(54 + palette.size());
  return "BM" + little(at + static_cast<std::uint32_t>(pixels.size()), 4) + little(0, 4) +
         little(at, 4) + little(header, 4) + little(static_cast<std::uint32_t>(width), 4) +
         little(static_cast<std::uint32_t>(height), 4) + little(1, 2) + little(bits, 2) +
         little(encoding, 4) + std::string(20, '\0') + palette + pixels;
}
std::string tga(int kind, std::uint32_t width, std::uint32_t height, int bits, int descriptor,
                const std::string& pixels, const std::string& map = "") {
  const auto entries = static_cast<std::uint32_t>(map.size() / 3);
  return bytes_of({2, map.empty() ? 0 : 1, kind}) + little(0, 2) + little(entries, 2) +
         bytes_of({map.empty() ? 0 : 24}) + little(0, 4) + little(width, 2) + little(height, 2) +
         bytes_of({bits, descriptor}) + "id" + map + pixels;
}

/// Values of 255.
std::vector<int> values_of(const std::string& file) {
  const Result<ReadImage> read = parse_image(file, "a");
  if (!read) return {-1};
  std::vector<int> values;
  for (const float v : read->image.pixels) values.push_back(static_cast<int>(v * 255 + 0.5f));
  return values;
}
std::string error_of(const std::string& file) {
  const Result<ReadImage> read = parse_image(file, "a");
  return read ? "read" : read.error().front().message;
}

TEST(ReadBmp, ReadsRowsOfAllNumbersOfBitsFromBelow) {
  const std::string pixels = bytes_of({3, 2, 1, 6, 5, 4, 0, 0, 9, 8, 7, 12, 11, 10, 0, 0});
  EXPECT_EQ(values_of(bmp(2, 2, 24, pixels)), (std::vector{7, 8, 9, 10, 11, 12, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(values_of(bmp(2, -2, 24, pixels)),
            (std::vector{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(values_of(bmp(1, 1, 32, bytes_of({3, 2, 1, 0}))), (std::vector{1, 2, 3}));
  EXPECT_EQ(values_of(bmp(2, 1, 16, little(31 << 10, 2) + little(31 << 5 | 31, 2))),
            (std::vector{255, 0, 0, 0, 255, 255}));
  const std::string palette = bytes_of({30, 20, 10, 0, 60, 50, 40, 0});
  const std::vector twice{10, 20, 30, 40, 50, 60};
  EXPECT_EQ(values_of(bmp(2, 1, 8, bytes_of({0, 1, 0, 0}), palette)), twice);
  EXPECT_EQ(values_of(bmp(2, 1, 4, bytes_of({1, 0, 0, 0}), palette)), twice);
  EXPECT_EQ(values_of(bmp(2, 1, 1, bytes_of({64, 0, 0, 0}), palette)), twice);
  EXPECT_EQ(values_of(bmp(1, 1, 8, bytes_of({200, 0, 0, 0}), palette)), (std::vector{0, 0, 0}));
  EXPECT_EQ(parse_image(bmp(1, 1, 32, bytes_of({3, 2, 1, 0})), "a")->format, "BMP");
}

TEST(ReadBmp, GoesByMasksAndSaysHowOpaquePixelsAreWhereTheyDo) {
  // Masks of a header of 56 bytes: red in the least byte, how opaque in the greatest.
  const std::string masks =
      little(0xFF, 4) + little(0xFF00, 4) + little(0xFF0000, 4) + little(0xFF000000u, 4);
  const std::string half = bmp(1, 1, 32, bytes_of({100, 50, 200, 51}), masks, 3, 56);
  EXPECT_EQ(values_of(half), (std::vector{20, 10, 40}));
  std::vector<float> alpha;
  const ReadImage kept = parse_image_with_alpha(half, "a", 10, alpha).value();
  EXPECT_EQ(alpha, std::vector{0.2f});
  EXPECT_FLOAT_EQ(kept.image.pixels[0], 100 / 255.0f);
  // A byte that is empty everywhere says nothing.
  EXPECT_EQ(values_of(bmp(1, 1, 32, bytes_of({100, 50, 200, 0}), masks, 3, 56)),
            (std::vector{100, 50, 200}));
  const std::string five = little(0xF800, 4) + little(0x7E0, 4) + little(0x1F, 4) + little(0, 4);
  EXPECT_EQ(values_of(bmp(1, 1, 16, little(63 << 5, 2) + little(0, 2), five, 3)),
            (std::vector{0, 255, 0}));
}

TEST(ReadBmp, SaysWhatIsWrong) {
  EXPECT_EQ(error_of("BM"), "is cut off: the header of a BMP ends early");
  EXPECT_EQ(error_of(bmp(2, 2, 24, "1234567")), "is cut off: 61 bytes cannot hold 2×2 pixels");
  EXPECT_EQ(error_of(bmp(2, 2, 8, "1234567", "", 1)),
            "is a BMP of 8 bits a pixel in encoding 1, which cannot be read here");
  EXPECT_EQ(error_of(bmp(0, 2, 24, "")), "has no pixels: 0×2");
  EXPECT_EQ(error_of(bmp(0x7FFFFFFF, -0x7FFFFFFF, 24, "")).substr(0, 12), "is too large");
  std::string file = bmp(2, 2, 24, std::string(16, 'x'));
  for (std::size_t size = 2; size < file.size(); ++size)
    EXPECT_NE(error_of(file.substr(0, size)), "read") << size;
}

TEST(ReadTga, ReadsAllKindsFromAnyCorner) {
  const std::string pixels = bytes_of({3, 2, 1, 6, 5, 4, 9, 8, 7, 12, 11, 10});
  EXPECT_EQ(values_of(tga(2, 2, 2, 24, 0, pixels)),
            (std::vector{7, 8, 9, 10, 11, 12, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(values_of(tga(2, 2, 2, 24, 0x20, pixels)),
            (std::vector{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(values_of(tga(2, 2, 2, 24, 0x30, pixels)),
            (std::vector{4, 5, 6, 1, 2, 3, 10, 11, 12, 7, 8, 9}));
  EXPECT_EQ(values_of(tga(3, 2, 1, 8, 0, bytes_of({7, 9}))), (std::vector{7, 7, 7, 9, 9, 9}));
  EXPECT_EQ(values_of(tga(2, 1, 1, 16, 0, little(31 << 10, 2))), (std::vector{255, 0, 0}));
  EXPECT_EQ(values_of(tga(1, 2, 1, 8, 0, bytes_of({1, 0}), bytes_of({30, 20, 10, 60, 50, 40}))),
            (std::vector{40, 50, 60, 10, 20, 30}));
  EXPECT_EQ(values_of(tga(2, 1, 1, 32, 8, bytes_of({200, 50, 100, 51}))),
            (std::vector{20, 10, 40}));
  EXPECT_EQ(parse_image(tga(3, 1, 1, 8, 0, "x"), "a")->format, "TGA");
}

TEST(ReadTga, ReadsRunsThatGoOnInTheNextRow) {
  const std::string runs = bytes_of({0x82, 3, 2, 1, 0x00, 6, 5, 4});
  EXPECT_EQ(values_of(tga(10, 2, 2, 24, 0x20, runs)),
            (std::vector{1, 2, 3, 1, 2, 3, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(error_of(tga(10, 2, 3, 24, 0x20, runs)), "is cut off: 28 bytes cannot hold 2×3 pixels");
  EXPECT_EQ(error_of(tga(2, 2, 3, 24, 0x20, runs)), "is cut off: 28 bytes cannot hold 2×3 pixels");
  EXPECT_EQ(error_of(tga(10, 5000, 5000, 24, 0, runs)).substr(0, 10), "is cut off");
}

TEST(ReadTga, IsNotFoundInOtherFiles) {
  EXPECT_FALSE(is_tga("hello, this is no picture of any kind"));
  EXPECT_FALSE(is_tga(std::string(100, '\0')));
  EXPECT_FALSE(is_tga(tga(4, 1, 1, 8, 0, "x")));
  EXPECT_FALSE(is_tga(tga(2, 1, 1, 17, 0, "xxx")));
  EXPECT_FALSE(is_tga(tga(2, 0, 1, 24, 0, "xxx")));
}

}  // namespace
}  // namespace zraka
