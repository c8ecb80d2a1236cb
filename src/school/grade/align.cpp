// SPDX-License-Identifier: Apache-2.0
#include "school/grade/align.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "image/alter.hpp"

namespace zraka {
namespace {

/// A picture shows another only where it is this much nearer to it than the nearest plain one is,
/// in squared differences: greys and noise are near to many dark pictures, and show none.
constexpr double kShown = 0.25;

float value_at(const Image& image, std::int64_t x, std::int64_t y, std::size_t c) {
  return image
      .pixels[(static_cast<std::size_t>(y) * image.width + static_cast<std::size_t>(x)) * 3 + c];
}

/// Mean squared difference where the right picture lies at (left, top) in the other, over every
/// `step`-th pixel; infinite where less than two thirds of it would be there.
double misfit(const Image& submitted, const Image& right, std::int64_t left, std::int64_t top,
              std::int64_t step) {
  const std::int64_t x0 = std::max<std::int64_t>(0, -left), y0 = std::max<std::int64_t>(0, -top);
  const std::int64_t x1 = std::min<std::int64_t>(right.width, submitted.width - left);
  const std::int64_t y1 = std::min<std::int64_t>(right.height, submitted.height - top);
  if (3 * (x1 - x0) * (y1 - y0) < 2 * std::int64_t{right.width} * right.height)
    return std::numeric_limits<double>::infinity();
  double sum = 0;
  std::int64_t count = 0;
  for (std::int64_t y = y0; y < y1; y += step)
    for (std::int64_t x = x0; x < x1; x += step)
      for (std::size_t c = 0; c < 3; ++c, ++count) {
        const double d = static_cast<double>(value_at(right, x, y, c)) -
                         static_cast<double>(value_at(submitted, x + left, y + top, c));
        sum += d * d;
      }
  return sum / static_cast<double>(count);
}

struct Offset {
  std::int64_t left = 0, top = 0;
};

/// Where the right picture lies in a window: everywhere with few pixels first, then nearby with
/// more.
Offset find_in_window(const Image& submitted, const Image& right) {
  const std::int64_t dx = std::int64_t{submitted.width} - right.width,
                     dy = std::int64_t{submitted.height} - right.height;
  constexpr std::int64_t kSlack = 4;
  Offset best;
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](std::int64_t x0, std::int64_t x1, std::int64_t y0, std::int64_t y1,
                        std::int64_t stride, std::int64_t step) {
    for (std::int64_t y = y0; y <= y1; y += stride)
      for (std::int64_t x = x0; x <= x1; x += stride)
        if (const double d = misfit(submitted, right, x, y, step); d < least)
          least = d, best = {x, y};
  };
  const std::int64_t step = std::max<std::int64_t>(2, right.width / 64);
  look(std::min<std::int64_t>(0, dx) - kSlack, std::max<std::int64_t>(0, dx) + kSlack,
       std::min<std::int64_t>(0, dy) - kSlack, std::max<std::int64_t>(0, dy) + kSlack, 2, step);
  least = std::numeric_limits<double>::infinity();
  const Offset coarse = best;
  look(coarse.left - 2, coarse.left + 2, coarse.top - 2, coarse.top + 2, 1, 2);
  return best;
}

}  // namespace

