// SPDX-License-Identifier: Apache-2.0
// The slopes that bumps follow, against closed forms and much finer differences.
#include <gtest/gtest.h>

#include <cmath>

#include "texture_places.hpp"

namespace zraka {
namespace {

/// Slopes that a much finer difference gives.
Point slope_by_force(const TextureSet& set, std::uint32_t texture, const TexturePoint& at) {
  const auto bright = [&](const Point& d) {
    TexturePoint moved = at;
    moved.point = at.point + d;
    const TextureValue v = set.value(texture, moved);
    return (v.x + v.y + v.z) / 3;
  };
  const double h = 1e-6;
  return {(bright({h, 0, 0}) - bright({-h, 0, 0})) / (2 * h),
          (bright({0, h, 0}) - bright({0, -h, 0})) / (2 * h),
          (bright({0, 0, h}) - bright({0, 0, -h})) / (2 * h)};
}

TEST(Slope, OfAGradientIsItsClosedForm) {
  Texture gradient = texture_of(TextureKind::gradient, {{0, 0, 0.5}, {1, 2, 0.5}});
  gradient.size = 4;
  gradient.direction = {2, 0, 1};
  gradient.wrap = TextureWrap::clamp;
  Texture scaled = gradient;
  scaled.transform.along_x = {0, 10, 0};  // x of the texture is y in the shape's space
  scaled.transform.along_y = {-10, 0, 0};
  scaled.transform.along_z = {0, 0, 10};
  const TextureSet set({gradient, scaled});
  const double steep = 1 / 4. / std::sqrt(5.);  // brightness rises by 1 over the size
  const Point plain = set.slope(0, point_at(1, 7, 0.5));
  EXPECT_NEAR(plain.x, 2 * steep, 1e-9);
  EXPECT_NEAR(plain.y, 0, 1e-9);
  EXPECT_NEAR(plain.z, steep, 1e-9);
  const Point turned = set.slope(1, point_at(7, 10, 5));
  EXPECT_NEAR(turned.x, 0, 1e-9);
  EXPECT_NEAR(turned.y, 0.2 * steep, 1e-9);
  EXPECT_NEAR(turned.z, 0.1 * steep, 1e-9);
}

TEST(Slope, OfSmoothTexturesIsWhatFinerDifferencesGive) {
  Random random(13);
  for (const TextureKind kind : {TextureKind::noise, TextureKind::marble, TextureKind::wood}) {
    Texture texture = texture_of(kind, {{0, 0, 0}, {1, 1, 0.4}});
    texture.octaves = 3;
    texture.turbulence = kind == TextureKind::marble ? 0 : 0.3;
    texture.transform.along_x = {0, 0.5, 0};
    texture.transform.along_y = {3, 0, 0};
    const TextureSet set({texture});
    double error = 0, size = 0;
    for (int i = 0; i < 500; ++i) {
      const auto at = point_at(any(random, 9), any(random, 9), any(random, 9));
      const Point wanted = slope_by_force(set, 0, at), off = set.slope(0, at) - wanted;
      error += dot(off, off);
      size += dot(wanted, wanted);
    }
    EXPECT_LT(std::sqrt(error / size), 0.05) << static_cast<int>(kind);
    EXPECT_GT(size, 1);
  }
}

TEST(Slope, OfAStepIsSpreadOverTheFootprint) {
  Texture stripes = texture_of(TextureKind::stripes, {{0, 0, 0}, {1, 1, 1}});
  stripes.size = 8;
  const TextureSet set({stripes});
  // A step of 1 across a footprint whose half width is h: 1/(2·h) as far as h, else 0.
  for (const double h : {0.5, 1.0}) {
    EXPECT_NEAR(set.slope(0, footprint_at({8 + 0.9 * h, 0, 0}, {2 * h, 0, 0}, {})).x, 1 / (2 * h),
                1e-12);
    EXPECT_EQ(set.slope(0, footprint_at({8 + 1.1 * h, 0, 0}, {2 * h, 0, 0}, {})).x, 0);
  }
  EXPECT_EQ(set.slope(0, point_at(8 + 0.2, 0, 0)).x, 0);
  EXPECT_NEAR(set.slope(0, point_at(8 + 0.1, 0, 0)).x, 4, 1e-12) << "a 64th of the size";
}

TEST(Slope, OverASurfaceIsAlongUAndV) {
  Texture gradient = texture_of(TextureKind::gradient, {{0, 0, 0}, {1, 1, 1}});
  gradient.mapping = TextureMapping::uv;
  gradient.direction = {3, 4, 0};
  gradient.wrap = TextureWrap::clamp;
  const TextureSet set({gradient});
  TexturePoint at = point_at(100, 200, 300);
  at.u = 0.4;
  at.v = 0.5;
  const Point slope = set.slope(0, at);
  EXPECT_NEAR(slope.x, 0.6, 1e-9);
  EXPECT_NEAR(slope.y, 0.8, 1e-9);
  EXPECT_EQ(slope.z, 0);
}

TEST(Slope, OfAnImageIsThatBetweenItsTexels) {
  // Brightness rises by 0.1 from texel to texel to the right, by 0.05 upwards.
  Image image(8, 4);
  for (std::uint32_t y = 0; y < 4; ++y)
    for (std::uint32_t x = 0; x < 8; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        image.row(3 - y)[3 * x + c] = 0.1f * static_cast<float>(x) + 0.05f * static_cast<float>(y);
  Texture texture = texture_of(TextureKind::image);
  texture.image = std::make_shared<const Image>(image);
  texture.mapping = TextureMapping::uv;
  for (const TextureFilter filter : {TextureFilter::bilinear, TextureFilter::mip}) {
    texture.filter = filter;
    const TextureSet set({texture});
    TexturePoint at;
    at.u = 0.47;
    at.v = 0.51;
    const Point slope = set.slope(0, at);
    EXPECT_NEAR(slope.x, 0.1 * 8, 1e-6);
    EXPECT_NEAR(slope.y, 0.05 * 4, 1e-6);
  }
}

}  // namespace
}  // namespace zraka
