// SPDX-License-Identifier: Apache-2.0
#include "contact_sheet.hpp"

#include <algorithm>
#include <cmath>

#include "image/alter.hpp"
#include "school/glyphs/font.hpp"

namespace zraka::app {
namespace {

constexpr std::uint32_t kMargin = 12;
constexpr std::uint32_t kCaptionHeight = 24;
constexpr int kCaptionPixels = 14;
constexpr float kPaper = 0.16f, kInk = 0.92f;

float clamped(float v) {
  return v > 0 ? std::min(v, 1.0f) : 0.0f;
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

Difference difference(const Image& a, const Image& b, Transfer transfer) {
  Difference result{Image(a.width, a.height)};
  float largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
    bool differs = false;
    for (std::size_t c = i; c < i + 3; ++c) {
      result.image.pixels[c] = std::fabs(clamped(a.pixels[c]) - clamped(b.pixels[c]));
      largest = std::max(largest, result.image.pixels[c]);
      differs = differs || quantize(a.pixels[c], transfer, 8) != quantize(b.pixels[c], transfer, 8);
    }
    if (differs) ++result.pixels;
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
      paste(scaled_by_area(encoded(*entry.image, Transfer::linear), width, height), sheet, left,
            top);
      if (font) write_caption(*font, entry.caption, sheet, left, top + height, width);
      left += width + kMargin;
    }
    top += height + kCaptionHeight + kMargin;
  }
  return sheet;
}

}  // namespace zraka::app
