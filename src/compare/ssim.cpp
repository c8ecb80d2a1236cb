// SPDX-License-Identifier: Apache-2.0
// Structural similarity.
#include <cmath>
#include <zraka/compare.hpp>

#include "compare/filters.hpp"

namespace zraka {
namespace {

constexpr std::size_t kWindow = 11;
constexpr double kDeviation = 1.5;
constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;  // (K·L)² with a range L of 1

double luma(const float* pixel) {
  return 0.299 * static_cast<double>(pixel[0]) + 0.587 * static_cast<double>(pixel[1]) +
         0.114 * static_cast<double>(pixel[2]);
}

/// Windowed means, of the sum s and the difference d of the two pictures and of their squares, in
/// one row of places where the window fits. From these follow all terms:
///   μx² + μy² = (μs² + μd²)/2, 2 μx μy = (μs² - μd²)/2, and likewise the variances,
/// and where the pictures are equal, d is 0 and the result is 1 to the bit.
struct Means {
  std::vector<double> s, d, ss, dd;
  explicit Means(std::size_t width) : s(width), d(width), ss(width), dd(width) {}
};

}  // namespace

std::optional<double> structural_similarity(const Image& a, const Image& b) {
  if (a.width < kWindow || a.height < kWindow) return std::nullopt;
  const std::vector<double> window = gaussian<double>(kWindow / 2, kDeviation);
  const std::size_t width = a.width - kWindow + 1, height = a.height - kWindow + 1;

  // A ring of rows that are filtered along the row; each is filtered down the columns eleven times.
  std::vector<Means> ring(kWindow, Means(width));
  std::vector<double> s(a.width), d(a.width), ss(a.width), dd(a.width);
  Means mean(width);
  double sum = 0;
  for (std::uint32_t y = 0; y < a.height; ++y) {
    for (std::size_t x = 0; x < a.width; ++x) {
      const double in_a = luma(a.row(y) + 3 * x), in_b = luma(b.row(y) + 3 * x);
      s[x] = in_a + in_b;
      d[x] = in_a - in_b;
      ss[x] = s[x] * s[x];
      dd[x] = d[x] * d[x];
    }
    Means& filtered = ring[y % kWindow];
    filter_row(window, s.data(), width, filtered.s.data());
    filter_row(window, d.data(), width, filtered.d.data());
    filter_row(window, ss.data(), width, filtered.ss.data());
    filter_row(window, dd.data(), width, filtered.dd.data());
    if (y + 1 < kWindow) continue;

    const std::size_t top = y + 1 - kWindow;
    const auto down = [&](std::vector<double> Means::*plane) {
      filter_rows(
          window, [&](std::size_t k) { return (ring[(top + k) % kWindow].*plane).data(); }, width,
          (mean.*plane).data());
    };
    down(&Means::s);
    down(&Means::d);
    down(&Means::ss);
    down(&Means::dd);
    double row_sum = 0;
    for (std::size_t x = 0; x < width; ++x) {
      const double s2 = mean.s[x] * mean.s[x], d2 = mean.d[x] * mean.d[x];
      const double s_variance = mean.ss[x] - s2, d_variance = mean.dd[x] - d2;
      row_sum += ((s2 - d2) / 2 + kC1) * ((s_variance - d_variance) / 2 + kC2) /
                 (((s2 + d2) / 2 + kC1) * ((s_variance + d_variance) / 2 + kC2));
    }
    sum += row_sum;
  }
  return sum / (static_cast<double>(width) * static_cast<double>(height));
}

}  // namespace zraka
