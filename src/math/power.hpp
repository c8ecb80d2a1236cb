// SPDX-License-Identifier: Apache-2.0
// Powers for highlights and the sRGB curve, of plain products and sums only, so that every
// instruction set gets the same bits.
#pragma once

#include "math/lanes.hpp"

namespace zraka::ZRAKA_ISA {

/// log2 of a positive normal number. With s = (m-1)/(m+1), log2 m = 2/ln 2 · (s + s³/3 + s⁵/5 + …)
/// for m in [√½, √2), where |s| ≤ 0.1716, so s¹³ is under 2⁻³⁶ of s. Relative error about 2⁻²³,
/// also near 1.
template <class F>
ZRAKA_INLINE F log2(F a) {
  F e, m;
  split_exponent(a, e, m);
  const F f = m - F(1.0f);
  const F s = f / (F(2.0f) + f);
  const F z = s * s;
  F series = F(2.0f / 11.0f);
  series = series * z + F(2.0f / 9.0f);
  series = series * z + F(2.0f / 7.0f);
  series = series * z + F(2.0f / 5.0f);
  series = series * z + F(2.0f / 3.0f);
  // ln m = f - s·(f - z·series): the large part, f, is exact.
  const F ln_m = f - s * (f - z * series);
  return e + (ln_m * F(0.44269504088896340736f) + ln_m);  // 1/ln 2 = 1 + 0.4426950…
}

/// 2^y for -126 ≤ y ≤ 126: 2^n times the Taylor series of e^(f·ln 2), |f| ≤ ½, to the sixth power.
template <class F>
ZRAKA_INLINE F exp2(F y) {
  const F n = round_to_integer(y);
  const F f = (y - n) * F(0.693147180559945309f);
  F series = F(1.0f / 5040.0f);
  series = series * f + F(1.0f / 720.0f);
  series = series * f + F(1.0f / 120.0f);
  series = series * f + F(1.0f / 24.0f);
  series = series * f + F(1.0f / 6.0f);
  series = series * f + F(0.5f);
  series = series * f * f + f;
  return scale_by_power(F(1.0f) + series, n);
}

/// x^n for 0 ≤ x ≤ 1 and any n. Results under 2^-100 are 0, those above 2^100 are 2^100; x^0 is 1,
/// also for 0. Relative error about 2⁻²²·(1 + |n·log2 x|).
template <class F>
ZRAKA_INLINE F power(F x, F n) {
  const F tiny = F(0x1p-126f);
  const F exponent = n * log2(max(x, tiny));
  const F bounded = min(max(exponent, F(-101.0f)), F(100.0f));
  return select(exponent > F(-100.0f), exp2(bounded), F(0.0f));
}

}  // namespace zraka::ZRAKA_ISA
