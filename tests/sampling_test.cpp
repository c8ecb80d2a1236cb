// SPDX-License-Identifier: Apache-2.0
// Random numbers, points that fill the square evenly, warps, pixel filters.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include "sampling/hash.hpp"
#include "sampling/pixel_filter.hpp"
#include "sampling/sobol.hpp"
#include "sampling/warp.hpp"

namespace zraka {
namespace {

constexpr double kPi = 3.14159265358979323846;

TEST(Hash, ChangesHalfOfTheBitsWhicheverOneOfANumberChanges) {
  for (int number = 0; number < 3; ++number)
    for (int bit = 0; bit < 32; ++bit) {
      int changed = 0;
      for (std::uint32_t i = 0; i < 1000; ++i) {
        std::uint32_t key[3] = {7, i, i * i};
        const std::uint32_t before = hash(key[0], key[1], key[2]);
        key[number] ^= 1u << bit;
        changed += std::popcount(before ^ hash(key[0], key[1], key[2]));
      }
      // 32000 fair coins: more than five standard deviations of 89.
      EXPECT_NEAR(changed, 16000, 450) << "number " << number << ", bit " << bit;
    }
  EXPECT_NE(hash(1, 2), hash(2, 1));
  EXPECT_NE(hash(0), hash(0, 0));
}

/// Sobol's second coordinate from direction numbers: each is the one before XORed with half of it.
std::uint32_t by_direction_numbers(std::uint32_t index) {
  std::uint32_t all = 0;
  for (std::uint32_t direction = 1u << 31; index != 0; index >>= 1) {
    if ((index & 1) != 0) all ^= direction;
    direction ^= direction >> 1;
  }
  return all;
}

TEST(Sobol, HasItsDirectionNumbers) {
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const std::uint32_t index = i < 1000 ? i : hash(i);
    ASSERT_EQ(reverse_bits(second_sobol_reversed(index)), by_direction_numbers(index)) << index;
  }
}

/// Whether points [begin, begin + 2^k) have one in each of the 2^k rectangles of each shape.
bool fills_all_intervals(std::uint32_t begin, int k, std::uint32_t scramble) {
  const std::uint32_t n = 1u << k;
  for (int across = 0; across <= k; ++across) {
    std::set<std::pair<int, int>> cells;
    for (std::uint32_t i = begin; i < begin + n; ++i) {
      const Point2 p = sobol_2d(i, scramble);
      cells.insert({static_cast<int>(std::ldexp(p.u, across)),
                    static_cast<int>(std::ldexp(p.v, k - across))});
    }
    if (cells.size() != n) return false;
  }
  return true;
}

TEST(Sobol, HasAPointInEachElementaryIntervalHoweverItIsScrambled) {
  for (const std::uint32_t scramble : {0u, 1u, 77u, 0xFFFFFFFFu})
    for (int k = 0; k <= 10; ++k)
      for (const std::uint32_t block : {0u, 1u, 5u})
        ASSERT_TRUE(fills_all_intervals(block << k, k, scramble))
            << "scramble " << scramble << ", 2^" << k << ", block " << block;
}

TEST(Sobol, HasItsPointsAnywhereByOtherScrambles) {
  // Each point by itself is uniform over scrambles, and two points of one scramble are in different
  // halves in one of three ways.
  constexpr int kScrambles = 20000, kCells = 16;
  for (const std::uint32_t index : {0u, 1u, 6u}) {
    std::vector<int> counts(kCells * kCells);
    for (std::uint32_t s = 0; s < kScrambles; ++s) {
      const Point2 p = sobol_2d(index, s);
      ++counts[static_cast<std::size_t>(p.u * kCells) * kCells +
               static_cast<std::size_t>(p.v * kCells)];
    }
    double chi = 0;
    const double expected = static_cast<double>(kScrambles) / (kCells * kCells);
    for (const int count : counts) chi += (count - expected) * (count - expected) / expected;
    // 255 degrees of freedom: mean 255, standard deviation 22.6.
    EXPECT_LT(chi, 255 + 5 * 22.6) << index;
    EXPECT_GT(chi, 255 - 5 * 22.6) << index;
  }
}

TEST(Sobol, PairsOfDimensionsKnowNothingOfEachOther) {
  // Four dimensions of two scrambles: 4096 points are no worse than random ones in the coordinates
  // that are from different pairs.
  constexpr int kPoints = 4096, kCells = 16;
  std::vector<int> counts(kCells * kCells);
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const double a = sobol_2d(i, hash(5, 0)).u, b = sobol_2d(i, hash(5, 1)).v;
    ++counts[static_cast<std::size_t>(a * kCells) * kCells + static_cast<std::size_t>(b * kCells)];
  }
  double chi = 0;
  for (const int count : counts) chi += (count - 16.0) * (count - 16.0) / 16;
  EXPECT_LT(chi, 255 + 5 * 22.6);
  EXPECT_GT(chi, 20) << "too even: they are one sequence";
}

