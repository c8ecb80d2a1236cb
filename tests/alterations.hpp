// SPDX-License-Identifier: Apache-2.0
// What becomes of a right picture on its way to the grader: screenshots, crops, scalings, JPEGs.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <string_view>
#include <vector>
#include <zraka/image.hpp>

#include "image/alter.hpp"

namespace zraka::altered {

enum class Alteration {
  none,
  crop,
  title_bar,
  desktop,
  scaled_117_nearest,
  scaled_125_nearest,
  scaled_125_smooth,
  scaled_any,
  scaled_apart,
  fraction,
  jpeg_85,
  jpeg_60,
  upside_down,
  transposed,
  grid,
  edges_clear,
  count
};
constexpr std::string_view kNames[] = {
    "none",         "crop",       "title bar",      "desktop",    "117 % nearest", "125 % nearest",
    "125 % smooth", "0.5 to 3",   "axes apart",     "fraction",   "JPEG 85",       "JPEG 60",
    "upside down",  "transposed", "unpainted grid", "clear edges"};
static_assert(std::size(kNames) == static_cast<std::size_t>(Alteration::count));

/// A picture, and what its file shall be.
struct Altered {
  Image image;
  int jpeg = 0;  ///< the quality; 0: a PNG
};

using Random = std::mt19937;
inline double from(Random& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() % 100001) / 100000);
}
inline std::uint32_t whole(Random& random, std::uint32_t low, std::uint32_t high) {
  return low + static_cast<std::uint32_t>(random()) % (high - low + 1);
}

