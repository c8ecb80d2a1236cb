// SPDX-License-Identifier: Apache-2.0
#include "school/grade/resample.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace zraka {
namespace {

/// The old pixels of one new one along an axis, and their weights.
struct Taps {
  std::uint32_t first = 0;
  std::vector<float> weights;
};

std::vector<Taps> taps_of(std::uint32_t old, double start, double step, std::uint32_t count) {
  std::vector<Taps> axis(count);
  const double half = std::max(std::fabs(step), 1.0) / 2;
  const auto last = static_cast<double>(old) - 1;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double center = start + (i + 0.5) * step;
    const double begin = std::floor(center - half), end = std::ceil(center + half);
    const double from = std::clamp(begin, 0.0, last), to = std::clamp(end - 1, 0.0, last);
    Taps& taps = axis[i];
    taps.first = static_cast<std::uint32_t>(from);
    taps.weights.assign(static_cast<std::size_t>(to - from) + 1, 0.0F);
    for (double p = begin; p < end; ++p) {
      const double share = std::min(p + 1, center + half) - std::max(p, center - half);
      const auto at = static_cast<std::size_t>(std::clamp(p, from, to) - from);
      taps.weights[at] += static_cast<float>(share / (2 * half));
    }
  }
  return axis;
}

/// Both axes of rows with `channels` numbers a pixel.
std::vector<float> resampled(const std::vector<float>& values, std::uint32_t old_width,
                             std::uint32_t old_height, std::size_t channels,
                             const GridPlacement& placement, std::uint32_t width,
                             std::uint32_t height) {
  const std::vector<Taps> across = taps_of(old_width, placement.left, placement.across, width),
                          down = taps_of(old_height, placement.top, placement.down, height);
  const std::size_t old_row = channels * old_width, row = channels * width;
  std::vector<float> out(row * height), mixed(old_row);
  for (std::uint32_t y = 0; y < height; ++y) {
    std::fill(mixed.begin(), mixed.end(), 0.0F);
    for (std::size_t k = 0; k < down[y].weights.size(); ++k) {
      const float weight = down[y].weights[k];
      const float* from = values.data() + (down[y].first + k) * old_row;
      if (weight > 0)
        for (std::size_t i = 0; i < old_row; ++i) mixed[i] += weight * from[i];
    }
    float* to = out.data() + y * row;
    for (std::uint32_t x = 0; x < width; ++x)
      for (std::size_t c = 0; c < channels; ++c) {
        float sum = 0;
        const float* from = mixed.data() + channels * across[x].first + c;
        for (const float weight : across[x].weights) {
          sum += weight * *from;
          from += channels;
        }
        *to++ = sum;
      }
  }
  return out;
}

using Pixel = std::array<float, 3>;

Pixel pixel_of(const Image& image, std::uint32_t x, std::uint32_t y) {
  const float* p = image.row(y) + std::size_t{3} * x;
  return {p[0], p[1], p[2]};
}

float farthest(const Pixel& a, const Pixel& b) {
  return std::max({std::fabs(a[0] - b[0]), std::fabs(a[1] - b[1]), std::fabs(a[2] - b[2])});
}

/// Two colours are different ones from here on.
constexpr float kApart = 0.03F, kApartInJpeg = 0.12F;

/// Columns whose pixels have one colour that neither neighbour has.
bool fill_columns(Image& image, const std::vector<Pixel>& colors, float apart) {
  bool any = false;
  for (const Pixel& color : colors) {
    std::vector<std::uint32_t> lines;
    for (std::uint32_t x = 1; x + 1 < image.width; ++x) {
      std::uint32_t gaps = 0, others = 0, first = image.height, last = 0;
      for (std::uint32_t y = 0; y < image.height; ++y) {
        const bool own = farthest(pixel_of(image, x, y), color) <= apart;
        const bool gap = own && farthest(pixel_of(image, x - 1, y), color) > apart &&
                         farthest(pixel_of(image, x + 1, y), color) > apart;
        if (!gap) continue;
        ++gaps;
        first = std::min(first, y);
        last = y;
      }
      if (gaps < std::max(4U, image.height / 16)) continue;
      for (std::uint32_t y = first; y <= last; ++y)
        others += farthest(pixel_of(image, x, y), color) > apart;
      if (10 * others <= last - first + 1) lines.push_back(x);
    }
    // A letter's stem or a border is no grid.
    if (lines.size() < 5 || lines.size() > image.width / 3) continue;
    any = true;
    for (const std::uint32_t x : lines)
      for (std::uint32_t y = 0; y < image.height; ++y) {
        if (farthest(pixel_of(image, x, y), color) > apart) continue;
        float* p = image.row(y) + std::size_t{3} * x;
        for (std::size_t c = 0; c < 3; ++c) p[c] = 0.5F * (p[c - 3] + p[c + 3]);
      }
  }
  return any;
}

}  // namespace

