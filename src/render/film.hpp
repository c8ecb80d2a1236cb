// SPDX-License-Identifier: Apache-2.0
// What becomes of samples: what one brings, and what a pixel keeps of them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "sampling/pixel_filter.hpp"

namespace zraka {

/// What a sample brings. Another channel of the picture is another field here and its sum in
/// FilmPixel.
struct FilmSample {
  float color[3] = {0, 0, 0};
  bool negative = false;  ///< the filter is below 0 there
  bool hits = false;      ///< a shape
};

/// The colours of samples of one pixel, one after the other.
struct FilmRun {
  const float *r, *g, *b;
  std::size_t count;
};

/// What a pixel keeps of its samples, which come in the order of their numbers.
class FilmPixel {
 public:
  void add(const FilmSample& sample) { add(sample, 1); }

  /// So many equal samples, to a pixel that has no others: of one float's multiples, doubles round
  /// none up to 2^29.
  void add(const FilmSample& sample, std::uint32_t times) {
    double* const sums = sample.negative ? negative_ : positive_;
    for (int c = 0; c < 3; ++c) {
      sums[c] += static_cast<double>(sample.color[c]) * times;
      const float shown = std::clamp(sample.color[c], 0.0f, 1.0f);
      least_[c] = std::min(least_[c], shown);
      most_[c] = std::max(most_[c], shown);
    }
    (sample.negative ? negative_count_ : positive_count_) += times;
    if (sample.hits) (sample.negative ? negative_hits_ : positive_hits_) += times;
  }

  /// Samples that all count above 0, and of which it matters neither how far they differ nor what
  /// they hit. Side by side, for each sum waits for the one before it.
  void add(const FilmRun& run) {
    double r = positive_[0], g = positive_[1], b = positive_[2];
    for (std::size_t i = 0; i < run.count; ++i) {
      r += static_cast<double>(run.r[i]);
      g += static_cast<double>(run.g[i]);
      b += static_cast<double>(run.b[i]);
    }
    positive_[0] = r, positive_[1] = g, positive_[2] = b;
    positive_count_ += static_cast<std::uint32_t>(run.count);
  }

  /// How much of the pixel shapes cover, by the filter: 0…1.
  float coverage(const PixelFilterShape& filter) const {
    const auto share = [](std::uint32_t hits, std::uint32_t count) {
      return count > 0 ? static_cast<double>(hits) / count : 0.0;
    };
    const double positive = share(positive_hits_, positive_count_),
                 negative = share(negative_hits_, negative_count_);
    const double all = negative_count_ == 0   ? positive
                       : positive_count_ == 0 ? negative
                                              : filter.positive() * positive -
                                                    filter.negative() * negative;
    return static_cast<float>(std::clamp(all, 0.0, 1.0));
  }

  std::uint32_t count() const { return positive_count_ + negative_count_; }

  /// The filtered colour. Samples where the filter is positive and those where it is negative weigh
  /// as much as its integral there, each kind evenly: the weights' sum is the filter's integral
  /// however many of each there happen to be, where the signs alone could cancel.
  void mean(const PixelFilterShape& filter, float* color) const {
    for (int c = 0; c < 3; ++c) {
      const double positive = positive_count_ > 0 ? positive_[c] / positive_count_ : 0;
      const double negative = negative_count_ > 0 ? negative_[c] / negative_count_ : 0;
      const double mean = negative_count_ == 0 ? positive
                          : positive_count_ == 0
                              ? negative
                              : filter.positive() * positive - filter.negative() * negative;
      color[c] = static_cast<float>(mean);
    }
  }

  /// Whether its samples differ by more than that, as they are shown: between 0 and 1.
  bool varies(double contrast) const {
    for (int c = 0; c < 3; ++c)
      if (static_cast<double>(most_[c]) - static_cast<double>(least_[c]) > contrast) return true;
    return false;
  }

 private:
  double positive_[3] = {0, 0, 0}, negative_[3] = {0, 0, 0};
  float least_[3] = {1, 1, 1}, most_[3] = {0, 0, 0};
  std::uint32_t positive_count_ = 0, negative_count_ = 0, positive_hits_ = 0, negative_hits_ = 0;
};

/// Which pixels of a rectangle want more samples: rows of `width`, `means` three a pixel. Those
/// whose samples differ by more than the contrast, or whose mean does from that of one of their
/// four neighbours.
class ContrastTest {
 public:
  ContrastTest(const std::vector<FilmPixel>& film, const std::vector<float>& means,
               std::int32_t width, std::int32_t height, double contrast)
      : film_(film), means_(means), width_(width), height_(height), contrast_(contrast) {}

  bool wants_more(std::int32_t x, std::int32_t y) const {
    return film_[index(x, y)].varies(contrast_) || differ(x, y, x - 1, y) ||
           differ(x, y, x + 1, y) || differ(x, y, x, y - 1) || differ(x, y, x, y + 1);
  }

 private:
  std::size_t index(std::int32_t x, std::int32_t y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }
  bool differ(std::int32_t x, std::int32_t y, std::int32_t ox, std::int32_t oy) const {
    if (ox < 0 || oy < 0 || ox >= width_ || oy >= height_) return false;
    const float *a = means_.data() + 3 * index(x, y), *b = means_.data() + 3 * index(ox, oy);
    for (int c = 0; c < 3; ++c) {
      const double difference = static_cast<double>(std::clamp(a[c], 0.0f, 1.0f)) -
                                static_cast<double>(std::clamp(b[c], 0.0f, 1.0f));
      if (difference > contrast_ || -difference > contrast_) return true;
    }
    return false;
  }

  const std::vector<FilmPixel>& film_;
  const std::vector<float>& means_;
  std::int32_t width_, height_;
  double contrast_;
};

}  // namespace zraka
