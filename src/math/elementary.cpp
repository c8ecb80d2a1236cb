// SPDX-License-Identifier: Apache-2.0
// Logarithm, exponential and power from Taylor series.
#include "math/elementary.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "math/pair.hpp"

namespace zraka::elementary {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr Pair kTwoThirds{0x1.5555555555555p-1, 0x1.5555555555555p-55};
/// ln 2 with 13 zeros at the end of the high part: an exponent times it is exact.
constexpr Pair kLn2{0x1.62e42fefa2000p-1, 0x1.9ef35793c7673p-41};
constexpr double kPerLn2 = 1.4426950408889634;

/// 2^n for a normal number.
double power_of_two(int n) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52);
}

/// Exact but for results that are too large or subnormal, which are rounded once; |n| < 2000.
double scaled(double value, int n) {
  const int half = n / 2;
  return value * power_of_two(half) * power_of_two(n - half);
}

/// ln x for a finite x > 0. With s = f/(2 + f), ln(1 + f) = 2·(s + s³/3 + s⁵/5 + …), |s| ≤ 0.1716;
/// what weighs most is kept in pairs, so that the relative error is about 2^-65.
Pair logarithm(double x) {
  Parts p = parts(x);
  if (p.fraction > 1.4142135623730951) {
    p.fraction *= 0.5;
    p.exponent += 1;
  }
  const double f = p.fraction - 1;
  const Pair divisor = sum(2, f);
  const double quotient = f / divisor.high;
  const Pair back = product(quotient, divisor.high);
  const Pair s = {quotient, (((f - back.high) - back.low) - quotient * divisor.low) / divisor.high};
  const Pair z = product(s, s);
  const Pair cube = product(s, z);
  constexpr std::array<double, 11> kRest = {2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11,
                                            2.0 / 13, 2.0 / 15, 2.0 / 17, 2.0 / 19,
                                            2.0 / 21, 2.0 / 23, 2.0 / 25};
  Pair value = product(cube, kTwoThirds);
  value = sum(value, {cube.high * z.high * series(z.high, kRest), 0});
  value = sum({2 * s.high, 2 * s.low}, value);
  const double e = p.exponent;
  return sum(sum(e * kLn2.high, e * kLn2.low), value);
}

/// e^x for |x| < 1000: 1 + r + r²/2 are kept exactly, what follows of the series is small.
double exponential(const Pair& x) {
  const double n = std::floor(x.high * kPerLn2 + 0.5);
  const Pair r = sum(x.high - n * kLn2.high, x.low - n * kLn2.low);
  const Pair square = product(r.high, 0.5 * r.high);
  const Pair linear = sum(1, r.high);
  const Pair begin = sum(linear.high, square.high);
  constexpr std::array<double, 11> kTerms = {
      1.0 / 6,      1.0 / 24,      1.0 / 120,      1.0 / 720,       1.0 / 5040,      1.0 / 40320,
      1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
  const double rest = r.high * r.high * r.high * series(r.high, kTerms);
  const double low = (r.low + r.high * r.low) + (begin.low + (linear.low + square.low));
  return scaled(begin.high + (low + rest), static_cast<int>(n));
}

bool is_integer(double y) {
  return std::floor(y) == y;
}

/// Of an integer; those of 2^53 and more are even.
bool is_odd(double y) {
  return std::fabs(y) < 0x1p53 && std::floor(y / 2) * 2 != y;
}

/// x^y for x > 0 and finite, y other than 0.
double power_of_positive(double x, double y) {
  if (x == 1) return 1;
  const Pair ln_x = logarithm(x);
  const double about = y * ln_x.high;
  if (about > 800) return kInfinity;
  if (about < -800) return 0;
  if (std::fabs(about) < 0x1p-60) return 1;
  const Pair exact = product(y, ln_x.high);
  return exponential(sum(exact.high, exact.low + y * ln_x.low));
}

}  // namespace

double exp(double x) {
  if (x != x) return kNan;
  if (x > 800) return kInfinity;
  if (x < -800) return 0;
  return exponential({x, 0});
}

double log(double x) {
  if (x == 0) return -kInfinity;
  if (!(x > 0)) return kNan;
  return x == kInfinity ? kInfinity : logarithm(x).high;
}

double pow(double x, double y) {
  if (y == 0 || x == 1) return 1;
  if (x != x || y != y) return kNan;
  const double size = std::fabs(x);
  if (std::fabs(y) == kInfinity) {
    if (size == 1) return 1;
    return (size > 1) == (y > 0) ? kInfinity : 0.0;
  }
  const bool negative = std::signbit(x) && is_integer(y) && is_odd(y);
  double value = 0;
  if (size == 0 || size == kInfinity)
    value = (size == 0) == (y > 0) ? 0.0 : kInfinity;
  else if (x < 0 && !is_integer(y))
    return kNan;
  else
    value = power_of_positive(size, y);
  return negative ? -value : value;
}

}  // namespace zraka::elementary
