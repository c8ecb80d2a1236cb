// SPDX-License-Identifier: Apache-2.0
// The lane types that the engine is templated over: ScalarLanes (one lane of a plain number) and
// WideLanes (as many floats as the instruction set's registers hold, through Highway).
//
// Both have the same members (Real, F, I, M, kWidth, loads, stores, gathers, compression) and the
// same free functions. Every operation is IEEE 754's own, rounded once, so each lane's value is the
// same in all of them.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "math/vec.hpp"

#ifndef ZRAKA_ISA
#error "lanes.hpp belongs to code that is compiled per instruction set (see src/engine/kernel.cpp)"
#endif

namespace zraka::ZRAKA_ISA {

template <class R>
struct ScalarLanes {
  using Real = R;
  using F = R;             // a number
  using I = std::int32_t;  // an index
  using M = bool;          // a condition
  static constexpr std::size_t kWidth = 1;

  static ZRAKA_INLINE F load(const R* p) { return *p; }
  static ZRAKA_INLINE F load_box(const float* p) { return static_cast<R>(*p); }
  static ZRAKA_INLINE I load(const std::int32_t* p) { return *p; }
  static ZRAKA_INLINE void store(F v, R* p) { *p = v; }
  static ZRAKA_INLINE void store(I v, std::int32_t* p) { *p = v; }
  static ZRAKA_INLINE F gather(const R* base, I index) { return base[index]; }
  static ZRAKA_INLINE I gather(const std::int32_t* base, I index) { return base[index]; }
  /// out[k] is base[at + k].
  static ZRAKA_INLINE void gather_four(const R* base, I at, F (&out)[4]) {
    for (int k = 0; k < 4; ++k) out[k] = base[at + k];
  }
  /// From a table of as many values as rays go through the scene together.
  static ZRAKA_INLINE F look_up(const R* table, I index) { return table[index]; }
  static ZRAKA_INLINE void scatter(F v, M m, R* base, I index) {
    if (m) base[index] = v;
  }
  static ZRAKA_INLINE I compress(I v, M) { return v; }
  static ZRAKA_INLINE void compress_store(F v, M m, R* p) {
    if (m) *p = v;
  }
  static ZRAKA_INLINE void compress_store(I v, M m, std::int32_t* p) {
    if (m) *p = v;
  }
  static ZRAKA_INLINE M first(std::size_t n) { return n > 0; }
  static ZRAKA_INLINE M from_bits(std::uint32_t b) { return (b & 1) != 0; }
  static ZRAKA_INLINE I iota(std::int32_t start) { return start; }
  static ZRAKA_INLINE F to_real(I v) { return static_cast<R>(v); }
};

ZRAKA_INLINE double min_of(double v) {
  return v;
}
ZRAKA_INLINE double max_of(double v) {
  return v;
}
ZRAKA_INLINE void min_of_each(double a, double b, double c, double d, double (&out)[4]) {
  out[0] = a, out[1] = b, out[2] = c, out[3] = d;
}
/// Bit i is set where lane i is true.
ZRAKA_INLINE std::uint32_t bits(bool m) {
  return m ? 1 : 0;
}
ZRAKA_INLINE bool any(bool m) {
  return m;
}
ZRAKA_INLINE bool all(bool m) {
  return m;
}
ZRAKA_INLINE std::size_t count(bool m) {
  return m ? 1 : 0;
}
ZRAKA_INLINE bool both(bool a, bool b) {
  return a && b;
}
ZRAKA_INLINE bool either(bool a, bool b) {
  return a || b;
}
ZRAKA_INLINE bool but_not(bool a, bool b) {
  return a && !b;
}
ZRAKA_INLINE double select(bool m, double a, double b) {
  return m ? a : b;
}
ZRAKA_INLINE float select(bool m, float a, float b) {
  return m ? a : b;
}
ZRAKA_INLINE std::int32_t select(bool m, std::int32_t a, std::int32_t b) {
  return m ? a : b;
}
/// Sets bits that were not set, where m holds.
ZRAKA_INLINE std::int32_t set_bits(bool m, std::int32_t bits, std::int32_t to) {
  return m ? to | bits : to;
}
/// Keys that have the order of numbers that are not below 0, and of equal ones that of lanes, of
/// which `first` is the first one's number: below 16.
ZRAKA_INLINE std::int32_t keys_of(double v, std::size_t first) {
  const auto bits = __builtin_bit_cast(std::int32_t, static_cast<float>(v));
  return (bits & ~15) | static_cast<std::int32_t>(first);
}
ZRAKA_INLINE double sqrt(double a) {
  return __builtin_sqrt(a);
}
ZRAKA_INLINE double min(double a, double b) {
  return a < b ? a : b;
}
ZRAKA_INLINE double max(double a, double b) {
  return a > b ? a : b;
}
/// a·b - c, rounded once or twice: for the tests of boxes only, which may differ between
/// instruction sets.
ZRAKA_INLINE double roughly_mul_sub(double a, double b, double c) {
  return a * b - c;
}
ZRAKA_INLINE double roughly_mul_add(double a, double b, double c) {
  return a * b + c;
}
ZRAKA_INLINE double copy_sign(double magnitude, double sign) {
  return __builtin_copysign(magnitude, sign);
}
ZRAKA_INLINE double abs(double a) {
  return __builtin_fabs(a);
}
ZRAKA_INLINE std::int32_t first_lane(std::int32_t v) {
  return v;
}
/// Exponent and mantissa of a positive normal number: a = m·2^e with m in [√½, √2).
ZRAKA_INLINE void split_exponent(double a, double& e, double& m) {
  const auto bits = __builtin_bit_cast(std::int64_t, a);
  const std::int64_t shifted = bits - 0x3fe6a09e667f3bcdLL;  // √½
  const std::int64_t exponent = shifted >> 52;
  e = static_cast<double>(exponent);
  m = __builtin_bit_cast(double, bits - exponent * (std::int64_t{1} << 52));
}
/// a·2^n for an integral n with both a and the result normal numbers.
ZRAKA_INLINE double scale_by_power(double a, double n) {
  const auto exponent = static_cast<std::int64_t>(n);
  return __builtin_bit_cast(
      double, __builtin_bit_cast(std::int64_t, a) + exponent * (std::int64_t{1} << 52));
}
ZRAKA_INLINE double round_to_integer(double a) {
  return __builtin_nearbyint(a);
}

}  // namespace zraka::ZRAKA_ISA

#ifdef ZRAKA_WIDE
#include "math/wide_lanes.hpp"
#endif
