// SPDX-License-Identifier: Apache-2.0
#include "school/grade/align.hpp"

#include <algorithm>
#include <array>
#include <cmath>

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

/// A region that nothing outside of it has blurred, less rows and columns at its edges that have
/// one colour: transparent ones, as screenshots of windows have.
Region visible_region(const Fitted& fitted, std::uint32_t width, std::uint32_t height) {
  const GridPlacement& p = fitted.placement;
  const Shown& shown = fitted.shown;
  const auto begin = [](double from, double start, double step, std::uint32_t room) {
    return static_cast<std::uint32_t>(
        std::clamp(std::ceil((from - start) / step - 0.01), 0.0, static_cast<double>(room)));
  };
  const auto end = [](double to, double start, double step, std::uint32_t room) {
    return static_cast<std::uint32_t>(
        std::clamp(std::floor((to - start) / step + 0.01), 0.0, static_cast<double>(room)));
  };
  const double right = std::min<double>(fitted.width, shown.right),
               bottom = std::min<double>(fitted.height, shown.bottom);
  Region region{begin(shown.left, p.left, p.across, width), begin(shown.top, p.top, p.down, height),
                end(right, p.left, p.across, width), end(bottom, p.top, p.down, height)};
  if (!fitted.exact && region.right > region.left + 8 && region.bottom > region.top + 8)
    region = {region.left + 1, region.top + 1, region.right - 1, region.bottom - 1};
  return region;
}

}  // namespace

Image turned_by(const Image& submitted, const Turn& turn) {
  Image turned = turn.flipped_first ? flipped_vertically(submitted) : submitted;
  if (turn.transposed) turned = transposed(turned);
  return turn.flipped ? flipped_vertically(turned) : turned;
}

namespace {

Fitted fitted_at(const Position& position, const std::shared_ptr<const Image>& turned,
                 bool unpainted, std::uint32_t width, std::uint32_t height) {
  Fitted fitted;
  const Turn& turn = position.turn;
  const Image& painted = *turned;
  Alignment& alignment = fitted.alignment;
  alignment.unpainted = unpainted;
  fitted.turn = turn;
  alignment.transposed = turn.transposed;
  alignment.flipped = turn.flipped != turn.flipped_first;
  fitted.width = painted.width;
  fitted.height = painted.height;
  const GridPlacement& at = fitted.placement = position.placement;
  const auto is_whole = [](double value) { return value == std::round(value); };
  fitted.exact =
      at.across == 1 && at.down == 1 && is_whole(at.left) && is_whole(at.top) && !unpainted;
  fitted.smallest = std::min(at.across, at.down);
  fitted.softened = !fitted.exact && fitted.smallest <= 0.97;
  fitted.likeness = position.likeness;
  alignment.scaled = at.across != 1 || at.down != 1;
  alignment.across = at.across;
  alignment.down = at.down;
  alignment.left = at.left;
  alignment.top = at.top;
  alignment.cut = std::fabs(at.left) > 0.75 || std::fabs(at.top) > 0.75 ||
                  std::fabs(at.left + at.across * width - fitted.width) > 0.75 ||
                  std::fabs(at.top + at.down * height - fitted.height) > 0.75;
  const bool is_all = at == GridPlacement{} && painted.width == width && painted.height == height;
  fitted.image = is_all ? painted : resampled(painted, at, width, height);
  if (!is_all || !fitted.exact) fitted.source = turned;
  fitted.region = visible_region(fitted, width, height);
  return fitted;
}

}  // namespace

Fitted fitted_at(const Position& position, const Image& painted, bool unpainted,
                 std::uint32_t width, std::uint32_t height) {
  return fitted_at(position, std::make_shared<const Image>(turned_by(painted, position.turn)),
                   unpainted, width, height);
}

Fitted placed_at(const Fitted& fitted, const GridPlacement& placement) {
  Fitted moved = fitted_at({fitted.turn, placement, fitted.likeness}, fitted.source,
                           fitted.alignment.unpainted, fitted.image.width, fitted.image.height);
  moved.pictures = fitted.pictures;
  moved.shown = fitted.shown;
  moved.region = visible_region(moved, moved.image.width, moved.image.height);
  return moved;
}