/// Root of the mean square error of the mean of f, over scrambles.
double error_of(int points, double (*f)(const Point2&), double integral) {
  constexpr int kScrambles = 64;
  double squares = 0;
  for (std::uint32_t s = 0; s < kScrambles; ++s) {
    double sum = 0;
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(points); ++i) sum += f(sobol_2d(i, s));
    squares += std::pow(sum / points - integral, 2);
  }
  return std::sqrt(squares / kScrambles);
}

TEST(Sobol, IntegratesAsOwensTheoryHasIt) {
  // Smooth: the error falls as n^-1.5 (Owen 1997), so from 64 to 4096 points by about 512.
  const auto smooth = [](const Point2& p) { return p.u * p.u * p.v; };
  const double few = error_of(64, smooth, 1.0 / 6), many = error_of(4096, smooth, 1.0 / 6);
  EXPECT_GT(few / many, 256);
  // Random points' error would be the standard deviation, about 0.17, over the root of 4096.
  EXPECT_LT(many, 0.17 / 64 / 200);
  // Not smooth, a disc: as n^-0.75, so by about 22.6 where random points gain 8.
  const auto disc = [](const Point2& p) { return p.u * p.u + p.v * p.v < 1 ? 1.0 : 0.0; };
  const double some = error_of(64, disc, kPi / 4), more = error_of(4096, disc, kPi / 4);
  EXPECT_GT(some / more, 14);
  EXPECT_LT(more, 0.41 / 64 / 5);
}

TEST(Warps, KeepAreas) {
  // Moments of the disc, of the cosine lobe and of the sphere, each closed.
  constexpr int kPoints = 1 << 14;
  double xx = 0, yy = 0, rr4 = 0, z = 0, zz = 0, sphere_z = 0, sphere_xx = 0;
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const Point2 p = sobol_2d(i, 3);
    const DiscPoint d = concentric_disc(p);
    const double r2 = d.x * d.x + d.y * d.y;
    ASSERT_LE(r2, 1 + 1e-12);
    xx += d.x * d.x, yy += d.y * d.y, rr4 += r2 * r2;
    const V3<double> h = cosine_hemisphere(p), s = uniform_sphere(p);
    ASSERT_NEAR(dot(h, h), 1, 1e-12);
    ASSERT_GE(h.z, 0);
    ASSERT_NEAR(dot(s, s), 1, 1e-12);
    z += h.z, zz += h.z * h.z, sphere_z += s.z, sphere_xx += s.x * s.x;
  }
  EXPECT_NEAR(xx / kPoints, 0.25, 1e-4);
  EXPECT_NEAR(yy / kPoints, 0.25, 1e-4);
  EXPECT_NEAR(rr4 / kPoints, 1.0 / 3, 1e-4);
  EXPECT_NEAR(z / kPoints, 2.0 / 3, 1e-4);
  EXPECT_NEAR(zz / kPoints, 0.5, 1e-4);
  EXPECT_NEAR(sphere_z / kPoints, 0, 1e-4);
  EXPECT_NEAR(sphere_xx / kPoints, 1.0 / 3, 1e-4);
}

TEST(Warps, TakeTheSquaresEdgeToTheDiscs) {
  for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0})
    for (const Point2& p : {Point2{0, t}, {1, t}, {t, 0}, {t, 1}}) {
      const DiscPoint d = concentric_disc(p);
      EXPECT_NEAR(d.x * d.x + d.y * d.y, 1, 1e-12);
    }
  EXPECT_EQ(concentric_disc({0.5, 0.5}).x, 0);
}

constexpr PixelFilter kFilters[] = {PixelFilter::box, PixelFilter::tent, PixelFilter::gauss,
                                    PixelFilter::mitchell};

/// The textbook's filters, in one dimension and normalised.
double filter_value(PixelFilter filter, double x) {
  x = std::fabs(x);
  switch (filter) {
    case PixelFilter::box:
      return x < 0.5 ? 1 : 0;
    case PixelFilter::tent:
      return std::max(0.0, 1 - x);
    case PixelFilter::gauss:
      return x > 1.5 ? 0
                     : std::exp(-2 * x * x) / (std::sqrt(kPi / 2) * std::erf(1.5 * std::sqrt(2)));
    case PixelFilter::mitchell: {
      constexpr double b = 1.0 / 3, c = 1.0 / 3;
      if (x < 1)
        return ((12 - 9 * b - 6 * c) * x * x * x + (-18 + 12 * b + 6 * c) * x * x + (6 - 2 * b)) /
               6;
      if (x < 2)
        return ((-b - 6 * c) * x * x * x + (6 * b + 30 * c) * x * x + (-12 * b - 48 * c) * x +
                (8 * b + 24 * c)) /
               6;
      return 0;
    }
  }
  return 0;
}

