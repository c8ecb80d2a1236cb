// SPDX-License-Identifier: Apache-2.0
// LDR-FLIP, after its paper (Andersson et al. 2020, sections 4.1 color pipeline, 4.2 feature
// pipeline, 4.3 final difference); constants have the paper's names beside them.
// The pictures are worked on in strips of rows, so that little memory is needed beside them.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <zraka/compare.hpp>

#include "compare/filters.hpp"
#include "image/transfer.hpp"

namespace zraka {
namespace {

using Triple = std::array<double, 3>;
using Taps = std::vector<float>;

constexpr double kPi = 3.14159265358979323846;
constexpr std::uint32_t kStripRows = 64;

constexpr double kColorExponent = 0.7;          // q_c
constexpr double kBend = 0.4, kBendsTo = 0.95;  // p_c and p_t
constexpr double kFeatureWidth = 0.082;         // w, in degrees
constexpr double kFeatureExponent = 0.5;        // q_f

/// Linear RGB to XYZ, in the exact fractions that follow from sRGB's primaries and white point.
constexpr std::array<Triple, 3> kXyzFromRgb = {
    Triple{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
    Triple{2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
    Triple{1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};

constexpr Triple times(const std::array<Triple, 3>& m, const Triple& v) {
  Triple out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return out;
}

constexpr std::array<Triple, 3> inverse(const std::array<Triple, 3>& m) {
  std::array<Triple, 3> out{};
  const auto minor = [&](std::size_t r, std::size_t c) {
    const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
    return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
  };
  const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) out[c][r] = minor(r, c) / determinant;
  return out;
}

constexpr std::array<Triple, 3> kRgbFromXyz = inverse(kXyzFromRgb);
constexpr Triple kWhite = times(kXyzFromRgb, {1, 1, 1});

/// YCxCz, the linear relative of L*a*b* in which contrast is filtered.
Triple opponent_of(const Triple& rgb) {
  const Triple xyz = times(kXyzFromRgb, rgb);
  const double x = xyz[0] / kWhite[0], y = xyz[1], z = xyz[2] / kWhite[2];
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Triple rgb_of_opponent(const Triple& o) {
  const double y = (o[0] + 16) / 116;
  return times(kRgbFromXyz, {(y + o[1] / 500) * kWhite[0], y, (y - o[2] / 200) * kWhite[2]});
}

/// The cube root of a positive number to about 10⁻¹²: a third of the exponent, right to 5 %, and
/// two steps of Halley's iteration, each of which has three times the digits.
double cube_root(double x) {
  constexpr std::uint64_t kBias = std::uint64_t{715094163} << 32;
  auto y = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) / 3 + kBias);
  for (int step = 0; step < 2; ++step) {
    const double cube = y * y * y;
    y *= (cube + 2 * x) / (2 * cube + x);
  }
  return y;
}

/// L*a*b* with the Hunt effect: a* and b* count less in the dark.
Triple hunt_lab(const Triple& rgb) {
  const Triple xyz = times(kXyzFromRgb, rgb);
  const auto f = [](double t) {  // CIE 15: the cube root, straight near 0
    constexpr double kDelta = 6.0 / 29;
    return t > kDelta * kDelta * kDelta ? cube_root(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
  };
  const double x = f(xyz[0] / kWhite[0]), y = f(xyz[1]), z = f(xyz[2] / kWhite[2]);
  const double lightness = 116 * y - 16;
  return {lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)};
}

/// The HyAB distance, made for large differences (Abasi et al. 2020).
double hyab(const Triple& p, const Triple& q) {
  const double a = p[1] - q[1], b = p[2] - q[2];
  return std::fabs(p[0] - q[0]) + std::sqrt(a * a + b * b);
}

/// The largest distance within sRGB, from green to blue, and how a distance becomes 0…1: up to
/// p_c of the largest it takes the range to p_t, all above the rest.
class ColorScale {
 public:
  ColorScale()
      : most_(plain_power(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), kColorExponent)) {}
  double operator()(double distance) const {
    if (distance == 0) return 0;
    const double e = plain_power(distance, kColorExponent), bend = kBend * most_;
    return e < bend ? kBendsTo / bend * e : kBendsTo + (e - bend) / (most_ - bend) * (1 - kBendsTo);
  }

 private:
  double most_;
};

/// A two-dimensional filter that is a product of one along rows and one down columns.
struct Product {
  Taps across, down;
};

/// Contrast sensitivity: the sum of two Gaussians a·√(π/b)·exp(-π²r²/b), r in degrees, for each of
/// the three opponent channels, normalised to a sum of 1.
struct Contrast {
  double a1, b1, a2, b2;
};
constexpr std::array<Contrast, 3> kContrast = {
    Contrast{1, 0.0047, 0, 1e-5},        // achromatic
    Contrast{1, 0.0053, 0, 1e-5},        // red to green
    Contrast{34.1, 0.04, 13.5, 0.025}};  // blue to yellow

/// All filters for a resolution of the eye.
struct Filters {
  int contrast_radius, feature_radius, radius;
  std::array<std::vector<Product>, 3> contrast;  ///< to be added up, for each channel
  Taps smooth, slope, bend;                      ///< a Gaussian and its derivatives

