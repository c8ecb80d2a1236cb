// SPDX-License-Identifier: Apache-2.0
// Textures and places to look them up at, for tests.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "textures/texture_set.hpp"

namespace zraka {

using Point = V3<double>;

inline Texture texture_of(TextureKind kind, std::vector<Color> colors = {{1, 1, 1}, {0, 0, 0}}) {
  Texture texture;
  texture.kind = kind;
  texture.colors = std::move(colors);
  return texture;
}

inline TexturePoint point_at(double x, double y, double z) {
  TexturePoint at;
  at.point = {x, y, z};
  return at;
}

/// A footprint that is a rectangle along two axes, of these widths.
inline TexturePoint footprint_at(const Point& p, const Point& a, const Point& b) {
  TexturePoint at;
  at.point = p;
  at.footprint[0] = a * 0.5;
  at.footprint[1] = b * 0.5;
  return at;
}

inline void expect_color(const TextureValue& value, const Color& wanted, double error = 0) {
  EXPECT_NEAR(value.x, wanted.r, error);
  EXPECT_NEAR(value.y, wanted.g, error);
  EXPECT_NEAR(value.z, wanted.b, error);
}

/// The mean of what is seen without a footprint along a line, at so many points.
inline TextureValue mean_by_force(const TextureSet& set, const Point& p, const Point& a,
                                  int count) {
  TextureValue sum{};
  for (int i = 0; i < count; ++i) {
    const Point q = p + a * ((i + 0.5) / count - 0.5);
    sum = sum + set.value(0, point_at(q.x, q.y, q.z));
  }
  return sum * (1.0 / count);
}

/// The same over a rectangle.
inline TextureValue mean_by_force(const TextureSet& set, const Point& p, const Point& a,
                                  const Point& b, int count) {
  TextureValue sum{};
  for (int i = 0; i < count; ++i)
    sum = sum + mean_by_force(set, p + b * ((i + 0.5) / count - 0.5), a, count);
  return sum * (1.0 / count);
}

inline Color to_color(const TextureValue& v) {
  return {v.x, v.y, v.z};
}

inline double any(Random& random, double size) {
  return size * (2 * random.unit() - 1);
}

inline std::shared_ptr<const Image> any_image(std::uint32_t width, std::uint32_t height) {
  Image image(width, height);
  Random random(1);
  for (float& v : image.pixels) v = static_cast<float>(random.unit());
  return std::make_shared<const Image>(std::move(image));
}

}  // namespace zraka
