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
  const auto begin = [](double start, double step, std::uint32_t room) {
    return static_cast<std::uint32_t>(
        std::clamp(std::ceil(-start / step - 0.01), 0.0, static_cast<double>(room)));
  };
  const auto end = [](double start, double step, std::uint32_t size, std::uint32_t room) {
    return static_cast<std::uint32_t>(
        std::clamp(std::floor((size - start) / step + 0.01), 0.0, static_cast<double>(room)));
  };
  Region region{begin(p.left, p.across, width), begin(p.top, p.down, height),
                end(p.left, p.across, fitted.width, width),
                end(p.top, p.down, fitted.height, height)};
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

Fitted fitted_at(const Position& position, Image painted, bool unpainted, std::uint32_t width,
                 std::uint32_t height) {
  Fitted fitted;
  const Turn& turn = position.turn;
  painted = turned_by(painted, turn);
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
  fitted.likeness = position.likeness;
  alignment.scaled = at.across != 1 || at.down != 1;
  alignment.across = at.across;
  alignment.down = at.down;
  alignment.left = at.left;
  alignment.top = at.top;
  alignment.cut = std::fabs(at.left) > 0.75 || std::fabs(at.top) > 0.75 ||
                  std::fabs(at.left + at.across * width - fitted.width) > 0.75 ||
                  std::fabs(at.top + at.down * height - fitted.height) > 0.75;
  fitted.image = at == GridPlacement{} && painted.width == width && painted.height == height
                     ? std::move(painted)
                     : resampled(painted, at, width, height);
  fitted.region = visible_region(fitted, width, height);
  return fitted;
}

std::vector<Fitted> fit(const Image& submitted, const Template& searched, std::uint32_t width,
                        std::uint32_t height) {
  Image painted = submitted;
  const bool unpainted = fill_unpainted(painted);
  std::vector<Fitted> all;
  for (const Position& position : searched.find(painted))
    all.push_back(fitted_at(position, painted, unpainted, width, height));
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

Image through_scaling(const Image& image, const Fitted& fitted) {
  if (fitted.exact || fitted.smallest > 0.97) return image;
  const Image there =
      resampled(image, inverse(fitted.placement), fitted.width, fitted.height);
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
  if (fitted.exact && !jpeg) return {0, 0, own, rubric.share, 1};
  const double share = std::max(rubric.share, 0.01);
  // Lines that were filled are lighter or darker at every outline.
  const double biased = fitted.alignment.unpainted ? 1 : 0.05;
  if (fitted.exact) return {1, 1, own + 3.5F / 255, share, biased};
  return {1, 1, own + (jpeg ? 4.5F : 2.0F) / 255, share, biased};
}

Image smoothed(const Image& image, unsigned times) {
  Image out = image;
  const std::size_t row = std::size_t{3} * image.width;
  for (unsigned i = 0; i < times; ++i) {
    Image across = out;
    for (std::uint32_t y = 0; y < image.height; ++y) {
      const float* from = out.row(y);
      float* to = across.row(y);
      for (std::size_t x = 3; x + 3 < row; ++x)
        to[x] = (from[x - 3] + from[x] + from[x + 3]) * (1.0F / 3);
    }
    for (std::uint32_t y = 1; y + 1 < image.height; ++y) {
      const float *above = across.row(y - 1), *here = across.row(y), *below = across.row(y + 1);
      float* to = out.row(y);
      for (std::size_t x = 0; x < row; ++x) to[x] = (above[x] + here[x] + below[x]) * (1.0F / 3);
    }
  }
  return out;
}

namespace {

/// The share of blocks whose means differ, by more than what an edge in them excuses; all where one
/// differs by much, as where a highlight is missing.
double biased_blocks(const Image& picture, const Image& soft, const Image& least,
                     const Image& most, const Region& region) {
  constexpr std::uint32_t kBlock = 8;
  constexpr double kBias = 3.0 / 255, kOfRange = 0.15, kMuch = 9.0 / 255, kMuchOfRange = 0.3;
  int all = 0, biased = 0;
  for (std::uint32_t y0 = region.top; y0 + kBlock <= region.bottom; y0 += kBlock)
    for (std::uint32_t x0 = region.left; x0 + kBlock <= region.right; x0 += kBlock) {
      std::array<double, 3> difference{}, range{};
      for (std::uint32_t y = y0; y < y0 + kBlock; ++y)
        for (std::uint32_t x = x0; x < x0 + kBlock; ++x)
          for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t i = std::size_t{3} * x + c;
            difference[c] += static_cast<double>(picture.row(y)[i] - soft.row(y)[i]);
            range[c] += static_cast<double>(most.row(y)[i] - least.row(y)[i]);
          }
      bool far = false;
      for (std::size_t c = 0; c < 3; ++c) {
        const double by = std::fabs(difference[c]);
        far = far || by > kBias * kBlock * kBlock + kOfRange * range[c];
        if (by > kMuch * kBlock * kBlock + kMuchOfRange * range[c]) return 1;
      }
      ++all;
      biased += far;
    }
  return all > 0 ? static_cast<double>(biased) / all : 0;
}

}  // namespace

Rest rest_of(const Image& picture, const Image& other, const Region& region,
             const Closeness& close) {
  const Image soft = smoothed(other, close.blur);
  const std::size_t row = std::size_t{3} * other.width;
  Image least = soft, most = soft;
  for (unsigned i = 0; i < close.reach; ++i) {
    const Image low = least, high = most;
    for (std::uint32_t y = 0; y < other.height; ++y) {
      const std::uint32_t above = y > 0 ? y - 1 : 0, below = std::min(y + 1, other.height - 1);
      for (const std::uint32_t v : {above, y, below}) {
        const float *l = low.row(v), *h = high.row(v);
        float *to_l = least.row(y), *to_h = most.row(y);
        for (std::size_t x = 0; x < row; ++x) {
          const std::size_t before = x >= 3 ? x - 3 : x, after = x + 3 < row ? x + 3 : x;
          to_l[x] = std::min({to_l[x], l[before], l[x], l[after]});
          to_h[x] = std::max({to_h[x], h[before], h[x], h[after]});
        }
      }
    }
  }
  Rest rest;
  double beyond = 0, energy = 0;
  for (std::uint32_t y = region.top; y < region.bottom; ++y) {
    const float *p = picture.row(y), *l = least.row(y), *h = most.row(y);
    float of_row = 0;
    for (std::uint32_t x = region.left; x < region.right; ++x) {
      bool far = false;
      for (std::size_t i = std::size_t{3} * x; i < std::size_t{3} * x + 3; ++i) {
        const float outside =
            std::max({0.0F, l[i] - close.tolerance - p[i], p[i] - h[i] - close.tolerance});
        far = far || outside > 0;
        of_row += outside * outside;
      }
      beyond += far;
    }
    energy += static_cast<double>(of_row);
  }
  if (close.blur > 0) rest.biased = biased_blocks(picture, soft, least, most, region);
  const double pixels = std::max(1.0, region.pixels());
  rest.share = beyond / pixels;
  rest.energy = energy / (3 * pixels);
  return rest;
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
