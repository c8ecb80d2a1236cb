// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <vector>
#include <zraka/image.hpp>

#include "image/quantize.hpp"

namespace zraka {
namespace {

TEST(Quantize, IsTheLabsRounding) {
  EXPECT_EQ(quantize(0, Transfer::linear, 8), 0);
  EXPECT_EQ(quantize(1, Transfer::linear, 8), 255);
  EXPECT_EQ(quantize(0.5f, Transfer::linear, 8), 128);  // int(127.5 + 0.5)
  EXPECT_EQ(quantize(0.49f / 255, Transfer::linear, 8), 0);
  EXPECT_EQ(quantize(0.51f / 255, Transfer::linear, 8), 1);
  EXPECT_EQ(quantize(1, Transfer::linear, 16), 65535);
}

/// Where leading bits change and where they do not; above 0.5 values are nearest to each other.
TEST(Quantize, HasRowsOfTheSameValues) {
  for (const Transfer transfer : {Transfer::srgb, Transfer::linear}) {
    const RowQuantizer quantizer(transfer, 8);
    std::vector<float> values{0, -1, 2, 0x1p-149f};
    for (std::uint32_t bits = 0x38000000; bits <= 0x3F800000; bits += 1 << 14)
      for (const std::uint32_t near : {bits - 1, bits, bits + 1, bits + 5000})
        values.push_back(std::bit_cast<float>(near));
    std::vector<unsigned char> stored(values.size());
    quantizer.row(values.data(), values.size(), stored.data());
    for (std::size_t i = 0; i < values.size(); ++i)
      ASSERT_EQ(stored[i], quantize(values[i], transfer, 8)) << values[i];
  }
}

TEST(Quantize, ClampsAndTakesNanForBlack) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const Transfer transfer : {Transfer::linear, Transfer::srgb}) {
    EXPECT_EQ(quantize(-kInfinity, transfer, 8), 0);
    EXPECT_EQ(quantize(-1, transfer, 8), 0);
    EXPECT_EQ(quantize(2, transfer, 8), 255);
    EXPECT_EQ(quantize(kInfinity, transfer, 8), 255);
    EXPECT_EQ(quantize(std::nanf(""), transfer, 8), 0);
  }
}

TEST(Quantize, FollowsTheSrgbCurve) {
  for (int i = 0; i <= 65535; i += 13) {
    const double linear = i / 65535.0;
    const double want =
        linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
    EXPECT_NEAR(quantize(static_cast<float>(linear), Transfer::srgb, 16), want * 65535, 1.0);
  }
}

TEST(Quantize, DoesRowsLikeSingleValues) {
  std::vector<float> values = {-1, 0, 1, 2, std::nanf(""), 1e-30f, 0.99999994f};
  for (int i = 0; i < 70000; ++i) values.push_back(static_cast<float>(i) / 65535.0f);
  std::vector<unsigned char> row(values.size());
  for (const Transfer transfer : {Transfer::linear, Transfer::srgb}) {
    RowQuantizer(transfer, 8).row(values.data(), values.size(), row.data());
    for (std::size_t i = 0; i < values.size(); ++i)
      ASSERT_EQ(row[i], quantize(values[i], transfer, 8)) << values[i];
  }
}

Image gradient() {
  Image image(37, 21);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<float>(i % 256) / 255.0f;
  return image;
}

TEST(Png, ComesBackAsItWent) {
  const std::string path = testing::TempDir() + "zraka-round-trip.png";
  const Image image = gradient();
  for (const int bits : {8, 16}) {
    ASSERT_TRUE(write_png(image, path, {bits, Transfer::linear}));
    const Image back = read_image(path).value().image;
    ASSERT_EQ(back.width, image.width);
    ASSERT_EQ(back.height, image.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      ASSERT_NEAR(back.pixels[i], image.pixels[i], 1e-6f) << i << " at " << bits << " bits";
  }
  std::filesystem::remove(path);
}

/// Larger than what one thread deflates at once, and nothing that deflates well.
Image noise(std::uint32_t width, std::uint32_t height) {
  Image image(width, height);
  std::uint32_t state = 1;
  for (float& value : image.pixels) {
    state = state * 1664525 + 1013904223;
    value = static_cast<float>(state >> 24) / 255.0f;
  }
  return image;
}

TEST(Png, IsTheSameFromAnyNumberOfThreads) {
  for (const int bits : {8, 16})
    for (const auto& [width, height] : {std::pair{701u, 403u}, {1u, 90000u}, {200000u, 3u}}) {
      const Image image = noise(width, height);
      const std::string png = encode_png(image, {bits, Transfer::linear, 1}).value();
      for (const int threads : {0, 2, 5})
        ASSERT_EQ(encode_png(image, {bits, Transfer::linear, threads}).value(), png);
      const Image back = parse_image(png, "a").value().image;
      ASSERT_EQ(back.width, width);
      ASSERT_EQ(back.height, height);
      for (std::size_t i = 0; i < image.pixels.size(); ++i)
        ASSERT_NEAR(back.pixels[i], image.pixels[i], 1e-6f) << i;
    }
}

TEST(Png, KeepsItsPromiseAboutSize) {
  // Each piece costs a few bytes; what does not deflate is stored as it is.
  EXPECT_LT(encode_png(noise(701, 403)).value().size(), 3.01 * 701 * 403);
  EXPECT_LT(encode_png(Image(2000, 2000)).value().size(), 100000u);
}

TEST(Png, HoldsNoDate) {
  const std::string path = testing::TempDir() + "zraka-date.png";
  ASSERT_TRUE(write_png(gradient(), path));
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  EXPECT_EQ(bytes.find("tIME"), std::string::npos);
  EXPECT_EQ(bytes.find("tEXt"), std::string::npos);
  EXPECT_NE(bytes.find("IDAT"), std::string::npos);
  std::filesystem::remove(path);
}

TEST(Sha256, IsOfSizeAndFloats) {
  // sha256 of 01000000 01000000 and three zero floats, as any other program computes it.
  EXPECT_EQ(sha256(Image(1, 1)),
            "2443085e6d56c5a38e87a1a3153ea6e48d03f3e53aeb0a1b98c02f948493a8e8");
  EXPECT_NE(sha256(Image(1, 2)), sha256(Image(2, 1)));
}

}  // namespace
}  // namespace zraka