  explicit Filters(double pixels_per_degree);
};

Filters::Filters(double pixels_per_degree) {
  // Three standard deviations of the widest Gaussian, whose σ² is b/(2π²).
  contrast_radius = static_cast<int>(
      std::ceil(3 * std::sqrt(kContrast[2].b1 / (2 * kPi * kPi)) * pixels_per_degree));
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const Contrast& c = kContrast[channel];
    std::array<std::vector<double>, 2> gaussians;
    std::array<double, 2> heights = {c.a1 * std::sqrt(kPi / c.b1), c.a2 * std::sqrt(kPi / c.b2)};
    double sum = 0;
    for (std::size_t g = 0; g < 2; ++g) {
      double line = 0;
      for (int x = -contrast_radius; x <= contrast_radius; ++x) {
        const double degrees = x / pixels_per_degree;
        gaussians[g].push_back(plain_exp(-kPi * kPi * degrees * degrees / (g == 0 ? c.b1 : c.b2)));
        line += gaussians[g].back();
      }
      sum += heights[g] * line * line;
    }
    for (std::size_t g = 0; g < 2; ++g) {
      if (heights[g] == 0) continue;
      Product product;
      for (const double w : gaussians[g]) {
        product.across.push_back(static_cast<float>(w));
        product.down.push_back(static_cast<float>(w * heights[g] / sum));
      }
      this->contrast[channel].push_back(std::move(product));
    }
  }

  // Edges and points: first and second derivative of a Gaussian, whose positive and negative
  // weights sum to 1 and -1.
  const double deviation = 0.5 * kFeatureWidth * pixels_per_degree;
  feature_radius = static_cast<int>(std::ceil(3 * deviation));
  smooth = gaussian<float>(feature_radius, deviation);
  const auto derivative = [&](auto weight_at) {
    std::vector<double> weights;
    double positive = 0, negative = 0;
    for (int x = -feature_radius; x <= feature_radius; ++x) {
      const double w = weight_at(x) * plain_exp(-0.5 * x * x / (deviation * deviation));
      (w > 0 ? positive : negative) += std::fabs(w);
      weights.push_back(w);
    }
    Taps taps;
    for (const double w : weights)
      taps.push_back(static_cast<float>(w / (w > 0 ? positive : negative)));
    return taps;
  };
  slope = derivative([](int x) { return static_cast<double>(-x); });
  bend = derivative([&](int x) { return x * x / (deviation * deviation) - 1; });
  radius = std::max(contrast_radius, feature_radius);
}

/// Rows of floats with the same length, one after the other.
struct Plane {
  std::size_t width = 0;
  std::vector<float> values;
  Plane(std::size_t w, std::size_t h) : width(w), values(w * h) {}
  float* row(std::size_t y) { return values.data() + width * y; }
  const float* row(std::size_t y) const { return values.data() + width * y; }
};

/// What the metric compares, for a strip of a picture: filtered colours in L*a*b* with the Hunt
/// effect, and how strongly edges and points stand out.
struct Strip {
  std::array<Plane, 3> lab;
  Plane edges, points;
  explicit Strip(std::size_t width)
      : lab{Plane(width, kStripRows), Plane(width, kStripRows), Plane(width, kStripRows)},
        edges(width, kStripRows),
        points(width, kStripRows) {}
};

/// Turns strips of a picture into what the metric compares. Beyond the edges the picture repeats
/// its last pixels, as the authors' program has it.
class StripMaker {
 public:
  StripMaker(const Filters& filters, std::size_t width)
      : filters_(filters),
        width_(width),
        reach_(static_cast<std::size_t>(filters.radius)),
        opponent_{Plane(width + 2 * reach_, kStripRows + 2 * reach_),
                  Plane(width + 2 * reach_, kStripRows + 2 * reach_),
                  Plane(width + 2 * reach_, kStripRows + 2 * reach_)},
        across_(width, kStripRows + 2 * reach_),
        part_(width, 1),
        rows_{Plane(width, kStripRows), Plane(width, kStripRows)} {
    for (std::size_t k = 0; k < linear_.size(); ++k)
      linear_[k] = decode_srgb(static_cast<double>(static_cast<float>(k) / 255.0f));
  }

