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
  return moved;
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

Image through_scaling(const Image& image, const Fitted& fitted) {
  if (!fitted.softened) return image;
  const Image there = resampled(image, inverse(fitted.placement), fitted.width, fitted.height);
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

Rest rest_of(const Image& picture, const Image& other, const Region& region,
             const Closeness& close) {
  const Image smooth = close.blur > 0 ? smoothed(other, close.blur) : Image();
  const Image& soft = close.blur > 0 ? smooth : other;
  Surroundings around(soft);
  Blocks blocks(region, close.grey);
  double beyond = 0, energy = 0;
  Solid solid(region);
  for (std::uint32_t y = region.top; y < region.bottom; ++y) {
    const float *p = picture.row(y), *l = soft.row(y), *h = l;
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
