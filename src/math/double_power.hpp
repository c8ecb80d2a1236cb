// SPDX-License-Identifier: Apache-2.0
// Logarithms and powers of two in lanes of doubles, of plain products and sums only, so that every
// instruction set gets the same bits. Relative errors of a few units in the last place.
#pragma once

#include <array>

#include "math/double_lanes.hpp"

namespace zraka::ZRAKA_ISA {

/// c[0] + z·(c[1] + z·(c[2] + …)).
template <class F, std::size_t kTerms>
ZRAKA_INLINE F double_series(F z, const std::array<double, kTerms>& c) {
  F value(c[kTerms - 1]);
  for (std::size_t k = kTerms - 1; k-- > 0;) value = value * z + F(c[k]);
  return value;
}

/// log2 of a positive normal number. With s = (m-1)/(m+1), ln m = 2·(s + s³/3 + s⁵/5 + …) for m in
/// [√½, √2), where |s| ≤ 0.1716, so s²² is under 2⁻⁵⁵.
template <class F>
ZRAKA_INLINE F double_log2(F a) {
  constexpr std::array<double, 10> kTerms = {2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11,
                                             2.0 / 13, 2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21};
  F e, m;
  split_exponent(a, e, m);
  const F f = m - F(1.0);
  const F s = f / (F(2.0) + f);
  const F z = s * s;
  // ln m = f - s·(f - z·series): the large part, f, is exact.
  const F ln_m = f - s * (f - z * double_series(z, kTerms));
  return e + (ln_m * F(0.44269504088896340736) + ln_m);  // 1/ln 2 = 1 + 0.4426950…
}

/// 2^y; 0 for y below -1000, which is as far as it goes, and up to 1000. 2^n times the Taylor
/// series of e^f, |f| ≤ ½·ln 2, to the thirteenth power.
template <class F>
ZRAKA_INLINE F double_exp2(F y) {
  constexpr std::array<double, 12> kTerms = {
      1.0 / 2,     1.0 / 6,      1.0 / 24,      1.0 / 120,      1.0 / 720,       1.0 / 5040,
      1.0 / 40320, 1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
  const F bounded = min(max(y, F(-1000.0)), F(1000.0));
  const F n = round_to_integer(bounded);
  const F f = (bounded - n) * F(0.69314718055994530942);
  const F power = F(1.0) + (f + f * f * double_series(f, kTerms));
  return select(y < F(-1000.0), F(0.0), scale_by_power(power, n));
}

}  // namespace zraka::ZRAKA_ISA
