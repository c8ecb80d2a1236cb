// SPDX-License-Identifier: Apache-2.0
// Indices of refraction against formulas and catalogues.
#include "materials/dispersion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "materials/glasses.hpp"

namespace zraka {
namespace {

TEST(Dispersion, OfNothingIsTheIor) {
  for (const double wavelength : {0.4, kLineD, 0.7})
    EXPECT_EQ(refractive_index({}, 1.5, wavelength), 1.5);
}

TEST(Dispersion, ByAbbesNumberHasThatNumberAndTheIor) {
  for (const double abbe : {20.0, 64.2, 95.0}) {
    const Dispersion dispersion{Dispersion::Kind::abbe, {abbe}};
    EXPECT_DOUBLE_EQ(refractive_index(dispersion, 1.5, kLineD), 1.5);
    EXPECT_NEAR(abbe_number(dispersion, 1.5), abbe, 1e-10);
    // Two terms of Cauchy's: the index is a line over 1/λ².
    const auto at = [&](double inverse_square) {
      return refractive_index(dispersion, 1.5, 1 / std::sqrt(inverse_square));
    };
    EXPECT_NEAR(at(3) - at(2), at(5) - at(4), 1e-15);
    EXPECT_GT(at(3), at(2)) << "blue is bent more";
  }
}

TEST(Dispersion, ByCauchyIsThePolynomial) {
  const Dispersion dispersion{Dispersion::Kind::cauchy, {1.5, 0.004, -0.0001}};
  for (const double w : {0.4, 0.55, 0.7})
    EXPECT_DOUBLE_EQ(refractive_index(dispersion, 9, w),
                     1.5 + 0.004 / (w * w) - 0.0001 / (w * w * w * w));
}

TEST(Dispersion, BySellmeierIsTheSum) {
  const Dispersion dispersion{Dispersion::Kind::sellmeier, {1, 0.25, 0, 0.01, 100, 0}};
  // At λ² = 0.25: 1 + 0.25/0.24 - 0.0625/99.75.
  EXPECT_DOUBLE_EQ(refractive_index(dispersion, 9, 0.5),
                   std::sqrt(1 + 0.25 / 0.24 - 0.0625 / 99.75));
}

TEST(Dispersion, HasAnIndexOrNot) {
  EXPECT_TRUE(has_index({}, 1.5));
  EXPECT_TRUE(has_index({Dispersion::Kind::abbe, {60}}, 1.5));
  EXPECT_FALSE(has_index({Dispersion::Kind::abbe, {0}}, 1.5));
  EXPECT_FALSE(has_index({Dispersion::Kind::cauchy, {1, -1, 0}}, 1.5));
  EXPECT_FALSE(has_index({Dispersion::Kind::sellmeier, {1, 0, 0, 0.36, 0, 0}}, 1.5))
      << "it resonates at 0.6 µm";
}

/// Of catalogues: n_d, Abbe's number, and how exactly they say them.
struct Known {
  const char* name;
  double index, abbe, index_error = 6e-6, abbe_error = 0.006;
};

TEST(Glasses, HaveTheIndexAndAbbesNumberOfCatalogues) {
  const Known known[] = {{"BK7", 1.51680, 64.17},
                         {"N-BK7", 1.51680, 64.17},
                         {"K5", 1.52249, 59.48},
                         {"N-K5", 1.52249, 59.48},
                         {"N-FK51A", 1.48656, 84.47},
                         {"BAK1", 1.57250, 57.55},
                         {"N-BAK1", 1.57250, 57.55},
                         {"BAK4", 1.56883, 55.98},
                         {"N-BAK4", 1.56883, 55.98},
                         {"SK16", 1.62041, 60.32},
                         {"N-SK16", 1.62041, 60.32},
                         {"BAF10", 1.67003, 47.11},
                         {"N-BAF10", 1.67003, 47.11},
                         {"F2", 1.62004, 36.37},
                         {"N-F2", 1.62005, 36.43},
                         {"SF5", 1.67270, 32.21},
                         {"SF10", 1.72825, 28.41},
                         {"SF11", 1.78472, 25.76},
                         {"N-SF11", 1.78472, 25.68},
                         {"SF6", 1.80518, 25.43},
                         {"N-SF6", 1.80518, 25.36},
                         {"SF57", 1.84666, 23.83},
                         {"LASF9", 1.85025, 32.17},
                         {"N-LASF9", 1.85025, 32.17},
                         {"fused silica", 1.45846, 67.82},
                         {"quartz glass", 1.45846, 67.82},
                         {"sapphire", 1.7682, 72.2, 1e-4, 0.2},
                         {"diamond", 2.4175, 55.3, 1e-4, 0.1},
                         {"acrylic", 1.491, 53, 1e-3, 1},
                         {"PMMA", 1.491, 53, 1e-3, 1},
                         {"polycarbonate", 1.585, 28, 1e-3, 1},
                         {"polystyrene", 1.592, 30, 1e-3, 1},
                         {"water", 1.33340, 55.8, 1e-5, 0.1},
                         {"ice", 1.3098, 53, 2e-4, 3},
                         {"ethanol", 1.3617, 59, 1e-4, 2}};
  EXPECT_EQ(std::size(known), glasses().size());
  for (const Known& each : known) {
    SCOPED_TRACE(each.name);
    const Glass* const glass = glass_named(each.name);
    ASSERT_NE(glass, nullptr);
    EXPECT_NEAR(glass->ior(), each.index, each.index_error);
    EXPECT_NEAR(abbe_number(glass->dispersion, 1), each.abbe, each.abbe_error);
    EXPECT_TRUE(has_index(glass->dispersion, 1));
    EXPECT_FALSE(glass->source.empty());
  }
}

TEST(Glasses, OfWaterAndIceAreNearWhatWasMeasured) {
  // All four terms of Daimon and Masumura (2007), and some of Warren and Brandt's table (2008).
  const double terms[4][2] = {{5.684027565e-1, 5.101829712e-3},
                              {1.726177391e-1, 1.821153936e-2},
                              {2.086189578e-2, 2.620722293e-2},
                              {1.130748688e-1, 1.069792721e1}};
  for (double w = 0.38; w < 0.78; w += 0.01) {
    double sum = 1;
    for (const auto& [b, c] : terms) sum += b * w * w / (w * w - c);
    EXPECT_NEAR(refractive_index(glass_named("water")->dispersion, 1, w), std::sqrt(sum), 4e-5);
  }
  const double table[][2] = {{0.4, 1.3194},  {0.42, 1.3177}, {0.45, 1.3157}, {0.5, 1.3130},
                             {0.55, 1.3110}, {0.6, 1.3094},  {0.65, 1.3080}, {0.7, 1.3069}};
  for (const auto& [w, index] : table)
    EXPECT_NEAR(refractive_index(glass_named("ice")->dispersion, 1, w), index, 2e-4) << w;
}

TEST(Glasses, AreKnownInAnyCase) {
  EXPECT_EQ(glass_named("bk7"), glass_named("BK7"));
  EXPECT_EQ(glass_named("Fused Silica"), glass_named("fused silica"));
  EXPECT_EQ(glass_named("n-sf11")->name, "N-SF11");
  EXPECT_EQ(glass_named("BK"), nullptr);
  EXPECT_EQ(glass_named("BK77"), nullptr);
  EXPECT_EQ(glass_named(""), nullptr);
}

}  // namespace
}  // namespace zraka