  void make(const Image& image, std::uint32_t top, std::uint32_t rows, Strip& strip);

 private:
  double linear(float encoded) const;
  void load(const Image& image, std::uint32_t top, std::uint32_t rows);
  /// The channel through a product of filters, added to or put into `out`.
  void filter(const Plane& channel, const Taps& across, const Taps& down, std::uint32_t rows,
              bool add, Plane& out);
  void find_features(const Taps& along, std::uint32_t rows, Plane& strength);

  const Filters& filters_;
  std::size_t width_, reach_;
  std::array<Plane, 3> opponent_;  ///< with `reach_` pixels more on every side
  Plane across_, part_;
  std::array<Plane, 2> rows_;
  std::array<double, 256> linear_{};  ///< of k/255, which most values are
};

double StripMaker::linear(float encoded) const {
  if (!(encoded > 0)) return 0;
  if (encoded >= 1) return 1;
  const auto k = static_cast<std::size_t>(encoded * 255.0f + 0.5f);
  return static_cast<float>(k) / 255.0f == encoded ? linear_[k]
                                                   : decode_srgb(static_cast<double>(encoded));
}

void StripMaker::load(const Image& image, std::uint32_t top, std::uint32_t rows) {
  const auto reach = static_cast<std::int64_t>(reach_);
  for (std::int64_t y = 0; y < rows + 2 * reach; ++y) {
    const auto from = static_cast<std::uint32_t>(
        std::clamp<std::int64_t>(top + y - reach, 0, std::int64_t{image.height} - 1));
    const float* in = image.row(from);
    std::array<float*, 3> out{};
    for (std::size_t c = 0; c < 3; ++c) out[c] = opponent_[c].row(static_cast<std::size_t>(y));
    for (std::size_t x = 0; x < width_; ++x) {
      const Triple o =
          opponent_of({linear(in[3 * x]), linear(in[3 * x + 1]), linear(in[3 * x + 2])});
      for (std::size_t c = 0; c < 3; ++c) out[c][reach_ + x] = static_cast<float>(o[c]);
    }
    for (float* row : out) {
      std::fill_n(row, reach_, row[reach_]);
      std::fill_n(row + reach_ + width_, reach_, row[reach_ + width_ - 1]);
    }
  }
}

void StripMaker::filter(const Plane& channel, const Taps& across, const Taps& down,
                        std::uint32_t rows, bool add, Plane& out) {
  const std::size_t skip_x = reach_ - across.size() / 2, skip_y = reach_ - down.size() / 2;
  for (std::size_t y = 0; y < rows + down.size() - 1; ++y)
    filter_row(across, channel.row(skip_y + y) + skip_x, width_, across_.row(y));
  for (std::size_t y = 0; y < rows; ++y) {
    float* const row = add ? part_.row(0) : out.row(y);
    filter_rows(
        down, [&](std::size_t k) { return across_.row(y + k); }, width_, row);
    if (add)
      for (std::size_t x = 0; x < width_; ++x) out.row(y)[x] += row[x];
  }
}

/// The length of the gradient (or of the second derivatives) of the luminance.
void StripMaker::find_features(const Taps& along, std::uint32_t rows, Plane& strength) {
  filter(opponent_[0], along, filters_.smooth, rows, false, rows_[0]);
  filter(opponent_[0], filters_.smooth, along, rows, false, rows_[1]);
  for (std::size_t y = 0; y < rows; ++y)
    for (std::size_t x = 0; x < width_; ++x) {
      // Y of YCxCz as (Y + 16)/116; the 16 falls out, for these filters' weights sum to 0.
      const float gx = rows_[0].row(y)[x] / 116.0f, gy = rows_[1].row(y)[x] / 116.0f;
      strength.row(y)[x] = std::sqrt(gx * gx + gy * gy);
    }
}

void StripMaker::make(const Image& image, std::uint32_t top, std::uint32_t rows, Strip& strip) {
  load(image, top, rows);
  for (std::size_t c = 0; c < 3; ++c) {
    bool add = false;
    for (const Product& product : filters_.contrast[c]) {
      filter(opponent_[c], product.across, product.down, rows, add, strip.lab[c]);
      add = true;
    }
  }
  for (std::size_t y = 0; y < rows; ++y)
    for (std::size_t x = 0; x < width_; ++x) {
      Triple rgb =
          rgb_of_opponent({strip.lab[0].row(y)[x], strip.lab[1].row(y)[x], strip.lab[2].row(y)[x]});
      for (double& v : rgb) v = std::clamp(v, 0.0, 1.0);
      const Triple lab = hunt_lab(rgb);
      for (std::size_t c = 0; c < 3; ++c) strip.lab[c].row(y)[x] = static_cast<float>(lab[c]);
    }
  find_features(filters_.slope, rows, strip.edges);
  find_features(filters_.bend, rows, strip.points);
}

}  // namespace