GridPlacement inverse(const GridPlacement& p) {
  return {-p.left / p.across, -p.top / p.down, 1 / p.across, 1 / p.down};
}

Image resampled(const Image& image, const GridPlacement& placement, std::uint32_t width,
                std::uint32_t height) {
  Image out(width, height);
  out.pixels = resampled(image.pixels, image.width, image.height, 3, placement, width, height);
  return out;
}

Image repeated(const Image& image, const GridPlacement& placement, std::uint32_t width,
               std::uint32_t height) {
  const auto nearest = [](double start, double step, std::uint32_t i, std::uint32_t size) {
    return static_cast<std::uint32_t>(
        std::clamp(std::floor(start + (i + 0.5) * step), 0.0, static_cast<double>(size) - 1));
  };
  Image out(width, height);
  for (std::uint32_t y = 0; y < height; ++y) {
    const float* row = image.row(nearest(placement.top, placement.down, y, image.height));
    for (std::uint32_t x = 0; x < width; ++x)
      std::copy_n(row + std::size_t{3} * nearest(placement.left, placement.across, x, image.width),
                  3, out.row(y) + std::size_t{3} * x);
  }
  return out;
}

Grid resampled(const Grid& plane, const GridPlacement& placement, std::uint32_t width,
               std::uint32_t height) {
  Grid out(width, height);
  out.values = resampled(plane.values, plane.width, plane.height, 1, placement, width, height);
  return out;
}

Image transposed(const Image& image) {
  Image out(image.height, image.width);
  for (std::uint32_t y = 0; y < out.height; ++y)
    for (std::uint32_t x = 0; x < out.width; ++x)
      std::copy_n(image.row(x) + std::size_t{3} * y, 3, out.row(y) + std::size_t{3} * x);
  return out;
}

Grid transposed(const Grid& plane) {
  Grid out(plane.height, plane.width);
  for (std::uint32_t y = 0; y < out.height; ++y)
    for (std::uint32_t x = 0; x < out.width; ++x) out.row(y)[x] = plane.row(x)[y];
  return out;
}

Grid upside_down(const Grid& plane) {
  Grid out(plane.width, plane.height);
  for (std::uint32_t y = 0; y < out.height; ++y)
    std::copy_n(plane.row(plane.height - 1 - y), plane.width, out.row(y));
  return out;
}

bool fill_unpainted(Image& image, bool jpeg) {
  const float apart = jpeg ? kApartInJpeg : kApart;
  // Lines have a colour that pixels between two unlike them have most often.
  std::map<std::array<int, 3>, int> seen;
  for (std::uint32_t y = 0; y < image.height; y += 3)
    for (std::uint32_t x = 1; x + 1 < image.width; ++x) {
      const Pixel p = pixel_of(image, x, y);
      if (farthest(p, pixel_of(image, x - 1, y)) <= apart ||
          farthest(p, pixel_of(image, x + 1, y)) <= apart)
        continue;
      std::array<int, 3> key{};
      for (std::size_t c = 0; c < 3; ++c) key[c] = static_cast<int>(std::lround(p[c] * 32));
      ++seen[key];
    }
  std::vector<std::pair<int, std::array<int, 3>>> most;
  for (const auto& [color, count] : seen) most.emplace_back(count, color);
  std::sort(most.rbegin(), most.rend());
  std::vector<Pixel> colors;
  for (std::size_t i = 0; i < std::min<std::size_t>(2, most.size()); ++i)
    if (most[i].first * 64 > static_cast<int>(image.width) * static_cast<int>(image.height) / 3)
      colors.push_back({static_cast<float>(most[i].second[0]) / 32,
                        static_cast<float>(most[i].second[1]) / 32,
                        static_cast<float>(most[i].second[2]) / 32});
  if (colors.empty()) return false;
  const bool columns = fill_columns(image, colors, apart);
  Image turned = transposed(image);
  const bool rows = fill_columns(turned, colors, apart);
  if (rows) image = transposed(turned);
  return columns || rows;
}

}  // namespace zraka
