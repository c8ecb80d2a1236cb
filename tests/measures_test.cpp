// SPDX-License-Identifier: Apache-2.0
// The measures against closed forms, plain sums and the numbers of their authors' programs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <zraka/compare.hpp>

#include "image/alter.hpp"
#include "patterns.hpp"

namespace zraka {
namespace {

Image filled(std::uint32_t width, std::uint32_t height, float r, float g, float b) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    image.pixels[i] = r;
    image.pixels[i + 1] = g;
    image.pixels[i + 2] = b;
  }
  return image;
}

TEST(Errors, OfAConstantOffsetAreThatOffset) {
  const Image a = filled(37, 19, 0.25f, 0.5f, 0.25f), b = filled(37, 19, 0.375f, 0.375f, 0.125f);
  const Errors e = measure_errors(a, b);
  EXPECT_EQ(e.largest, 0.125);
  EXPECT_EQ(e.mean, 0.125);
  EXPECT_EQ(e.mean_square, 0.125 * 0.125);
  EXPECT_EQ(e.root_mean_square(), 0.125);
  EXPECT_NEAR(e.peak_signal_to_noise(), 20 * std::log10(8.0), 1e-12);  // 18.06 dB
  EXPECT_EQ(e.pixels, 37u * 19);
  EXPECT_EQ(e.over, 37u * 19);
  EXPECT_EQ(e.share(), 1);
  EXPECT_EQ(e.box, (PixelBox{0, 0, 36, 18}));
}

TEST(Errors, OfEqualPicturesAreNone) {
  Image a = pattern();
  a.pixels[5] = std::nanf("");
  a.pixels[6] = std::numeric_limits<float>::infinity();
  const Errors e = measure_errors(a, a);
  EXPECT_EQ(e.largest, 0);
  EXPECT_EQ(e.mean_square, 0);
  EXPECT_EQ(e.over, 0u);
  EXPECT_EQ(e.peak_signal_to_noise(), std::numeric_limits<double>::infinity());
}

TEST(Errors, AreThoseOfPlainSums) {
  const Image a = pattern(), b = changed_pattern();
  double largest = 0, sum = 0, squares = 0;
  std::uint64_t over = 0;
  PixelBox box{95, 63, 0, 0};
  for (std::uint32_t y = 0; y < 64; ++y)
    for (std::uint32_t x = 0; x < 96; ++x) {
      double most = 0;
      for (std::size_t c = 3 * x; c < 3 * x + 3; ++c) {
        const double d = std::fabs(a.row(y)[c] - b.row(y)[c]);
        most = std::max(most, d);
        sum += d;
        squares += d * d;
      }
      largest = std::max(largest, most);
      if (most <= 0.5) continue;
      ++over;
      box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x),
             std::max(box.bottom, y)};
    }
  const Errors e = measure_errors(a, b, 0.5);
  EXPECT_EQ(e.largest, largest);
  EXPECT_NEAR(e.mean, sum / (3 * 96 * 64), 1e-12);
  EXPECT_NEAR(e.mean_square, squares / (3 * 96 * 64), 1e-12);
  EXPECT_EQ(e.over, over);
  EXPECT_GT(over, 100u);
  EXPECT_EQ(e.box, box);
}

TEST(Errors, CountAValueThatIsNoNumberAsOne) {
  const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
  for (const auto& [x, y] : {std::pair{nan, 0.5f}, {0.5f, inf}, {-inf, inf}, {nan, inf}}) {
    Image a(9, 1), b(9, 1);
    a.pixels[13] = x;
    b.pixels[13] = y;
    const Errors e = measure_errors(a, b, 0.9);
    EXPECT_EQ(e.largest, 1) << x << " and " << y;
    EXPECT_EQ(e.over, 1u);
    EXPECT_EQ(e.box, (PixelBox{4, 0, 4, 0}));
    EXPECT_NEAR(e.mean, 1.0 / 27, 1e-15);
  }
}

TEST(Errors, AreOverTheThresholdOnlyAboveIt) {
  Image a(3, 1), b(3, 1);
  b.pixels = {0.1f, 0, 0, 0, 0.1f, 0, 0, 0, 0.2f};
  EXPECT_EQ(measure_errors(a, b, 0.1f).over, 1u);
  EXPECT_EQ(measure_errors(a, b, 0.1).over, 3u) << "0.1f lies above 0.1";
  EXPECT_EQ(measure_errors(a, b, 0.2f).over, 0u);
}