inline Image nearest(const Image& image, double factor) {
  Image out(static_cast<std::uint32_t>(std::lround(image.width * factor)),
            static_cast<std::uint32_t>(std::lround(image.height * factor)));
  for (std::uint32_t y = 0; y < out.height; ++y)
    for (std::uint32_t x = 0; x < out.width; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        out.row(y)[3 * x + c] =
            image.row(std::min(image.height - 1, static_cast<std::uint32_t>(y / factor)))
                [3 * std::min(image.width - 1, static_cast<std::uint32_t>(x / factor)) + c];
  return out;
}
inline Image smooth(const Image& image, double across, double down) {
  const auto width = static_cast<std::uint32_t>(std::lround(image.width * across));
  const auto height = static_cast<std::uint32_t>(std::lround(image.height * down));
  return across < 1 || down < 1 ? scaled_by_area(image, width, height)
                                : scaled_bilinearly(image, width, height);
}
inline Image transpose(const Image& image) {
  Image out(image.height, image.width);
  for (std::uint32_t y = 0; y < out.height; ++y)
    for (std::uint32_t x = 0; x < out.width; ++x)
      std::copy_n(image.row(x) + std::size_t{3} * y, 3, out.row(y) + std::size_t{3} * x);
  return out;
}
inline void fill(Image& image, std::uint32_t left, std::uint32_t top, std::uint32_t width,
                 std::uint32_t height, float r, float g, float b) {
  for (std::uint32_t y = top; y < std::min(image.height, top + height); ++y)
    for (std::uint32_t x = left; x < std::min(image.width, left + width); ++x) {
      float* p = image.row(y) + std::size_t{3} * x;
      p[0] = r, p[1] = g, p[2] = b;
    }
}
inline void paste(Image& onto, const Image& image, std::uint32_t left, std::uint32_t top) {
  for (std::uint32_t y = 0; y < image.height; ++y)
    std::copy_n(image.row(y), std::size_t{3} * image.width,
                onto.row(y + top) + std::size_t{3} * left);
}
inline Image framed(const Image& image, Random& random) {
  const std::uint32_t border = whole(random, 1, 8), bar = whole(random, 16, 36);
  Image window(image.width + 2 * border, image.height + bar + border);
  const float grey = static_cast<float>(from(random, 0.2, 0.95));
  fill(window, 0, 0, window.width, window.height, grey, grey, grey);
  // The title and a button.
  for (std::uint32_t x = 10; x < window.width / 2; x += 5)
    fill(window, x, bar / 3, 3, bar / 3, 1 - grey, 1 - grey, 1 - grey);
  fill(window, window.width - 14, bar / 4, 10, bar / 2, 0.8F, 0.1F, 0.1F);
  paste(window, image, border, bar);
  return window;
}
inline Image on_desktop(const Image& image, Random& random) {
  Image screen(image.width * 3, std::max(image.height * 2, image.height + 80));
  const double phase = from(random, 0, 6);
  for (std::uint32_t y = 0; y < screen.height; ++y)
    for (std::uint32_t x = 0; x < screen.width; ++x) {
      float* p = screen.row(y) + std::size_t{3} * x;
      p[0] = static_cast<float>(0.3 + 0.2 * std::sin(phase + 0.02 * x));
      p[1] = static_cast<float>(0.4 + 0.2 * std::sin(phase + 0.03 * y));
      p[2] = static_cast<float>(0.5 + 0.2 * std::sin(phase + 0.01 * (x + y)));
    }
  fill(screen, 0, screen.height - 14, screen.width, 14, 0.1F, 0.1F, 0.12F);
  for (std::uint32_t i = 0; i < 6; ++i)
    fill(screen, 6, 8 + 26 * i, 14, 14, 0.9F, 0.2F * static_cast<float>(i % 4), 0.3F);
  // An editor with lines of text.
  fill(screen, 30, 12, image.width, image.height, 0.97F, 0.97F, 0.97F);
  for (std::uint32_t y = 20; y + 8 < image.height; y += 7)
    fill(screen, 34 + whole(random, 0, 12), y, whole(random, 10, image.width - 20), 3, 0.2F, 0.2F,
         0.5F);
  const Image window = framed(image, random);
  paste(screen, window, whole(random, image.width, screen.width - window.width),
        whole(random, 0, screen.height - window.height - 14));
  return screen;
}
/// As where each pixel is a rectangle of one unit on a screen scaled by 125 %.
inline Image with_unpainted_grid(const Image& image, Random& random) {
  Image out(image.width * 5 / 4, image.height * 5 / 4);
  const float grey = random() % 2 == 0 ? 0.0F : 0.933F;
  fill(out, 0, 0, out.width, out.height, grey, grey, grey);
  for (std::uint32_t y = 0; y < out.height; ++y)
    for (std::uint32_t x = 0; x < out.width; ++x)
      if (x % 5 != 4 && y % 5 != 4)
        std::copy_n(image.row(std::min(image.height - 1, y * 4 / 5 + (y % 5 != 0))) +
                        std::size_t{3} * std::min(image.width - 1, x * 4 / 5 + (x % 5 != 0)),
                    3, out.row(y) + std::size_t{3} * x);
  return out;
}

inline void alter(Altered& a, Alteration how, Random& random) {
  Image& image = a.image;
  const auto scaled_by = [&](double across, double down) { image = smooth(image, across, down); };
  switch (how) {
    case Alteration::crop: {
      const std::uint32_t left = whole(random, 0, image.width / 8),
                          top = whole(random, 0, image.height / 8),
                          right = whole(random, 0, image.width / 8),
                          bottom = whole(random, 1, image.height / 8);
      image = cropped(image, left, top, image.width - left - right, image.height - top - bottom);
      break;
    }
    case Alteration::title_bar:
      image = framed(image, random);
      break;
    case Alteration::desktop:
      image = on_desktop(image, random);
      break;
    case Alteration::scaled_117_nearest:
      image = nearest(image, 1.17);
      break;
    case Alteration::scaled_125_nearest:
      image = nearest(image, 1.25);
      break;
    case Alteration::scaled_125_smooth:
      scaled_by(1.25, 1.25);
      break;
    case Alteration::scaled_any: {
      const double by = std::exp(from(random, std::log(0.5), std::log(3)));
      scaled_by(by, by);
      break;
    }
    case Alteration::scaled_apart: {
      const double by = from(random, 0.8, 1.8);
      scaled_by(by, by * from(random, 0.96, 1.04));
      break;
    }
    case Alteration::fraction:
      image = shifted(image, from(random, 0.1, 3), from(random, 0.1, 3));
      break;
    case Alteration::jpeg_85:
      a.jpeg = 85;
      break;
    case Alteration::jpeg_60:
      a.jpeg = 60;
      break;
    case Alteration::upside_down:
      image = flipped_vertically(image);
      break;
    case Alteration::transposed:
      image = transpose(image);
      break;
    case Alteration::grid:
      image = with_unpainted_grid(image, random);
      break;
    case Alteration::edges_clear:  // as read, they are black
      fill(image, 0, 0, image.width, 2, 0, 0, 0);
      fill(image, 0, 0, 2, image.height, 0, 0, 0);
      fill(image, image.width - 2, 0, 2, image.height, 0, 0, 0);
      break;
    default:
      break;
  }
}

}  // namespace zraka::altered
