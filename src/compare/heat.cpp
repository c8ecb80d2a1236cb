// SPDX-License-Identifier: Apache-2.0
// Heat maps, and the colours they are drawn in.
#include <algorithm>
#include <numbers>
#include <zraka/compare.hpp>

#include "compare/difference.hpp"
#include "image/transfer.hpp"

namespace zraka {
namespace {

constexpr double kLeastBrightest = 1.0 / 16;

/// Cosine and sine by their series, so that the colours are the same on every system.
std::array<double, 2> cosine_and_sine(double angle) {
  double cosine = 0, sine = 0, term = 1;
  for (int n = 0; n < 40; n += 2) {
    cosine += term;
    sine += term * angle / (n + 1);
    term *= -angle * angle / ((n + 1) * (n + 2));
  }
  return {cosine, sine};
}

/// From Oklab to what a screen is given, with the constants of its definition.
std::array<float, 3> screen_color(double lightness, double a, double b) {
  const auto cube = [](double v) { return v * v * v; };
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  const std::array<double, 3> linear = {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                                        -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                                        -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
  std::array<float, 3> color{};
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = static_cast<float>(encode_srgb(std::clamp(linear[c], 0.0, 1.0)));
  return color;
}

/// Lightness from 0 to 0.98 in equal steps, hue from 270° (violet) by way of 0° (red) to 80°
/// (yellow), and as much chroma as fits into sRGB all along, none at both ends: neighbours are
/// equally far apart, to 1 %.
std::array<std::array<float, 3>, 256> make_colors() {
  constexpr double kDegree = std::numbers::pi / 180;
  std::array<std::array<float, 3>, 256> colors{};
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const double t = static_cast<double>(i) / 255;
    const auto [cosine, sine] = cosine_and_sine((170 * t - 90) * kDegree);
    const double chroma = 0.17 * cosine_and_sine(std::numbers::pi * t)[1];
    colors[i] = screen_color(0.98 * t, chroma * cosine, chroma * sine);
  }
  return colors;
}

const std::array<float, 3>& color_of(double heat) {
  const double index = heat > 0 ? std::min(heat, 1.0) * 255 + 0.5 : 0;
  return heat_colors()[static_cast<std::size_t>(index)];
}

}  // namespace

const std::array<std::array<float, 3>, 256>& heat_colors() {
  static const auto colors = make_colors();
  return colors;
}

std::vector<float> difference_map(const Image& a, const Image& b) {
  std::vector<float> map(a.pixels.size() / 3);
  for (std::size_t i = 0; i < map.size(); ++i)
    map[i] = pixel_difference(a.pixels.data() + 3 * i, b.pixels.data() + 3 * i);
  return map;
}

double brightest_difference(const std::vector<float>& map) {
  double brightest = kLeastBrightest;
  for (const float v : map) brightest = std::max(brightest, static_cast<double>(v));
  return brightest;
}

Image heat_picture(const std::vector<float>& map, std::uint32_t width, std::uint32_t height,
                   double brightest) {
  Image picture(width, height);
  float* out = picture.pixels.data();
  for (const float v : map) {
    const std::array<float, 3>& color = color_of(static_cast<double>(v) / brightest);
    out = std::copy(color.begin(), color.end(), out);
  }
  return picture;
}

}  // namespace zraka
