// SPDX-License-Identifier: Apache-2.0
// elementary::pow() of numbers from 0 to 1, to the same bits, in lanes of doubles.
#pragma once

#include "math/double_power.hpp"

namespace zraka::ZRAKA_ISA {

/// elementary::Pair, and what elementary functions do with pairs.
template <class F>
struct PairLanes {
  F high, low;
};

template <class F>
ZRAKA_INLINE PairLanes<F> pair_sum(F a, F b) {
  const F high = a + b;
  const F of_b = high - a;
  return {high, (a - (high - of_b)) + (b - of_b)};
}
template <class F>
ZRAKA_INLINE PairLanes<F> pair_sum(const PairLanes<F>& a, const PairLanes<F>& b) {
  const PairLanes<F> s = pair_sum(a.high, b.high);
  return pair_sum(s.high, s.low + (a.low + b.low));
}
template <class F>
ZRAKA_INLINE F upper_half(F v) {
  const F c = v * F(134217729.0);  // 2^27 + 1
  return c - (c - v);
}
template <class F>
ZRAKA_INLINE PairLanes<F> pair_product(F a, F b) {
  const F a1 = upper_half(a), a2 = a - a1, b1 = upper_half(b), b2 = b - b1;
  const F high = a * b;
  return {high, ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2};
}
template <class F>
ZRAKA_INLINE PairLanes<F> pair_product(const PairLanes<F>& a, const PairLanes<F>& b) {
  const PairLanes<F> p = pair_product(a.high, b.high);
  return pair_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

/// ln 2 as elementary::log() has it.
inline constexpr double kLn2High = 0x1.62e42fefa2000p-1, kLn2Low = 0x1.9ef35793c7673p-41;

/// ln of a positive normal number.
template <class F>
ZRAKA_INLINE PairLanes<F> pair_log(F x) {
  constexpr std::array<double, 11> kRest = {2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11,
                                            2.0 / 13, 2.0 / 15, 2.0 / 17, 2.0 / 19,
                                            2.0 / 21, 2.0 / 23, 2.0 / 25};
  F e, m;
  split_exponent(x, e, m);
  const auto at_root = m == F(0x1.6a09e667f3bcdp-1);  // there it is √2 that elementary::log() takes
  m = select(at_root, m + m, m);
  e = select(at_root, e - F(1), e);
  const F f = m - F(1);
  const PairLanes<F> divisor = pair_sum(F(2), f);
  const F quotient = f / divisor.high;
  const PairLanes<F> back = pair_product(quotient, divisor.high);
  const PairLanes<F> s = {
      quotient, (((f - back.high) - back.low) - quotient * divisor.low) / divisor.high};
  const PairLanes<F> z = pair_product(s, s);
  const PairLanes<F> cube = pair_product(s, z);
  PairLanes<F> value =
      pair_product(cube, PairLanes<F>{F(0x1.5555555555555p-1), F(0x1.5555555555555p-55)});
  value = pair_sum(value, PairLanes<F>{cube.high * z.high * double_series(z.high, kRest), F(0)});
  value = pair_sum(PairLanes<F>{F(2) * s.high, F(2) * s.low}, value);
  return pair_sum(pair_sum(e * F(kLn2High), e * F(kLn2Low)), value);
}

/// e^x, as far as it is a normal number.
template <class F>
ZRAKA_INLINE F pair_exp(const PairLanes<F>& x) {
  constexpr std::array<double, 11> kTerms = {
      1.0 / 6,      1.0 / 24,      1.0 / 120,      1.0 / 720,       1.0 / 5040,      1.0 / 40320,
      1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
  const F y = x.high * F(1.4426950408889634) + F(0.5);
  const F near = round_to_integer(y);
  const F n = select(near > y, near - F(1), near);
  const PairLanes<F> r = pair_sum(x.high - n * F(kLn2High), x.low - n * F(kLn2Low));
  const PairLanes<F> square = pair_product(r.high, F(0.5) * r.high);
  const PairLanes<F> linear = pair_sum(F(1), r.high);
  const PairLanes<F> begin = pair_sum(linear.high, square.high);
  const F rest = r.high * r.high * r.high * double_series(r.high, kTerms);
  const F low = (r.low + r.high * r.low) + (begin.low + (linear.low + square.low));
  return scale_by_power(begin.high + (low + rest), n);
}

/// x^y to the bits of elementary::pow() where 0 < x ≤ 1 and y > 0, of numbers that are neither tiny
/// nor huge; elsewhere `other`.
template <class F>
ZRAKA_INLINE F elementary_power(F x, F y, F other) {
  const auto usual = both(both(x >= F(0x1p-1000), x <= F(1)), both(y > F(0), y <= F(0x1p100)));
  const F base = select(usual, x, F(1)), exponent = select(usual, y, F(1));
  const PairLanes<F> ln_x = pair_log(base);
  const F about = exponent * ln_x.high;
  const auto normal = about > F(-700);
  const PairLanes<F> exact = pair_product(exponent, ln_x.high);
  const PairLanes<F> ln = pair_sum(exact.high, exact.low + exponent * ln_x.low);
  const F power = pair_exp(
      PairLanes<F>{select(normal, ln.high, F(0)), select(normal, ln.low, F(0))});
  const F value = select(either(base == F(1), about > F(-0x1p-60)), F(1), power);
  return select(both(usual, normal), value, other);
}

}  // namespace zraka::ZRAKA_ISA