Fitted fit(const Image& submitted, const Image& right) {
  Fitted fitted;
  fitted.width = submitted.width;
  fitted.height = submitted.height;
  fitted.region = {0, 0, right.width, right.height};
  if (submitted.width == right.width && submitted.height == right.height) {
    fitted.image = submitted;
    return fitted;
  }
  const double across = static_cast<double>(submitted.width) / right.width,
               down = static_cast<double>(submitted.height) / right.height;
  // A window's frame is not that large; and the search below would take long.
  const auto far_from = [](std::uint32_t a, std::uint32_t b) {
    return std::abs(std::int64_t{a} - std::int64_t{b}) > std::int64_t{b} / 2 + 64;
  };
  if (std::fabs(across / down - 1) < 0.01 || far_from(submitted.width, right.width) ||
      far_from(submitted.height, right.height)) {
    fitted.alignment.scaled = true;
    fitted.image = across > 1 ? scaled_by_area(submitted, right.width, right.height)
                              : scaled_bilinearly(submitted, right.width, right.height);
    return fitted;
  }
  const Offset at = find_in_window(submitted, right);
  fitted.alignment.cut = true;
  fitted.alignment.left = static_cast<std::int32_t>(at.left);
  fitted.alignment.top = static_cast<std::int32_t>(at.top);
  fitted.image = Image(right.width, right.height);
  const auto inside = [](std::int64_t from, std::uint32_t size, std::uint32_t room) {
    return std::pair(
        static_cast<std::uint32_t>(std::clamp<std::int64_t>(-from, 0, room)),
        static_cast<std::uint32_t>(std::clamp<std::int64_t>(std::int64_t{size} - from, 0, room)));
  };
  const auto [x0, x1] = inside(at.left, submitted.width, right.width);
  const auto [y0, y1] = inside(at.top, submitted.height, right.height);
  fitted.region = {x0, y0, x1, y1};
  for (std::uint32_t y = y0; y < y1; ++y)
    for (std::uint32_t x = x0; x < x1; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        fitted.image.row(y)[std::size_t{3} * x + c] =
            value_at(submitted, x + at.left, y + at.top, c);
  return fitted;
}

std::vector<Alignment> ways_to_align() {
  std::vector<Alignment> ways;
  for (const bool flipped : {false, true})
    for (const bool swapped : {false, true})
      for (const auto curve :
           {Alignment::Curve::none, Alignment::Curve::srgb, Alignment::Curve::power})
        ways.push_back({.flipped = flipped, .swapped = swapped, .curve = curve});
  return ways;
}

Image aligned(const Image& image, const Alignment& way) {
  Image out = way.flipped ? flipped_vertically(image) : image;
  if (way.swapped) out = with_red_and_blue_swapped(out);
  if (way.curve == Alignment::Curve::srgb) out = decoded(out, Transfer::srgb);
  if (way.curve == Alignment::Curve::power) out = with_power(out, 2.2);
  return out;
}

Image through_scaling(const Image& image, const Fitted& fitted) {
  if (!fitted.alignment.scaled) return image;
  const bool larger = fitted.width > image.width;
  const Image there = larger ? scaled_bilinearly(image, fitted.width, fitted.height)
                             : scaled_by_area(image, fitted.width, fitted.height);
  return larger ? scaled_by_area(there, image.width, image.height)
                : scaled_bilinearly(there, image.width, image.height);
}

double mean_square(const Image& a, const Image& b, const Region& region) {
  double sum = 0;
  for (std::uint32_t y = region.top; y < region.bottom; ++y) {
    const float *p = a.row(y), *q = b.row(y);
    float row = 0;
    for (std::size_t i = std::size_t{3} * region.left; i < std::size_t{3} * region.right; ++i) {
      const float d = p[i] - q[i];
      row += d * d;
    }
    sum += static_cast<double>(row);
  }
  const double values =
      3.0 * (region.right - region.left) * static_cast<double>(region.bottom - region.top);
  return values > 0 ? sum / values : 0;
}

double spread(const Image& image, const Region& region) {
  std::array<double, 3> sum{}, squares{};
  for (std::uint32_t y = region.top; y < region.bottom; ++y)
    for (std::uint32_t x = region.left; x < region.right; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const double value = value_at(image, x, y, c);
        sum[c] += value;
        squares[c] += value * value;
      }
  const double pixels =
      (region.right - region.left) * static_cast<double>(region.bottom - region.top);
  double of_all = 0;
  for (std::size_t c = 0; c < 3 && pixels > 0; ++c) {
    const double mean = sum[c] / pixels;
    of_all += std::max(0.0, squares[c] / pixels - mean * mean);
  }
  return of_all / 3;
}

bool shows(const Image& picture, const Image& other, const Region& region) {
  const double plain = spread(other, region);
  return plain <= kSame ? spread(picture, region) <= kSame
                        : mean_square(picture, other, region) <= kShown * plain;
}

bool is_flat(const Image& image) {
  const Image shape = as_silhouette(image);
  std::array<double, 3> mean{};
  double count = 0, away = 0;
  const auto each = [&](const auto& function) {
    for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3)
      if (shape.pixels[i] > 0)
        for (std::size_t c = 0; c < 3; ++c) function(c, static_cast<double>(image.pixels[i + c]));
  };
  each([&](std::size_t c, double value) { mean[c] += value, count += 1; });
  if (count == 0) return true;
  for (double& value : mean) value /= count / 3;
  each([&](std::size_t c, double value) { away += std::fabs(value - mean[c]); });
  return away / count < 0.03;
}

Image as_silhouette(const Image& image) {
  float brightest = 0;
  for (const float value : image.pixels) brightest = std::max(brightest, value);
  Image out(image.width, image.height);
  for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3) {
    const float most = std::max({image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]});
    const float value = most > 0.4F * brightest && most > 0.1F ? 1.0F : 0.0F;
    for (std::size_t c = 0; c < 3; ++c) out.pixels[i + c] = value;
  }
  return out;
}

}  // namespace zraka
