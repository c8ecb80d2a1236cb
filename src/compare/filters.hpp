// SPDX-License-Identifier: Apache-2.0
// Filters along rows and columns, as plain loops that compilers make wide. The taps are added in
// their order, so the bits do not depend on the width of registers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace zraka {

/// e^x for x of a modest size, of plain products and sums, so that it is the same on every system.
inline double plain_exp(double x) {
  int halvings = 0;
  for (; x < -0.5 || x > 0.5; x /= 2) ++halvings;
  double sum = 1, term = 1;
  for (int n = 1; n < 20; ++n) sum += term *= x / n;
  for (; halvings > 0; --halvings) sum *= sum;
  return sum;
}

/// Gaussian weights for positions -radius…radius that sum to 1.
template <class Real>
std::vector<Real> gaussian(int radius, double deviation) {
  std::vector<double> weights;
  double sum = 0;
  for (int x = -radius; x <= radius; ++x) {
    weights.push_back(plain_exp(-0.5 * x * x / (deviation * deviation)));
    sum += weights.back();
  }
  std::vector<Real> taps;
  for (const double w : weights) taps.push_back(static_cast<Real>(w / sum));
  return taps;
}

/// out[x] = Σ taps[k]·from(k)[x] for x < count. Blocks as small as this stay in registers while the
/// taps go by.
template <class Real, class From>
void filter_with(const std::vector<Real>& taps, From from, std::size_t count, Real* out) {
  constexpr std::size_t kBlock = 128 / sizeof(Real);
  std::size_t x = 0;
  for (; x + kBlock <= count; x += kBlock) {
    Real sums[kBlock] = {};
    for (std::size_t k = 0; k < taps.size(); ++k) {
      const Real weight = taps[k];
      const Real* in = from(k) + x;
      for (std::size_t i = 0; i < kBlock; ++i) sums[i] += weight * in[i];
    }
    std::copy_n(sums, kBlock, out + x);
  }
  for (; x < count; ++x) {
    Real sum = 0;
    for (std::size_t k = 0; k < taps.size(); ++k) sum += taps[k] * from(k)[x];
    out[x] = sum;
  }
}

/// out[x] = Σ taps[k]·in[x + k] for x < count; `in` holds count + taps.size() - 1 values.
template <class Real>
void filter_row(const std::vector<Real>& taps, const Real* in, std::size_t count, Real* out) {
  filter_with(
      taps, [in](std::size_t k) { return in + k; }, count, out);
}

/// out[x] = Σ taps[k]·row(k)[x] for x < count.
template <class Real, class Row>
void filter_rows(const std::vector<Real>& taps, Row row, std::size_t count, Real* out) {
  filter_with(taps, row, count, out);
}

}  // namespace zraka
