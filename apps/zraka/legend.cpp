// SPDX-License-Identifier: Apache-2.0
#include "legend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/text.hpp"
#include "image/transfer.hpp"
#include "school/glyphs/font.hpp"

namespace zraka::app {
namespace {

/// A line of text as ink.
Result<Coverage> ink_of(const Font& font, std::string text, int pixels) {
  constexpr std::size_t kLongest = 28;
  if (text.size() > kLongest) text = shown(text.substr(0, kLongest)) + "…";
  Result<Coverage> ink = font.draw(text, pixels);
  return ink ? std::move(ink) : font.draw("?", pixels);
}

/// In the places of a picture that a rectangle of it covers.
class Strip {
 public:
  Strip(Image& image, float ink) : image_(image), ink_(ink) {}

  void write(const Coverage& text, int left, int top) const {
    for (int y = 0; y < text.height; ++y)
      for (int x = 0; x < text.width; ++x) {
        const float cover = static_cast<float>(text.at(x, y)) / 255.0f;
        float* const at = pixel(left + x, top + y);
        for (int c = 0; at != nullptr && c < 3; ++c) at[c] += (ink_ - at[c]) * cover;
      }
  }
  void line(int left, int top, int width) const {
    for (int x = 0; x < width; ++x)
      if (float* const at = pixel(left + x, top)) std::fill_n(at, 3, ink_);
  }
  float* pixel(int x, int y) const {
    if (x < 0 || y < 0 || x >= static_cast<int>(image_.width) ||
        y >= static_cast<int>(image_.height))
      return nullptr;
    return image_.row(static_cast<std::uint32_t>(y)) + 3 * x;
  }

 private:
  Image& image_;
  float ink_;
};

struct Label {
  double number;
  Coverage ink;
};

/// What one legend is made of.
struct Bar {
  const ColorLegend* legend;
  Coverage title;
  std::vector<Label> labels;

  int width(int unit) const {
    int widest = 0;
    for (const Label& label : labels) widest = std::max(widest, label.ink.width);
    return std::max(title.width, 2 * unit + unit / 2 + widest);
  }
};

Result<Bar> bar_of(const ColorLegend& legend, const Font& font, int pixels) {
  Bar bar{&legend, {}, {}};
  Result<Coverage> title = ink_of(font, legend.title, pixels);
  if (!title) return tl::make_unexpected(title.error());
  bar.title = std::move(*title);
  for (const double tick : legend_ticks(legend.low, legend.high)) {
    Result<Coverage> ink = ink_of(font, fmt::format("{:.6g}", tick), pixels);
    if (!ink) return tl::make_unexpected(ink.error());
    bar.labels.push_back({tick, std::move(*ink)});
  }
  return bar;
}

/// The colour of a bar at a share of its height, as the picture has light.
void put_color(const ColorLegend& legend, double share, Transfer transfer, float* pixel) {
  const auto last = static_cast<double>(legend.colors.size() - 1);
  const std::uint32_t rgb =
      legend.colors[static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * last + 0.5)];
  for (int c = 0; c < 3; ++c) {
    const double value = (rgb >> (16 - 8 * c) & 255) / 255.0;
    pixel[c] = static_cast<float>(transfer == Transfer::srgb ? decode_srgb(value) : value);
  }
}

void draw(const Bar& bar, const Strip& strip, int left, int top, int height, int unit,
          Transfer transfer) {
  strip.write(bar.title, left, top);
  const int first = top + bar.title.height + unit, rows = top + height - first - unit / 2;
  const double range = bar.legend->high - bar.legend->low;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < unit + unit / 2; ++x)
      if (float* const at = strip.pixel(left + x, first + y))
        put_color(*bar.legend, rows > 1 ? 1 - y / (rows - 1.0) : 0.5, transfer, at);
  for (const Label& label : bar.labels) {
    const double share = range > 0 ? (label.number - bar.legend->low) / range : 0.5;
    const int y = first + static_cast<int>(std::lround((1 - share) * (rows - 1)));
    strip.line(left + unit + unit / 2, y, unit / 2);
    strip.write(label.ink, left + 2 * unit + unit / 2, y - label.ink.height / 2);
  }
}

}  // namespace

std::vector<double> legend_ticks(double low, double high) {
  if (!(high > low)) return {low};
  const double rough = (high - low) / 6, power = std::pow(10, std::floor(std::log10(rough)));
  const double ratio = rough / power;
  const double step = power * (ratio < 1.5 ? 1 : ratio < 3.5 ? 2 : ratio < 7.5 ? 5 : 10);
  std::vector<double> ticks;
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + step * 1e-9; ++k)
    ticks.push_back(k == 0 ? 0.0 : k * step);
  return ticks;
}

Result<Image> with_legends(const Image& picture, const std::vector<ColorLegend>& legends,
                           const Color& background, Transfer transfer) {
  const Result<Font> font = Font::open("");
  if (!font) return tl::make_unexpected(font.error());
  const int height = static_cast<int>(picture.height);
  const int unit = std::clamp(height / 40, 8, 40);
  std::vector<Bar> bars;
  int width = 0;
  for (const ColorLegend& legend : legends) {
    Result<Bar> bar = bar_of(legend, *font, unit);
    if (!bar) return tl::make_unexpected(bar.error());
    width = std::max(width, bar->width(unit));
    bars.push_back(std::move(*bar));
  }
  Image all(picture.width + static_cast<std::uint32_t>(width + 2 * unit), picture.height);
  const float paper[] = {static_cast<float>(background.r), static_cast<float>(background.g),
                         static_cast<float>(background.b)};
  for (std::uint32_t y = 0; y < all.height; ++y) {
    std::copy_n(picture.row(y), std::size_t{3} * picture.width, all.row(y));
    for (std::uint32_t x = picture.width; x < all.width; ++x)
      std::copy_n(paper, 3, all.row(y) + std::size_t{3} * x);
  }
  const bool is_dark = 0.2126f * paper[0] + 0.7152f * paper[1] + 0.0722f * paper[2] < 0.2f;
  const Strip strip(all, is_dark ? 0.85f : 0.0f);
  const int each = height / static_cast<int>(bars.size());
  for (std::size_t i = 0; i < bars.size(); ++i)
    draw(bars[i], strip, static_cast<int>(picture.width) + unit, each * static_cast<int>(i) + unit,
         each - 2 * unit, unit, transfer);
  return all;
}

}  // namespace zraka::app