Fitted between_pixels(const Fitted& fitted) {
  Fitted loose = fitted;
  loose.exact = false;
  if (loose.source == nullptr) loose.source = std::make_shared<const Image>(fitted.image);
  loose.region = visible_region(loose, loose.image.width, loose.image.height);
  return loose;
}

std::vector<Fitted> fit(const Image& submitted, bool jpeg, const Template& searched,
                        std::uint32_t width, std::uint32_t height) {
  Image painted = submitted;
  const bool unpainted = fill_unpainted(painted, jpeg);
  std::vector<Fitted> all;
  // They are turned alike, but for the whole.
  std::shared_ptr<const Image> turned;
  Turn last;
  for (const Position& position : searched.find(painted)) {
    if (turned == nullptr || position.turn != last)
      turned = std::make_shared<const Image>(turned_by(painted, position.turn));
    last = position.turn;
    all.push_back(fitted_at(position, turned, unpainted, width, height));
  }
  return all;
}

std::vector<Alignment> ways_to_align() {
  std::vector<Alignment> ways;
  for (const bool swapped : {false, true})
    for (const auto curve :
         {Alignment::Curve::none, Alignment::Curve::srgb, Alignment::Curve::power})
      ways.push_back({.swapped = swapped, .curve = curve});
  return ways;
}

Image aligned(const Image& image, const Alignment& way) {
  Image out = way.swapped ? with_red_and_blue_swapped(image) : image;
  if (way.curve == Alignment::Curve::srgb) out = decoded(out, Transfer::srgb);
  if (way.curve == Alignment::Curve::power) out = with_power(out, 2.2);
  return out;
}

Image scaled_into(const Image& image, const Fitted& fitted, std::uint32_t width,
                  std::uint32_t height) {
  const GridPlacement back = inverse(fitted.placement);
  return fitted.repeated ? repeated(image, back, width, height)
                         : resampled(image, back, width, height);
}

Image through_scaling(const Image& image, const Fitted& fitted) {
  if (!fitted.softened) return image;
  const Image there = scaled_into(image, fitted, fitted.width, fitted.height);
  return resampled(there, fitted.placement, image.width, image.height);
}

double mean_square(const Image& a, const Image& b, const Region& region) {
  double sum = 0;
  for (std::uint32_t y = region.top; y < region.bottom; ++y) {
    const float *p = a.row(y), *q = b.row(y);
    std::array<float, 4> row{};
    std::size_t i = std::size_t{3} * region.left;
    const std::size_t end = std::size_t{3} * region.right;
    for (; i + 4 <= end; i += 4)
      for (std::size_t k = 0; k < 4; ++k) {
        const float d = p[i + k] - q[i + k];
        row[k] += d * d;
      }
    for (; i < end; ++i) row[0] += (p[i] - q[i]) * (p[i] - q[i]);
    sum += static_cast<double>((row[0] + row[1]) + (row[2] + row[3]));
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

bool is_flat(const Image& image, const Region& region) {
  const Image shape = as_silhouette(image);
  std::array<double, 3> mean{};
  double count = 0, away = 0;
  const auto each = [&](const auto& function) {
    for (std::uint32_t y = region.top; y < region.bottom; ++y)
      for (std::uint32_t x = region.left; x < region.right; ++x)
        if (value_at(shape, x, y, 0) > 0)
          for (std::size_t c = 0; c < 3; ++c)
            function(c, static_cast<double>(value_at(image, x, y, c)));
  };
  each([&](std::size_t c, double value) { mean[c] += value, count += 1; });
  if (count == 0) return true;
  for (double& value : mean) value /= count / 3;
  each([&](std::size_t c, double value) { away += std::fabs(value - mean[c]); });
  return away / count < 0.03;
}

Closeness closeness_of(const Fitted& fitted, bool jpeg, const Rubric& rubric) {
  const auto own = static_cast<float>((rubric.tolerance + 0.5) / 255);
  if (fitted.exact && !jpeg) return {0, false, own, rubric.share, 1};
  // A second look tells what a JPEG's noise hides (comparison.hpp).
  const double share = std::max(rubric.share, jpeg ? 0.03 : 0.01);
  // Lines that were filled are lighter or darker at every outline.
  const double biased = fitted.alignment.unpainted ? 1 : 0.05;
  if (fitted.exact) return {1, true, own + 3.5F / 255, share, biased, jpeg};
  return {1, true, own + (jpeg ? 4.5F : 2.0F) / 255, share, biased, jpeg};
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
