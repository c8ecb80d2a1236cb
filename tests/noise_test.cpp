// SPDX-License-Identifier: Apache-2.0
// Noise: where it is zero, its statistics, and that it has no jumps.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "texture_places.hpp"
#include "textures/perlin.hpp"

namespace zraka {
namespace {

TEST(GradientNoise, IsZeroAtWholeNumbersAndHasTheSlopeOfAGradientThere) {
  for (int x = -5; x < 5; ++x)
    for (int y = -5; y < 5; ++y) {
      const Point p{static_cast<double>(x), static_cast<double>(y), 2};
      EXPECT_EQ(gradient_noise(p, 3), 0);
      const double h = 1e-6;
      const double slopes[3] = {(gradient_noise(p + Point{h, 0, 0}, 3)) / h,
                                (gradient_noise(p + Point{0, h, 0}, 3)) / h,
                                (gradient_noise(p + Point{0, 0, h}, 3)) / h};
      double squares = 0;
      for (const double s : slopes) {
        EXPECT_NEAR(std::fabs(s), std::round(std::fabs(s)), 1e-4);
        squares += s * s;
      }
      EXPECT_NEAR(squares, 2, 1e-3);
    }
}

TEST(GradientNoise, HasItsStatistics) {
  Random random(9);
  double sum = 0, squares = 0, most = 0, sizes = 0;
  constexpr int kCount = 300000;
  for (int i = 0; i < kCount; ++i) {
    const double v = gradient_noise({any(random, 1e3), any(random, 1e3), any(random, 1e3)}, 1);
    sum += v;
    squares += v * v;
    sizes += std::fabs(v);
    most = std::fmax(most, std::fabs(v));
  }
  EXPECT_NEAR(sum / kCount, 0, 0.003);
  EXPECT_NEAR(std::sqrt(squares / kCount), 0.27, 0.01);
  EXPECT_NEAR(sizes / kCount, 0.22, 0.01);
  EXPECT_GT(most, 0.8);
  EXPECT_LT(most, 1.04);
}

TEST(GradientNoise, HasNoJumpsAndNoCorners) {
  // Across the borders of cells, too: the second differences stay small.
  const double h = 1e-4;
  for (int i = -30000; i < 30000; ++i) {
    const auto at = [&](int k) { return gradient_noise({k * h, 0.37, k * h * 0.6 + 0.2}, 5); };
    const double a = at(i - 1), b = at(i), c = at(i + 1);
    ASSERT_LT(std::fabs(c - b), 5 * h);
    ASSERT_LT(std::fabs(a - 2 * b + c), 60 * h * h);
  }
}

TEST(GradientNoise, IsAnotherOneForEverySeedAndEverywhere) {
  Random random(10);
  double product = 0, shifted = 0;
  constexpr int kCount = 100000;
  for (int i = 0; i < kCount; ++i) {
    const Point p{any(random, 100), any(random, 100), any(random, 100)};
    product += gradient_noise(p, 1) * gradient_noise(p, 2);
    shifted += gradient_noise(p, 1) * gradient_noise(p + Point{256, 0, 0}, 1);
  }
  EXPECT_NEAR(product / kCount, 0, 0.002);
  EXPECT_NEAR(shifted / kCount, 0, 0.002);
  EXPECT_EQ(gradient_noise({1e300, 0, 0}, 1), 0);
  EXPECT_EQ(gradient_noise({std::nan(""), 0, 0}, 1), 0);
}

TEST(Noise, HasTheSpreadOfOneOctaveWithAnyNumberOfThem) {
  Random random(11);
  for (const int octaves : {1, 3, 8}) {
    Texture noise = texture_of(TextureKind::noise, {{0, 0, 0}, {1, 1, 1}});
    noise.octaves = octaves;
    noise.size = 0.1;
    const TextureSet set({noise});
    double sum = 0, squares = 0;
    constexpr int kCount = 60000;
    for (int i = 0; i < kCount; ++i) {
      const double v = set.value(0, point_at(any(random, 99), any(random, 99), any(random, 99))).x;
      ASSERT_GE(v, 0);
      ASSERT_LE(v, 1);
      sum += v;
      squares += (v - 0.5) * (v - 0.5);
    }
    EXPECT_NEAR(sum / kCount, 0.5, 0.005);
    EXPECT_NEAR(std::sqrt(squares / kCount), 0.135, 0.005);
  }
}

TEST(Noise, IsAnotherOneForEverySeedAndNotFlatAtItsOrigin) {
  Texture noise = texture_of(TextureKind::noise), other = noise;
  other.seed = 1;
  const TextureSet set({noise, other});
  double product = 0, squares = 0;
  for (int x = 0; x < 100; ++x)
    for (int z = 0; z < 100; ++z) {
      const double a = set.value(0, point_at(x, 0, z)).x - 0.5;
      product += a * (set.value(1, point_at(x, 0, z)).x - 0.5);
      squares += a * a;
    }
  EXPECT_NEAR(product / 1e4, 0, 0.002);
  EXPECT_GT(std::sqrt(squares / 1e4), 0.08);
}

TEST(Noise, FadesOctaveByOctave) {
  Random random(20);
  const double share = 0.2 * 0.2 * (3 - 2 * 0.2);  // of what is filtered, 0.6 cells wide
  for (int i = 0; i < 100; ++i) {
    const Point p{any(random, 50), any(random, 50), any(random, 50)};
    const Fractal one{1, 4}, two{2, 4};
    EXPECT_NEAR(one(p, 0.75), one(p, 0) / 2, 1e-12);
    EXPECT_NEAR(two(p, 0.3), two(p, 0) + (two(p, 0.5) - two(p, 0)) * share, 1e-12);
    EXPECT_NEAR(one.turbulence(p, 0.75), (one.turbulence(p, 0) + one.turbulence(p, 1)) / 2, 1e-12);
  }
}

TEST(Noise, OfAbsoluteValuesFadesToItsMean) {
  Random random(21);
  const Fractal fractal{4, 2};
  double sum = 0;
  for (int i = 0; i < 50000; ++i)
    sum += fractal.turbulence({any(random, 99), any(random, 99), any(random, 99)}, 0);
  EXPECT_NEAR(fractal.turbulence({1, 2, 3}, 9), sum / 50000, 0.003);
}

TEST(Noise, GoesByTheWidestOfAFootprint) {
  Texture noise = texture_of(TextureKind::noise);
  const TextureSet set({noise});
  Random random(22);
  const double s = std::sqrt(0.5);
  for (int i = 0; i < 100; ++i) {
    const Point p{any(random, 50), any(random, 50), any(random, 50)};
    const Point a{0, 0.3, 0.4}, b{0.1, 0, 0};
    const double value = set.value(0, footprint_at(p, a, b)).x;
    EXPECT_EQ(set.value(0, footprint_at(p, {0.5, 0, 0}, {})).x, value);
    // The same ellipse by two other half axes of it.
    EXPECT_NEAR(set.value(0, footprint_at(p, (a + b) * s, (a - b) * s)).x, value, 1e-12);
  }
}

TEST(Noise, LeavesOutWhatIsFinerThanAFootprint) {
  Texture noise = texture_of(TextureKind::noise), first = noise;
  noise.octaves = 5;
  first.octaves = 1;
  const TextureSet set({noise, first});
  Random random(12);
  double rough = 0;
  for (int i = 0; i < 1000; ++i) {
    const Point p{any(random, 50), any(random, 50), any(random, 50)};
    EXPECT_EQ(set.value(0, footprint_at(p, {1, 0, 0}, {0, 0, 0})).x, 0.5);
    // Half a grain wide, the first octave is all that is left; in five of them it has its share.
    const double left = set.value(0, footprint_at(p, {0.3, 0, 0}, {0, 0.4, 0.3})).x - 0.5;
    const double alone = set.value(1, point_at(p.x, p.y, p.z)).x - 0.5;
    EXPECT_NEAR(left, alone / std::sqrt(1 + 1 / 4. + 1 / 16. + 1 / 64. + 1 / 256.), 1e-12);
    rough += std::fabs(set.value(0, point_at(p.x, p.y, p.z)).x - 0.5 - left);
  }
  EXPECT_GT(rough / 1000, 0.02);
}

TEST(Noise, IsTheSameAtManyPlacesAsAtEach) {
  Random random(21);
  constexpr std::size_t kCount = Fractal::kMostTogether;
  int apart = 0;
  for (int i = 0; i < 3000; ++i) {
    const Fractal fractal{1 + i % 5, static_cast<std::uint32_t>(i)};
    Point p[kCount];
    // Some in one cell, some in many; some nowhere.
    const double step = i % 3 == 0 ? 0.3 : 0.02;
    const double far = i % 50 == 0 ? 1e300 : i % 50 == 1 ? std::nan("") : 0;
    const Point middle{any(random, 9) + far, any(random, 9), any(random, 9)};
    for (std::size_t k = 0; k < kCount; ++k) {
      p[k] = middle;
      if (i % 7 == 0) p[k] = {any(random, 3), any(random, 3), any(random, 3)};
      (k < 2 ? p[k].x : k < 4 ? p[k].y : p[k].z) += k % 2 == 0 ? step : -step;
    }
    apart += std::floor(p[0].x) != std::floor(p[1].x) ? 1 : 0;
    const double width = i % 4 == 0 ? 0.3 : 0;
    for (const std::size_t count : {kCount, std::size_t{4}}) {
      double values[kCount];
      fractal.at_each(p, count, width, values);
      for (std::size_t k = 0; k < count; ++k)
        EXPECT_EQ(std::bit_cast<std::uint64_t>(values[k]),
                  std::bit_cast<std::uint64_t>(fractal(p[k], width)))
            << i << " " << k;
    }
  }
  EXPECT_GT(apart, 300);
}

}  // namespace
}  // namespace zraka
