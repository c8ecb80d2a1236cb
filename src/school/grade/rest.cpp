// SPDX-License-Identifier: Apache-2.0
// What a picture leaves of another one, beyond what an alteration excuses.
#include <algorithm>
#include <array>
#include <cmath>

#include "school/grade/align.hpp"

namespace zraka {

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

/// Blocks whose means differ, by more than what an edge in them excuses.
class Blocks {
 public:
  Blocks(const Region& region, bool grey)
      : region_(region), grey_(grey), sums_((region.right - region.left) / kBlock) {}
  void add(std::uint32_t y, const float* picture, const float* soft, const float* least,
           const float* most) {
    for (std::size_t b = 0; b < sums_.size(); ++b)
      for (std::size_t i = 0; i < std::size_t{3} * kBlock; ++i) {
        const std::size_t at = std::size_t{3} * (region_.left + b * kBlock) + i;
        sums_[b][i % 3] += picture[at] - soft[at];
        sums_[b][3 + i % 3] += most[at] - least[at];
      }
    if ((y - region_.top) % kBlock == kBlock - 1) finish();
  }
  /// All where one differs by much, as where a highlight is missing.
  double share() const {
    if (much_) return 1;
    return all_ > 0 ? static_cast<double>(biased_) / all_ : 0;
  }

 private:
  static constexpr std::uint32_t kBlock = 8;
  void finish() {
    constexpr float kBias = 1.5F / 255, kOfRange = 0.1F, kMuch = 2.0F / 255, kMuchOfRange = 0.185F;
    constexpr float kPixels = kBlock * kBlock;
    for (auto& sum : sums_) {
      bool far = false;
      if (grey_) {
        const float by = (sum[0] + sum[1] + sum[2]) / 3, range = (sum[3] + sum[4] + sum[5]) / 3;
        sum = {by, by, by, range, range, range};
      }
      for (std::size_t c = 0; c < 3; ++c) {
        const float by = std::fabs(sum[c]), range = sum[3 + c];
        far = far || by > kBias * kPixels + kOfRange * range;
        much_ = much_ || by > kMuch * kPixels + kMuchOfRange * range;
      }
      ++all_;
      biased_ += far;
      sum = {};
    }
  }

  Region region_;
  bool grey_;
  std::vector<std::array<float, 6>> sums_;  ///< differences, then ranges
  int all_ = 0, biased_ = 0;
  bool much_ = false;
};

/// Counts blocks of 3×3 pixels that all differ.
class Solid {
 public:
  explicit Solid(const Region& region) : left_(region.left), rows_(region.right - region.left) {}
  /// Row by row, from left to right.
  void add(std::uint32_t x, bool differs) {
    run_ = x == left_ ? 0 : run_;
    run_ = differs ? run_ + 1 : 0;
    int& rows = rows_[x - left_];
    rows = run_ >= 3 ? rows + 1 : 0;
    count_ += rows >= 3;
  }
  int count() const { return count_; }

 private:
  std::uint32_t left_;
  int run_ = 0, count_ = 0;
  std::vector<int> rows_;
};

/// Least and most of a picture's values up to a pixel from each of a row.
class Surroundings {
 public:
  explicit Surroundings(const Image& image)
      : image_(image), low_(std::size_t{3} * image.width), high_(low_), least(low_), most(low_) {}
  void look_at(std::uint32_t y) {
    const float *above = image_.row(y > 0 ? y - 1 : 0), *here = image_.row(y),
                *below = image_.row(std::min(y + 1, image_.height - 1));
    const std::size_t row = low_.size();
    for (std::size_t x = 0; x < row; ++x) {
      low_[x] = std::min(std::min(above[x], here[x]), below[x]);
      high_[x] = std::max(std::max(above[x], here[x]), below[x]);
    }
    for (std::size_t x = 0; x < 3 && x < row; ++x) {
      const std::size_t next = std::min(x + 3, row - 3 + x), last = row - 3 + x;
      least[x] = std::min(low_[x], low_[next]), most[x] = std::max(high_[x], high_[next]);
      least[last] = std::min(low_[last], low_[last >= 3 ? last - 3 : last]);
      most[last] = std::max(high_[last], high_[last >= 3 ? last - 3 : last]);
    }
    for (std::size_t x = 3; x + 3 < row; ++x) {
      least[x] = std::min(std::min(low_[x - 3], low_[x]), low_[x + 3]);
      most[x] = std::max(std::max(high_[x - 3], high_[x]), high_[x + 3]);
    }
  }

