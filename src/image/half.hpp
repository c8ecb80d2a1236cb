// SPDX-License-Identifier: Apache-2.0
// Floats in 16 bits (IEEE 754 binary16), by our own rounding, so that libraries need not agree.
#pragma once

#include <bit>
#include <cstdint>

namespace zraka {

/// The nearest half, ties to even. Finite values beyond the largest one, 65504, become that: a
/// bright pixel is no infinite one. NaN stays NaN.
inline std::uint16_t half_of(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const auto sign = static_cast<std::uint16_t>(bits >> 16 & 0x8000);
  const std::uint32_t size = bits & 0x7FFFFFFF;
  const auto with_sign = [&](std::uint32_t half) {
    return static_cast<std::uint16_t>(sign | half);
  };
  if (size > 0x7F800000) return with_sign(0x7E00);
  if (size == 0x7F800000) return with_sign(0x7C00);
  // To the nearest multiple of 2^drop, which may carry into the exponent.
  const auto rounded = [](std::uint32_t v, int drop) {
    const std::uint32_t odd = v >> drop & 1;
    return (v + (std::uint32_t{1} << (drop - 1)) - 1 + odd) >> drop;
  };
  if (size >= 0x38800000) {  // 2^-14: a normal half
    const std::uint32_t half = rounded(size - 0x38000000, 13);
    return with_sign(half < 0x7C00 ? half : 0x7BFF);
  }
  if (size < 0x33000000) return with_sign(0);         // less than half of 2^-24
  const int exponent = static_cast<int>(size >> 23);  // 102…112
  return with_sign(rounded((size & 0x7FFFFF) | 0x800000, 126 - exponent));
}

}  // namespace zraka
