// SPDX-License-Identifier: Apache-2.0
// Differences channel by channel, and where they are.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <zraka/compare.hpp>

#include "compare/difference.hpp"

namespace zraka {
namespace {

/// Sums in a fixed number of lanes, whatever the registers' width, so that the order of adding and
/// hence the bits are the same everywhere.
struct Sums {
  static constexpr std::size_t kLanes = 8;
  double first[kLanes] = {}, square[kLanes] = {};
  float largest[kLanes] = {};

  /// Adds a row; distance(a, b) is difference() or, where all values are finite,
  /// plain_difference().
  template <class Distance>
  void add(const float* a, const float* b, std::size_t count, Distance distance) {
    Sums sums = *this;  // which nothing that is read can be part of, so that registers hold it
    std::size_t i = 0;
    for (; i + kLanes <= count; i += kLanes)
      for (std::size_t lane = 0; lane < kLanes; ++lane)
        sums.add_one(lane, distance(a[i + lane], b[i + lane]));
    for (std::size_t lane = 0; i < count; ++i, ++lane) sums.add_one(lane, distance(a[i], b[i]));
    *this = sums;
  }
  void add_one(std::size_t lane, float d) {
    const auto wide = static_cast<double>(d);
    first[lane] += wide;
    square[lane] += wide * wide;
    largest[lane] = largest[lane] < d ? d : largest[lane];
  }
};

double sum_of(const double (&lanes)[Sums::kLanes]) {
  double sum = 0;
  for (const double lane : lanes) sum += lane;
  return sum;
}

float plain_difference(float a, float b) {
  return std::fabs(a - b);
}

/// Pixels of a row that are over the threshold.
template <class Distance>
std::uint32_t count_over(const float* a, const float* b, std::uint32_t width, float most,
                         Distance distance) {
  std::uint32_t over = 0;
  for (std::size_t i = 0; i < std::size_t{3} * width; i += 3) {
    const float r = distance(a[i], b[i]), g = distance(a[i + 1], b[i + 1]),
                b_ = distance(a[i + 2], b[i + 2]);
    over += (r > most) | (g > most) | (b_ > most);
  }
  return over;
}

/// A float that is over the threshold just where the difference is: thresholds are doubles.
float as_float_threshold(double threshold) {
  const auto f = static_cast<float>(threshold);
  return static_cast<double>(f) <= threshold
             ? f
             : std::nextafter(f, -std::numeric_limits<float>::infinity());
}

PixelPair pair_at(const Image& a, const Image& b, std::uint32_t x, std::uint32_t y) {
  PixelPair pair{x, y};
  const float* in_a = a.row(y) + std::size_t{3} * x;
  const float* in_b = b.row(y) + std::size_t{3} * x;
  std::copy_n(in_a, 3, pair.a.begin());
  std::copy_n(in_b, 3, pair.b.begin());
  pair.difference = pixel_difference(in_a, in_b);
  return pair;
}

}  // namespace

double Errors::root_mean_square() const {
  return std::sqrt(mean_square);
}

double Errors::peak_signal_to_noise() const {
  return mean_square > 0 ? 10 * std::log10(1 / mean_square)
                         : std::numeric_limits<double>::infinity();
}

double Errors::share() const {
  return pixels > 0 ? static_cast<double>(over) / static_cast<double>(pixels) : 0;
}

Errors measure_errors(const Image& a, const Image& b, double threshold) {
  Errors errors;
  errors.pixels = std::uint64_t{a.width} * a.height;
  const float most = as_float_threshold(threshold);
  const std::size_t values = std::size_t{3} * a.width;
  Sums sums;
  bool any = false;
  for (std::uint32_t y = 0; y < a.height; ++y) {
    const float* in_a = a.row(y);
    const float* in_b = b.row(y);
    // Infinities and NaNs show in the sums, and are rare enough to do such a row again.
    Sums with_row = sums;
    with_row.add(in_a, in_b, values, plain_difference);
    const bool finite = std::isfinite(sum_of(with_row.square));
    if (finite)
      sums = with_row;
    else
      sums.add(in_a, in_b, values, difference);
    const std::uint32_t over = finite ? count_over(in_a, in_b, a.width, most, plain_difference)
                                      : count_over(in_a, in_b, a.width, most, difference);
    if (over == 0) continue;
    errors.over += over;
    std::uint32_t left = 0, right = a.width - 1;
    const auto is_over = [&](std::uint32_t x) {
      const std::size_t i = std::size_t{3} * x;
      return pixel_difference(in_a + i, in_b + i) > most;
    };
    while (!is_over(left)) ++left;
    while (!is_over(right)) --right;
    errors.box = any ? PixelBox{std::min(errors.box.left, left), errors.box.top,
                                std::max(errors.box.right, right), y}
                     : PixelBox{left, y, right, y};
    any = true;
  }
  const double all = std::max(1.0, 3.0 * static_cast<double>(errors.pixels));
  errors.mean = sum_of(sums.first) / all;
  errors.mean_square = sum_of(sums.square) / all;
  errors.largest = *std::max_element(std::begin(sums.largest), std::end(sums.largest));
  return errors;
}

std::vector<PixelPair> first_pixels(const Image& a, const Image& b, double threshold,
                                    std::size_t count) {
  const float most = as_float_threshold(threshold);
  std::vector<PixelPair> found;
  for (std::uint32_t y = 0; y < a.height && found.size() < count; ++y)
    for (std::uint32_t x = 0; x < a.width && found.size() < count; ++x) {
      const std::size_t i = std::size_t{3} * x;
      if (pixel_difference(a.row(y) + i, b.row(y) + i) > most) found.push_back(pair_at(a, b, x, y));
    }
  return found;
}

std::vector<PixelPair> worst_pixels(const Image& a, const Image& b, double threshold,
                                    std::size_t count) {
  float most = as_float_threshold(threshold);
  std::vector<PixelPair> worst;  // the worst first; a pixel comes in only where it is worse
  const auto worse = [](const PixelPair& p, const PixelPair& q) {
    return p.difference > q.difference;
  };
  for (std::uint32_t y = 0; y < a.height && count > 0; ++y)
    for (std::uint32_t x = 0; x < a.width; ++x) {
      const std::size_t i = std::size_t{3} * x;
      if (!(pixel_difference(a.row(y) + i, b.row(y) + i) > most)) continue;
      const PixelPair pair = pair_at(a, b, x, y);
      worst.insert(std::upper_bound(worst.begin(), worst.end(), pair, worse), pair);
      if (worst.size() > count) worst.pop_back();
      if (worst.size() == count) most = static_cast<float>(worst.back().difference);
    }
  return worst;
}

}  // namespace zraka