 private:
  const Image& image_;
  std::vector<float> low_, high_;

 public:
  std::vector<float> least, most;
};

}  // namespace

namespace {

/// Windows have round corners, and what lies behind them shows there: how many pixels at both ends
/// of a row tell nothing.
std::uint32_t hidden_by_corners(const Image& image, std::uint32_t y) {
  constexpr double kRadius = 0.04;  // of the shorter side
  const double radius = kRadius * std::min(image.width, image.height);
  const double inwards = std::min(y, image.height - 1 - y) + 0.5;
  if (inwards >= radius) return 0;
  const double up = radius - inwards;
  return static_cast<std::uint32_t>(std::ceil(radius - std::sqrt(radius * radius - up * up)));
}

/// A picture's rows, with another's pixels where round corners hide its own.
class RowsInCorners {
 public:
  RowsInCorners(const Image& picture, const Image& other) : picture_(picture), other_(other) {}
  const float* at(std::uint32_t y) {
    const std::size_t hidden = std::size_t{3} * hidden_by_corners(picture_, y);
    const float* const own = picture_.row(y);
    if (hidden == 0) return own;
    const std::size_t width = std::size_t{3} * picture_.width;
    row_.assign(own, own + width);
    const float* const behind = other_.row(y);
    std::copy_n(behind, hidden, row_.data());
    std::copy_n(behind + width - hidden, hidden, row_.data() + width - hidden);
    return row_.data();
  }

 private:
  const Image &picture_, &other_;
  std::vector<float> row_;
};

/// What smoothing has brought nothing into from outside of a region.
Region untouched(const Region& r, const Image& image, std::uint32_t by) {
  const Region less{r.left > 0 ? r.left + by : 0, r.top > 0 ? r.top + by : 0,
                    r.right < image.width ? r.right - by : r.right,
                    r.bottom < image.height ? r.bottom - by : r.bottom};
  return r.right > r.left + 8 && r.bottom > r.top + 8 ? less : r;
}

}  // namespace

Rest rest_of(const Image& picture, const Image& other, const Region& whole,
             const Closeness& close) {
  const Region region = untouched(whole, other, close.blur);
  const Image smooth = close.blur > 0 ? smoothed(other, close.blur) : Image();
  const Image& soft = close.blur > 0 ? smooth : other;
  Surroundings around(soft);
  Blocks blocks(region, close.grey);
  double beyond = 0, energy = 0;
  Solid solid(region);
  RowsInCorners rows(picture, close.blur > 0 ? soft : picture);
  for (std::uint32_t y = region.top; y < region.bottom; ++y) {
    const float *p = rows.at(y), *l = soft.row(y), *h = l;
    if (close.reach) {
      around.look_at(y);
      l = around.least.data();
      h = around.most.data();
    }
    if (close.blur > 0) blocks.add(y, p, soft.row(y), l, h);
    float of_row = 0;
    for (std::uint32_t x = region.left; x < region.right; ++x) {
      float far = 0;
      for (std::size_t i = std::size_t{3} * x; i < std::size_t{3} * x + 3; ++i) {
        const float outside = std::max(0.0F, std::max(l[i] - p[i], p[i] - h[i]) - close.tolerance);
        far = std::max(far, outside);
        of_row += outside * outside;
      }
      beyond += far > 0;
      solid.add(x, far > 0);
    }
    energy += static_cast<double>(of_row);
  }
  const double pixels = std::max(1.0, region.pixels());
  return {beyond / pixels, energy / (3 * pixels), close.blur > 0 ? blocks.share() : 0,
          solid.count()};
}

}  // namespace zraka
