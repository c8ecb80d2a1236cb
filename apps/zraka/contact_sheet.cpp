// SPDX-License-Identifier: Apache-2.0
#include "contact_sheet.hpp"

#include <algorithm>
#include <cmath>

#include "glyphs/font.hpp"

namespace zraka::app {
namespace {

constexpr std::uint32_t kMargin = 12;
constexpr std::uint32_t kCaptionHeight = 24;
constexpr int kCaptionPixels = 14;
constexpr float kPaper = 0.16f, kInk = 0.92f;

float clamped(float v) {
  return v > 0 ? std::min(v, 1.0f) : 0.0f;
}

/// Means over the pixels that fall into each pixel of a smaller picture.
Image reduced(const Image& image, std::uint32_t width, std::uint32_t height) {
  Image small(width, height);
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) {
      const auto from = [](std::uint32_t i, std::uint32_t all, std::uint32_t n) {
        return static_cast<std::uint32_t>(std::uint64_t{i} * all / n);
      };
      const std::uint32_t y0 = from(y, image.height, height),
                          y1 = from(y + 1, image.height, height);
      const std::uint32_t x0 = from(x, image.width, width), x1 = from(x + 1, image.width, width);
      float sum[3] = {};
      for (std::uint32_t v = y0; v < y1; ++v)
        for (std::uint32_t u = x0; u < x1; ++u)
          for (std::size_t c = 0; c < 3; ++c) sum[c] += clamped(image.row(v)[3 * u + c]);
      const auto count = static_cast<float>(std::uint64_t{y1 - y0} * (x1 - x0));
      for (std::size_t c = 0; c < 3; ++c) small.row(y)[3 * x + c] = sum[c] / count;
    }
  return small;
}

void paste(const Image& from, Image& onto, std::uint32_t left, std::uint32_t top) {
  for (std::uint32_t y = 0; y < from.height; ++y)
    std::copy_n(from.row(y), std::size_t{3} * from.width,
                onto.row(top + y) + std::size_t{3} * left);
}

void write_caption(const Font& font, const std::string& caption, Image& onto, std::uint32_t left,
                   std::uint32_t top, std::uint32_t width) {
  const Result<Coverage> ink = font.draw(caption, kCaptionPixels);
  if (!ink || ink->width > static_cast<int>(width) ||
      ink->height > static_cast<int>(kCaptionHeight))
    return;
  // Letters without descenders stand on one line because each caption's ink is centred in its
  // strip.
  const std::uint32_t down = (kCaptionHeight - static_cast<std::uint32_t>(ink->height)) / 2;
  for (int y = 0; y < ink->height; ++y)
    for (int x = 0; x < ink->width; ++x) {
      const float cover = static_cast<float>(ink->at(x, y)) / 255.0f;
      float* pixel = onto.row(top + down + static_cast<std::uint32_t>(y)) +
                     std::size_t{3} * (left + static_cast<std::uint32_t>(x));
      for (int c = 0; c < 3; ++c) pixel[c] += (kInk - pixel[c]) * cover;
    }
}

}  // namespace

Difference difference(const Image& a, const Image& b) {
  Difference result{Image(a.width, a.height)};
  float largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
    float most = 0;
    for (std::size_t c = i; c < i + 3; ++c) {
      result.image.pixels[c] = std::fabs(clamped(a.pixels[c]) - clamped(b.pixels[c]));
      most = std::max(most, result.image.pixels[c]);
    }
    largest = std::max(largest, most);
    if (most > 0.5f / 255.0f) ++result.pixels;
  }
  result.gain = largest > 0 ? std::clamp(1.0 / static_cast<double>(largest), 1.0, kMostGain) : 1.0;
  for (float& v : result.image.pixels) v *= static_cast<float>(result.gain);
  return result;
}

Image contact_sheet(const std::vector<std::vector<Captioned>>& rows, std::uint32_t side) {
  const Image& first = *rows.front().front().image;
  const double shrink =
      std::min(1.0, static_cast<double>(side) / std::max(first.width, first.height));
  const auto shrunk = [&](std::uint32_t n) {
    return std::max<std::uint32_t>(1, static_cast<std::uint32_t>(std::lround(n * shrink)));
  };
  const std::uint32_t width = shrunk(first.width), height = shrunk(first.height);
  std::size_t columns = 0;
  for (const auto& row : rows) columns = std::max(columns, row.size());

  Image sheet(
      static_cast<std::uint32_t>(columns) * (width + kMargin) + kMargin,
      static_cast<std::uint32_t>(rows.size()) * (height + kCaptionHeight + kMargin) + kMargin);
  std::fill(sheet.pixels.begin(), sheet.pixels.end(), kPaper);
  const Result<Font> font = Font::open("");
  std::uint32_t top = kMargin;
  for (const auto& row : rows) {
    std::uint32_t left = kMargin;
    for (const Captioned& entry : row) {
      paste(reduced(*entry.image, width, height), sheet, left, top);
      if (font) write_caption(*font, entry.caption, sheet, left, top + height, width);
      left += width + kMargin;
    }
    top += height + kCaptionHeight + kMargin;
  }
  return sheet;
}

}  // namespace zraka::app
