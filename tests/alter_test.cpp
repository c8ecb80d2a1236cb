// SPDX-License-Identifier: Apache-2.0
#include "image/alter.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zraka {
namespace {

/// Column, row and their product, so that every pixel is different.
Image numbered(std::uint32_t width, std::uint32_t height) {
  Image image(width, height);
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) {
      image.row(y)[3 * x] = static_cast<float>(x);
      image.row(y)[3 * x + 1] = static_cast<float>(y);
      image.row(y)[3 * x + 2] = static_cast<float>(x * y);
    }
  return image;
}

double mean_of(const Image& image) {
  double sum = 0;
  for (const float v : image.pixels) sum += v;
  return sum / static_cast<double>(image.pixels.size());
}

TEST(Alter, FlipsAndSwapsAndUndoesIt) {
  const Image image = numbered(5, 3);
  EXPECT_EQ(flipped_vertically(image).row(0)[3 * 4 + 1], 2);
  EXPECT_EQ(flipped_vertically(image).row(0)[3 * 4], 4);
  EXPECT_EQ(flipped_horizontally(image).row(1)[0], 4);
  EXPECT_EQ(flipped_horizontally(image).row(1)[1], 1);
  EXPECT_EQ(with_red_and_blue_swapped(image).row(2)[3 * 3], 6);
  EXPECT_EQ(with_red_and_blue_swapped(image).row(2)[3 * 3 + 2], 3);
  EXPECT_EQ(flipped_vertically(flipped_vertically(image)).pixels, image.pixels);
  EXPECT_EQ(flipped_horizontally(flipped_horizontally(image)).pixels, image.pixels);
  EXPECT_EQ(with_red_and_blue_swapped(with_red_and_blue_swapped(image)).pixels, image.pixels);
}

TEST(Alter, CutsWhatIsAskedFor) {
  const Image part = cropped(numbered(6, 5), 2, 1, 3, 4);
  ASSERT_EQ(part.width, 3u);
  ASSERT_EQ(part.height, 4u);
  EXPECT_EQ(part.row(0)[0], 2);
  EXPECT_EQ(part.row(3)[3 * 2], 4);
  EXPECT_EQ(part.row(3)[3 * 2 + 1], 4);
}

TEST(Alter, ShiftsByWholeAndHalfPixels) {
  const Image image = numbered(6, 4);
  const Image whole = shifted(image, 2, -1);
  EXPECT_EQ(whole.row(0)[3 * 5], 3);      // what was in column 3
  EXPECT_EQ(whole.row(0)[3 * 5 + 1], 1);  // and in row 1
  EXPECT_EQ(whole.row(3)[0], 0);          // the edge repeats
  EXPECT_EQ(whole.row(3)[1], 3);
  const Image half = shifted(image, 0.5, 0.5);
  EXPECT_EQ(half.row(2)[3 * 3], 2.5f);
  EXPECT_EQ(half.row(2)[3 * 3 + 1], 1.5f);
  EXPECT_EQ(half.row(2)[3 * 3 + 2], 0.25f * (4 + 6 + 2 + 3));
  EXPECT_EQ(half.row(0)[0], 0);
  EXPECT_EQ(shifted(image, 0, 0).pixels, image.pixels);
}

TEST(Alter, KeepsTheMeanWhenScalingByArea) {
  const Image image = numbered(30, 21);
  for (const auto& [width, height] :
       {std::pair{10u, 7u}, {7u, 5u}, {29u, 20u}, {1u, 1u}, {60u, 42u}})
    EXPECT_NEAR(mean_of(scaled_by_area(image, width, height)), mean_of(image), 1e-3)
        << width << "×" << height;
  EXPECT_EQ(scaled_by_area(image, 30, 21).pixels, image.pixels);
  const Image third = scaled_by_area(image, 10, 7);
  EXPECT_NEAR(third.row(3)[3 * 4], 13, 1e-5);      // columns 12, 13, 14
  EXPECT_NEAR(third.row(3)[3 * 4 + 1], 10, 1e-5);  // rows 9, 10, 11
  // 3 pixels from 2: the middle one is half of each.
  Image two(2, 1);
  two.pixels = {0, 0, 0, 1, 1, 1};
  const Image three = scaled_by_area(two, 3, 1);
  EXPECT_EQ(three.pixels[0], 0);
  EXPECT_NEAR(three.pixels[3], 0.5, 1e-7);
  EXPECT_EQ(three.pixels[6], 1);
}

TEST(Alter, DrawsStraightLinesStraightWhenScalingBilinearly) {
  const Image image = numbered(20, 10);
  const Image large = scaled_bilinearly(image, 50, 25);
  for (std::uint32_t x = 2; x < 47; ++x)
    EXPECT_NEAR(large.row(12)[3 * x], (x + 0.5) * 0.4 - 0.5, 1e-5);
  EXPECT_EQ(large.row(0)[0], 0);
  EXPECT_EQ(large.row(24)[3 * 49], 19);
  EXPECT_EQ(scaled_bilinearly(image, 20, 10).pixels, image.pixels);
}

TEST(Alter, StoresAsTheFileWould) {
  Image image(64, 33);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<float>(i) / 6000.0f - 0.02f;
  image.pixels[7] = std::nanf("");
  for (const int bits : {8, 16})
    for (const Transfer transfer : {Transfer::linear, Transfer::srgb}) {
      const Image stored = as_stored(image, transfer, bits);
      const ReadImage read = parse_image(encode_png(image, {bits, transfer}).value(), "a").value();
      EXPECT_EQ(stored.pixels, read.image.pixels);
      EXPECT_EQ(as_stored(stored, Transfer::linear, bits).pixels, stored.pixels)
          << "stored values stay what they are";
    }
}

TEST(Alter, GoesThroughCurvesAndBack) {
  Image image(100, 1);
  for (std::size_t i = 0; i < 300; ++i) image.pixels[i] = static_cast<float>(i) / 299.0f;
  const Image there = encoded(image, Transfer::srgb);
  for (std::size_t i = 0; i < 300; ++i) {
    const double v = image.pixels[i];
    EXPECT_NEAR(there.pixels[i], v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055,
                2e-6);
    EXPECT_NEAR(decoded(there, Transfer::srgb).pixels[i], v, 3e-6);
    EXPECT_NEAR(with_power(image, 1 / 2.2).pixels[i], std::pow(v, 1 / 2.2), 2e-6);
  }
  EXPECT_EQ(encoded(image, Transfer::linear).pixels, image.pixels);
}

}  // namespace
}  // namespace zraka