TEST(PixelFilters, AreWhatTheirSamplesAddUpTo) {
  // The filter's integral over strips of a tenth of a pixel, from samples with their signs and from
  // the textbook.
  for (const PixelFilter filter : kFilters) {
    const PixelFilterShape& shape = PixelFilterShape::of(filter);
    constexpr int kPoints = 1 << 18, kStrips = 40;
    std::vector<double> got(kStrips);
    int negative = 0;
    for (std::uint32_t i = 0; i < kPoints; ++i) {
      const FilterOffset at = shape.offset(sobol_2d(i, 9));
      ASSERT_LE(std::fabs(at.x), shape.radius());
      ASSERT_LE(std::fabs(at.y), shape.radius());
      const double all = shape.positive() + shape.negative();
      got[static_cast<std::size_t>((at.x + 2) * 10)] += (at.negative ? -all : all) / kPoints;
      negative += at.negative;
    }
    EXPECT_NEAR(static_cast<double>(negative) / kPoints,
                shape.negative() / (shape.positive() + shape.negative()), 1e-4);
    for (int strip = 0; strip < kStrips; ++strip) {
      double want = 0;
      for (int i = 0; i < 100; ++i)
        want += filter_value(filter, -2 + (strip + (i + 0.5) / 100) / 10.0) / 1000;
      EXPECT_NEAR(got[static_cast<std::size_t>(strip)], want, 3e-4)
          << static_cast<int>(filter) << ", strip " << strip;
    }
  }
}

/// Where the quick inverse puts a sample.
FilterOffset quick_offset(const InverseFilter& filter, const Sobol2& points, std::uint32_t number) {
  std::uint32_t u = 0, v = 0;
  points.find_bits(number, u, v);
  const auto place = [&](std::uint32_t bits) {
    return filter.places == nullptr ? filter.place<true, double>(bits)
                                    : filter.place<false, double>(bits);
  };
  return {place(u), place(v), filter.is_negative(u) != filter.is_negative(v)};
}

TEST(PixelFilters, ArePlacesAndSignsByTheQuickInverse) {
  for (const PixelFilter filter : kFilters) {
    const PixelFilterShape& shape = PixelFilterShape::of(filter);
    const InverseFilter inverse = shape.inverse();
    const Sobol2 points(11);
    constexpr std::uint32_t kPoints = 1 << 16;
    int other_sign = 0;
    double farthest = 0, sum = 0;
    for (std::uint32_t i = 0; i < kPoints; ++i) {
      const FilterOffset exact = shape.offset(points[i]), quick = quick_offset(inverse, points, i);
      ASSERT_LE(std::fabs(quick.x), shape.radius());
      other_sign += exact.negative != quick.negative;
      farthest = std::max(farthest, std::fabs(exact.x - quick.x));
      sum += std::fabs(exact.x - quick.x);
    }
    EXPECT_LE(other_sign, 1) << static_cast<int>(filter);
    // Within a thousandth of the integral; Mitchell's is flat where it changes its sign and ends.
    EXPECT_LT(farthest, filter == PixelFilter::box ? 1e-7 : filter == PixelFilter::mitchell ? 0.08
                                                                                            : 0.01);
    EXPECT_LT(sum / kPoints, filter == PixelFilter::box ? 1e-7 : 1e-4) << static_cast<int>(filter);
  }
}

TEST(PixelFilters, KeepTheMiddleAndTheOrderOfPoints) {
  for (const PixelFilter filter : kFilters) {
    const PixelFilterShape& shape = PixelFilterShape::of(filter);
    EXPECT_EQ(shape.offset({0.5, 0.5}).x, 0);
    double before = -shape.radius();
    for (int i = 0; i < 5000; ++i) {
      const double x = shape.offset({(i + 0.5) / 5000, 0.5}).x;
      ASSERT_GT(x, before);
      before = x;
    }
    EXPECT_LE(before, shape.radius());
  }
  EXPECT_EQ(PixelFilterShape::of(PixelFilter::box).offset({0.125, 0.75}).x, -0.375);
  EXPECT_EQ(PixelFilterShape::of(PixelFilter::box).offset({0.125, 0.75}).y, 0.25);
}

}  // namespace
}  // namespace zraka
