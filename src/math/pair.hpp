// SPDX-License-Identifier: Apache-2.0
// What elementary functions are made of: doubles with what their rounding lost, and series.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace zraka::elementary {

/// The number high + low, where low is at most half a unit in the last place of high.
struct Pair {
  double high = 0, low = 0;
};

/// a + b to the last bit (Knuth, "The Art of Computer Programming", volume 2, theorem 4.2.2B).
inline Pair sum(double a, double b) {
  const double high = a + b;
  const double of_b = high - a;
  return {high, (a - (high - of_b)) + (b - of_b)};
}

inline Pair sum(const Pair& a, const Pair& b) {
  const Pair s = sum(a.high, b.high);
  return sum(s.high, s.low + (a.low + b.low));
}

/// a·b to the last bit, by halves of the factors (Dekker, "A floating-point technique for extending
/// the available precision", 1971); for factors below 2^996.
inline Pair product(double a, double b) {
  const auto upper_half = [](double v) {
    const double c = v * 134217729.0;  // 2^27 + 1
    return c - (c - v);
  };
  const double a1 = upper_half(a), a2 = a - a1, b1 = upper_half(b), b2 = b - b1;
  const double high = a * b;
  return {high, ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2};
}

inline Pair product(const Pair& a, const Pair& b) {
  const Pair p = product(a.high, b.high);
  return sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

/// c[0] + z·c[1] + z²·c[2] + …
template <std::size_t n>
double series(double z, const std::array<double, n>& c) {
  double value = c[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) value = value * z + c[i];
  return value;
}

/// |x| = fraction·2^exponent of a finite x other than 0, with a fraction of 1 or more, less than 2.
struct Parts {
  double fraction = 1;
  int exponent = 0;
};
inline Parts parts(double x) {
  int exponent = 0;
  if (std::fabs(x) < 0x1p-1022) {
    x *= 0x1p54;
    exponent = -54;
  }
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x) & ~(std::uint64_t{1} << 63);
  constexpr std::uint64_t kFraction = (std::uint64_t{1} << 52) - 1;
  exponent += static_cast<int>(bits >> 52) - 1023;
  return {std::bit_cast<double>((bits & kFraction) | std::uint64_t{1023} << 52), exponent};
}

}  // namespace zraka::elementary