TEST(Pixels, AreGivenFirstAndWorst) {
  Image a(40, 20), b(40, 20);
  const auto set = [&](std::uint32_t x, std::uint32_t y, float v) { b.row(y)[3 * x + 1] = v; };
  set(7, 2, 0.25f);
  set(3, 9, 0.5f);
  set(30, 9, 0.75f);
  set(1, 15, 0.5f);
  set(2, 15, 0.125f);
  const auto first = first_pixels(a, b, 0.125, 3);
  ASSERT_EQ(first.size(), 3u);
  EXPECT_EQ(first[0].x, 7u);
  EXPECT_EQ(first[0].y, 2u);
  EXPECT_EQ(first[0].b, (std::array{0.0f, 0.25f, 0.0f}));
  EXPECT_EQ(first[2].x, 30u);
  const auto worst = worst_pixels(a, b, 0, 4);
  ASSERT_EQ(worst.size(), 4u);
  EXPECT_EQ(worst[0].x, 30u);
  EXPECT_EQ(worst[0].difference, 0.75);
  EXPECT_EQ(worst[1].y, 9u) << "of equal ones the upper one comes first";
  EXPECT_EQ(worst[2].y, 15u);
  EXPECT_EQ(worst[3].x, 7u);
  EXPECT_TRUE(worst_pixels(a, b, 0.75, 4).empty());
  EXPECT_TRUE(worst_pixels(a, b, 0, 0).empty());
  EXPECT_EQ(worst_pixels(a, b, 0, 100).size(), 5u);
}

TEST(Ssim, IsOneForEqualPicturesToTheBit) {
  EXPECT_EQ(structural_similarity(pattern(), pattern()), 1.0);
  EXPECT_EQ(structural_similarity(Image(11, 11), Image(11, 11)), 1.0);
  EXPECT_EQ(structural_similarity(Image(10, 400), Image(10, 400)), std::nullopt);
}

TEST(Ssim, OfConstantPicturesIsTheLuminanceTerm) {
  // Without variance the second factor is C2/C2.
  const double x = 0.25, y = 0.75, c1 = 0.0001;
  EXPECT_NEAR(structural_similarity(filled(20, 15, 0.25f, 0.25f, 0.25f),
                                    filled(20, 15, 0.75f, 0.75f, 0.75f))
                  .value(),
              (2 * x * y + c1) / (x * x + y * y + c1), 1e-12);
}

TEST(Ssim, IsTheFormulaOfThePaperAtEveryPlace) {
  const Image a = pattern(), b = changed_pattern();
  const auto luma = [](const float* p) { return 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2]; };
  double sum = 0;
  int places = 0;
  for (std::uint32_t top = 0; top + 11 <= a.height; ++top)
    for (std::uint32_t left = 0; left + 11 <= a.width; ++left, ++places) {
      double all = 0, mx = 0, my = 0, sxx = 0, syy = 0, sxy = 0;
      const auto over_window = [&](auto use) {
        for (int v = 0; v < 11; ++v)
          for (int u = 0; u < 11; ++u) {
            const double w = std::exp(-((u - 5) * (u - 5) + (v - 5) * (v - 5)) / (2 * 1.5 * 1.5));
            const std::size_t at = 3 * (left + static_cast<std::uint32_t>(u));
            const std::uint32_t row = top + static_cast<std::uint32_t>(v);
            use(w, luma(a.row(row) + at), luma(b.row(row) + at));
          }
      };
      over_window([&](double w, double x, double y) { all += w, mx += w * x, my += w * y; });
      mx /= all, my /= all;
      over_window([&](double w, double x, double y) {
        sxx += w / all * (x - mx) * (x - mx);
        syy += w / all * (y - my) * (y - my);
        sxy += w / all * (x - mx) * (y - my);
      });
      sum += (2 * mx * my + 1e-4) * (2 * sxy + 9e-4) /
             ((mx * mx + my * my + 1e-4) * (sxx + syy + 9e-4));
    }
  EXPECT_NEAR(structural_similarity(a, b).value(), sum / places, 1e-10);
  EXPECT_EQ(structural_similarity(a, b), structural_similarity(b, a));
}

TEST(Flip, IsNothingForEqualPicturesAndTheSameBothWays) {
  const FlipErrors none = flip_error(pattern(), pattern());
  EXPECT_EQ(none.mean, 0);
  EXPECT_EQ(none.largest, 0);
  const FlipErrors there = flip_error(pattern(), changed_pattern());
  const FlipErrors back = flip_error(changed_pattern(), pattern());
  EXPECT_EQ(there.map, back.map);
  EXPECT_GT(there.mean, 0.1);
}

TEST(Flip, TurnsAndFlipsWithThePictures) {
  const FlipErrors upright = flip_error(pattern(), changed_pattern());
  const FlipErrors turned = flip_error(flipped_horizontally(flipped_vertically(pattern())),
                                       flipped_horizontally(flipped_vertically(changed_pattern())));
  for (std::size_t i = 0; i < upright.map.size(); ++i)
    ASSERT_NEAR(turned.map[upright.map.size() - 1 - i], upright.map[i], 2e-4) << i;
}

