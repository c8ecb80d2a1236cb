// SPDX-License-Identifier: Apache-2.0
#include "render/corners.hpp"

#include <gtest/gtest.h>

#include <random>
#include <utility>

namespace zraka {
namespace {

/// Bands that are made in this order write over what others have not read yet, if they can.
const DoAll kLastFirst = [](std::size_t count, const auto& work) {
  while (count-- > 0) work(count);
};

TEST(Corners, AreAveragedWhateverThePicturesShape) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> value(0, 1);
  for (const auto& [width, height] : {std::pair{1u, 1u},
                                      {2u, 1000u},
                                      {9u, 500u},
                                      {40u, 700u},
                                      {130u, 1900u},
                                      {64u, 64u},
                                      {513u, 65u},
                                      {700u, 700u},
                                      {3000u, 130u}}) {
    Image corners(width + 1, height + 1);
    for (float& v : corners.pixels) v = value(random);
    const Image means = means_of_corners(corners, kLastFirst);
    ASSERT_EQ(means_of_corners(corners).pixels, means.pixels);
    ASSERT_EQ(means.width, width);
    ASSERT_EQ(means.height, height);
    ASSERT_EQ(means.pixels.size(), std::size_t{3} * width * height);
    for (std::uint32_t y = 0; y < height; ++y)
      for (std::uint32_t i = 0; i < 3 * width; ++i)
        ASSERT_EQ(means.row(y)[i],
                  mean_of_corners(corners.row(y)[i], corners.row(y)[i + 3], corners.row(y + 1)[i],
                                  corners.row(y + 1)[i + 3]))
            << width << "×" << height << " row " << y << " number " << i;
  }
}

}  // namespace
}  // namespace zraka