FlipErrors flip_error(const Image& a, const Image& b, double pixels_per_degree) {
  const Filters filters(pixels_per_degree);
  const ColorScale color_scale;
  StripMaker maker(filters, a.width);
  Strip strip_a(a.width), strip_b(a.width);
  FlipErrors flip;
  flip.map.resize(std::size_t{a.width} * a.height);
  double sum = 0;
  for (std::uint32_t top = 0; top < a.height; top += kStripRows) {
    const std::uint32_t rows = std::min(kStripRows, a.height - top);
    maker.make(a, top, rows, strip_a);
    maker.make(b, top, rows, strip_b);
    for (std::size_t y = 0; y < rows; ++y)
      for (std::size_t x = 0; x < a.width; ++x) {
        const auto lab = [&](const Strip& s) {
          return Triple{s.lab[0].row(y)[x], s.lab[1].row(y)[x], s.lab[2].row(y)[x]};
        };
        const double color = color_scale(hyab(lab(strip_a), lab(strip_b)));
        const double edge = std::fabs(strip_a.edges.row(y)[x] - strip_b.edges.row(y)[x]);
        const double point = std::fabs(strip_a.points.row(y)[x] - strip_b.points.row(y)[x]);
        // With q_f = ½ the power is a square root. Where colours agree, nothing is seen.
        static_assert(kFeatureExponent == 0.5);
        const double feature = std::min(1.0, std::sqrt(std::max(edge, point) / std::sqrt(2.0)));
        const double e = color > 0 ? std::min(1.0, plain_power(color, 1 - feature)) : 0.0;
        const auto stored = static_cast<float>(e);
        flip.map[(top + y) * a.width + x] = stored;
        flip.largest = std::max(flip.largest, stored);
        sum += e;
      }
  }
  flip.mean = flip.map.empty() ? 0 : sum / static_cast<double>(flip.map.size());
  return flip;
}

}  // namespace zraka