TEST(Flip, OfBlackAndWhiteFollowsFromTheFormula) {
  // Without edges all is the colour's: HyAB is 100, and the largest is from green to blue in L*a*b*
  // with the Hunt effect. L*, a*, b* of these two are in every table of sRGB.
  const double green[3] = {87.7347, -86.1827, 83.1793}, blue[3] = {32.2970, 79.1875, -107.8602};
  const auto hunt = [](const double* c, int i) { return 0.01 * c[0] * c[i]; };
  const double most =
      std::pow(green[0] - blue[0] +
                   std::hypot(hunt(green, 1) - hunt(blue, 1), hunt(green, 2) - hunt(blue, 2)),
               0.7);
  const double want = 0.95 + (std::pow(100, 0.7) - 0.4 * most) / (0.6 * most) * 0.05;
  const FlipErrors flip = flip_error(filled(70, 30, 0, 0, 0), filled(70, 30, 1, 1, 1));
  EXPECT_NEAR(flip.mean, want, 2e-5);
  EXPECT_NEAR(flip.largest, want, 2e-5);
  EXPECT_NEAR(want, 0.96738, 1e-5);
}

TEST(Flip, AgreesWithItsAuthorsProgram) {
  // What the Python program that the paper's authors published (version 1.1) gives in double
  // precision for the same two pictures.
  const FlipErrors flip = flip_error(pattern(), changed_pattern());
  EXPECT_NEAR(flip.mean, 0.190474, 2e-6);
  EXPECT_NEAR(flip.largest, 0.971123, 2e-6);
  const auto at = [&](std::size_t x, std::size_t y) { return flip.map[y * 96 + x]; };
  EXPECT_NEAR(at(0, 0), 0, 1e-7);
  EXPECT_NEAR(at(45, 30), 0.830688, 3e-6);
  EXPECT_NEAR(at(80, 10), 0.285470, 3e-6);
  EXPECT_NEAR(at(30, 20), 0.523961, 3e-6);
  EXPECT_NEAR(at(29, 19), 0.299714, 3e-6);
  EXPECT_NEAR(at(95, 63), 0.109421, 3e-6);
  const FlipErrors far = flip_error(pattern(), changed_pattern(), 20);
  EXPECT_NEAR(far.mean, 0.176971, 2e-6);
  EXPECT_NEAR(far.largest, 0.992401, 2e-6);
  // At the corners of sRGB that program's rounded inverse matrix shows in the sixth digit.
  const Image black = filled(30, 30, 0, 0, 0);
  EXPECT_NEAR(flip_error(black, filled(30, 30, 1, 0, 0)).mean, 0.970497, 1e-5);
  EXPECT_NEAR(flip_error(black, filled(30, 30, 0, 1, 0)).mean, 0.996969, 1e-5);
  EXPECT_NEAR(flip_error(black, filled(30, 30, 0, 0, 1)).mean, 0.958329, 1e-5);
}

TEST(Flip, DoesNotDependOnTheStripsItIsMadeIn) {
  // Below row 64 a second strip begins; a taller picture of the same rows has the same values
  // wherever the filters do not reach its end.
  const auto tall = [](const Image& image, std::uint32_t height) {
    Image out(image.width, height);
    for (std::uint32_t y = 0; y < height; ++y)
      std::copy_n(image.row(y % 64), 3 * image.width, out.row(y));
    return out;
  };
  const FlipErrors one = flip_error(tall(pattern(), 200), tall(changed_pattern(), 200));
  const FlipErrors cut = flip_error(cropped(tall(pattern(), 200), 0, 40, 96, 100),
                                    cropped(tall(changed_pattern(), 200), 0, 40, 96, 100));
  for (std::size_t y = 10; y < 90; ++y)
    for (std::size_t x = 0; x < 96; ++x)
      ASSERT_EQ(cut.map[y * 96 + x], one.map[(y + 40) * 96 + x]) << x << ", " << y;
}

TEST(Heat, ColorsGrowLighterInEqualSteps) {
  const auto& colors = heat_colors();
  const auto linear = [](float v) {
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  double before = -1;
  for (const auto& color : colors) {
    const double r = linear(color[0]), g = linear(color[1]), b = linear(color[2]);
    // Lightness of Oklab.
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    const double lightness = 0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s;
    if (before >= 0) {
      EXPECT_NEAR(lightness - before, 0.98 / 255, 2e-4);
    }
    before = lightness;
  }
  EXPECT_EQ(colors.front(), (std::array{0.0f, 0.0f, 0.0f}));
  EXPECT_NEAR(before, 0.98, 1e-3);
}

TEST(Heat, IsBrightestWhereTheDifferenceIsLargest) {
  Image a(3, 1), b(3, 1);
  b.pixels = {0, 0, 0, 0, 0.25f, 0, 0.5f, 0, 0};
  const std::vector<float> map = difference_map(a, b);
  EXPECT_EQ(map, (std::vector{0.0f, 0.25f, 0.5f}));
  EXPECT_EQ(brightest_difference(map), 0.5);
  EXPECT_EQ(brightest_difference({0, 0.001f}), 1.0 / 16);
  const Image heat = heat_picture(map, 3, 1, 0.5);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(heat.pixels[c], 0);
    EXPECT_EQ(heat.pixels[3 + c], heat_colors()[128][c]);
    EXPECT_EQ(heat.pixels[6 + c], heat_colors()[255][c]);
  }
}

}  // namespace
}  // namespace zraka
