// SPDX-License-Identifier: Apache-2.0
// Lanes of doubles beside an engine's lanes: for formulas that lose too much in float. As many of
// them fill the engine's lanes as its numbers are smaller.
#pragma once

#include "math/lanes.hpp"

namespace zraka::ZRAKA_ISA {

/// The oracle's lanes are doubles themselves.
struct ScalarDoubles {
  using F = double;
  using M = bool;
  using B = std::uint64_t;  // bits
  static constexpr std::size_t kWidth = 1;
  static ZRAKA_INLINE F load(const double* p) { return *p; }
  static ZRAKA_INLINE F load_reals(const double* p) { return *p; }
  static ZRAKA_INLINE F load_reals(const float* p) { return static_cast<double>(*p); }
  static ZRAKA_INLINE void store(F v, double* p) { *p = v; }
  static ZRAKA_INLINE void store_reals(F v, double* p) { *p = v; }
  static ZRAKA_INLINE F gather(const double* base, const std::int32_t* index) {
    return base[*index];
  }
  static ZRAKA_INLINE M from_bits(std::uint32_t b) { return (b & 1) != 0; }
  static ZRAKA_INLINE B bits_if(M m, std::uint64_t b) { return m ? b : 0; }
  static ZRAKA_INLINE B flip(B a, B b) { return a ^ b; }
  static ZRAKA_INLINE B unite(B a, B b) { return a | b; }
  static ZRAKA_INLINE M has_bit(std::uint64_t table, B index) { return (table >> index & 1) != 0; }
};

/// The engine's lanes as lanes of doubles, and back, rounded.
ZRAKA_INLINE void widen(double v, double (&out)[1]) {
  out[0] = v;
}
ZRAKA_INLINE double narrow(const double (&v)[1]) {
  return v[0];
}

/// Lane i's bit is 1 << i.
ZRAKA_INLINE std::uint32_t bits_of_doubles(bool m) {
  return m ? 1 : 0;
}

ZRAKA_INLINE double floor(double a) {
  return __builtin_floor(a);
}

ZRAKA_INLINE bool select(bool m, bool a, bool b) {
  return m ? a : b;
}

#ifdef ZRAKA_WIDE
namespace wide {
using Dd = hn::ScalableTag<double>;
inline constexpr Dd dd{};
}  // namespace wide

struct DoubleLanes {
  hn::Vec<wide::Dd> v;
  DoubleLanes() = default;                                             // any values
  ZRAKA_INLINE DoubleLanes(const DoubleLanes& other) : v(other.v) {}   // as FloatLanes
  ZRAKA_INLINE DoubleLanes& operator=(const DoubleLanes& other) {
    v = other.v;
    return *this;
  }
  ZRAKA_INLINE DoubleLanes(hn::Vec<wide::Dd> lanes) : v(lanes) {}      // NOLINT: implicit
  ZRAKA_INLINE DoubleLanes(double all) : v(hn::Set(wide::dd, all)) {}  // NOLINT: implicit
};
struct DoubleMask {
  hn::Mask<wide::Dd> v;
  DoubleMask() = default;                                          // any values
  ZRAKA_INLINE DoubleMask(hn::Mask<wide::Dd> lanes) : v(lanes) {}  // NOLINT: implicit
  ZRAKA_INLINE DoubleMask(const DoubleMask& other) : v(other.v) {}
  ZRAKA_INLINE DoubleMask& operator=(const DoubleMask& other) {
    v = other.v;
    return *this;
  }
};

ZRAKA_INLINE DoubleLanes operator+(DoubleLanes a, DoubleLanes b) {
  return hn::Add(a.v, b.v);
}
ZRAKA_INLINE DoubleLanes operator-(DoubleLanes a, DoubleLanes b) {
  return hn::Sub(a.v, b.v);
}
ZRAKA_INLINE DoubleLanes operator*(DoubleLanes a, DoubleLanes b) {
  return hn::Mul(a.v, b.v);
}
ZRAKA_INLINE DoubleLanes operator/(DoubleLanes a, DoubleLanes b) {
  return hn::Div(a.v, b.v);
}
ZRAKA_INLINE DoubleLanes operator-(DoubleLanes a) {
  return hn::Neg(a.v);
}
ZRAKA_INLINE DoubleMask operator<(DoubleLanes a, DoubleLanes b) {
  return {hn::Lt(a.v, b.v)};
}
ZRAKA_INLINE DoubleMask operator>(DoubleLanes a, DoubleLanes b) {
  return {hn::Lt(b.v, a.v)};
}
ZRAKA_INLINE DoubleMask operator<=(DoubleLanes a, DoubleLanes b) {
  return {hn::Le(a.v, b.v)};
}
ZRAKA_INLINE DoubleMask operator>=(DoubleLanes a, DoubleLanes b) {
  return {hn::Le(b.v, a.v)};
}
ZRAKA_INLINE DoubleMask operator==(DoubleLanes a, DoubleLanes b) {
  return {hn::Eq(a.v, b.v)};
}
ZRAKA_INLINE bool any(DoubleMask m) {
  return !hn::AllFalse(wide::dd, m.v);
}
ZRAKA_INLINE bool all(DoubleMask m) {
  return hn::AllTrue(wide::dd, m.v);
}
ZRAKA_INLINE std::uint32_t bits_of_doubles(DoubleMask m) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(wide::dd, m.v, bytes);
  return bytes[0];
}
ZRAKA_INLINE DoubleMask both(DoubleMask a, DoubleMask b) {
  return {hn::And(a.v, b.v)};
}
ZRAKA_INLINE DoubleMask either(DoubleMask a, DoubleMask b) {
  return {hn::Or(a.v, b.v)};
}
ZRAKA_INLINE DoubleMask but_not(DoubleMask a, DoubleMask b) {
  return {hn::AndNot(b.v, a.v)};
}
ZRAKA_INLINE DoubleLanes select(DoubleMask m, DoubleLanes a, DoubleLanes b) {
  return hn::IfThenElse(m.v, a.v, b.v);
}
ZRAKA_INLINE DoubleMask select(DoubleMask m, DoubleMask a, DoubleMask b) {
#if defined(__clang__) && defined(__AVX512F__)
  // Over masks of bits, clang 19 takes many minutes and gigabytes for a torus by AVX-512.
  return {hn::MaskFromVec(
      hn::IfThenElse(m.v, hn::VecFromMask(wide::dd, a.v), hn::VecFromMask(wide::dd, b.v)))};
#else
  return either(both(m, a), but_not(b, m));
#endif
}
ZRAKA_INLINE DoubleLanes sqrt(DoubleLanes a) {
  return hn::Sqrt(a.v);
}
#if HWY_ARCH_X86
// The registers' own: a < b ? a : b, also for NaN and for zeros of both signs.
ZRAKA_INLINE DoubleLanes min(DoubleLanes a, DoubleLanes b) {
  return hn::Min(a.v, b.v);
}
ZRAKA_INLINE DoubleLanes max(DoubleLanes a, DoubleLanes b) {
  return hn::Max(a.v, b.v);
}
#else
ZRAKA_INLINE DoubleLanes min(DoubleLanes a, DoubleLanes b) {
  return select(a < b, a, b);
}
ZRAKA_INLINE DoubleLanes max(DoubleLanes a, DoubleLanes b) {
  return select(a > b, a, b);
}
#endif
ZRAKA_INLINE DoubleLanes copy_sign(DoubleLanes magnitude, DoubleLanes sign) {
  return hn::CopySign(magnitude.v, sign.v);
}
ZRAKA_INLINE DoubleLanes abs(DoubleLanes a) {
  return hn::Abs(a.v);
}

/// Exponent and mantissa of a positive normal number: a = m·2^e with m in [√½, √2).
ZRAKA_INLINE void split_exponent(DoubleLanes a, DoubleLanes& e, DoubleLanes& m) {
  using wide::dd;
  const hn::RebindToUnsigned<wide::Dd> du;
  const auto bits = hn::BitCast(du, a.v), half_root = hn::Set(du, 0x3fe6a09e667f3bcdULL);  // √½
  // With 2048 added to it, it is not negative, and the lowest bits of 2^52 and it.
  const auto from_half = hn::Add(hn::Sub(bits, half_root), hn::Set(du, 0x8000000000000000ULL));
  const auto exponent = hn::ShiftRight<52>(from_half);
  const auto above = hn::BitCast(dd, hn::Or(exponent, hn::BitCast(du, hn::Set(dd, 0x1p52))));
  e = hn::Sub(above, hn::Set(dd, 0x1p52 + 2048));
  // These 2048 are where the sign is.
  m = hn::Abs(hn::BitCast(dd, hn::Sub(bits, hn::ShiftLeft<52>(exponent))));
}
/// a·2^n for an integral n with both a and the result normal numbers.
ZRAKA_INLINE DoubleLanes scale_by_power(DoubleLanes a, DoubleLanes n) {
  const hn::RebindToUnsigned<wide::Dd> du;
  // The lowest bits of 1.5·2^52 + n are n's.
  const auto low = hn::BitCast(du, hn::Add(n.v, hn::Set(wide::dd, 0x1.8p52)));
  return hn::BitCast(wide::dd, hn::Add(hn::BitCast(du, a.v), hn::ShiftLeft<52>(low)));
}
ZRAKA_INLINE DoubleLanes round_to_integer(DoubleLanes a) {
  return hn::Round(a.v);
}

/// std::floor(), but for the sign of zeros.
ZRAKA_INLINE DoubleLanes floor(DoubleLanes a) {
#if HWY_ARCH_X86 && HWY_TARGET > HWY_SSE4
  // The set has none, and Highway takes the lanes apart. From 2^52 on all numbers are whole.
  const DoubleLanes size = abs(a), large(0x1p52);
  const DoubleLanes nearest = copy_sign((size + large) - large, a);
  const DoubleLanes below = select(nearest > a, nearest - DoubleLanes(1), nearest);
  return select(size < large, below, a);
#else
  return hn::Floor(a.v);
#endif
}

#if HWY_TARGET == HWY_SCALAR  // one lane of each
ZRAKA_INLINE void widen(FloatLanes v, DoubleLanes (&out)[1]) {
  out[0] = hn::PromoteTo(wide::dd, v.v);
}
ZRAKA_INLINE FloatLanes narrow(const DoubleLanes (&v)[1]) {
  return hn::DemoteTo(wide::d, v[0].v);
}
#else
ZRAKA_INLINE void widen(FloatLanes v, DoubleLanes (&out)[2]) {
  const hn::Half<wide::D> half;
  out[0] = hn::PromoteTo(wide::dd, hn::LowerHalf(half, v.v));
  out[1] = hn::PromoteTo(wide::dd, hn::UpperHalf(half, v.v));
}
ZRAKA_INLINE FloatLanes narrow(const DoubleLanes (&v)[2]) {
  const hn::Half<wide::D> half;
  return hn::Combine(wide::d, hn::DemoteTo(half, v[1].v), hn::DemoteTo(half, v[0].v));
}
#endif

struct WideDoubles {
  using F = DoubleLanes;
  using M = DoubleMask;
  using B = hn::Vec<hn::RebindToUnsigned<wide::Dd>>;
  static constexpr std::size_t kWidth = HWY_LANES(double);
  static ZRAKA_INLINE F load(const double* p) { return hn::LoadU(wide::dd, p); }
  static ZRAKA_INLINE F load_reals(const float* p) {
    return hn::PromoteTo(wide::dd, hn::LoadU(hn::Rebind<float, wide::Dd>(), p));
  }
  static ZRAKA_INLINE void store(F v, double* p) { hn::StoreU(v.v, wide::dd, p); }
  /// Rounded to float.
  static ZRAKA_INLINE void store_reals(F v, float* p) {
    const hn::Rebind<float, wide::Dd> floats;
    hn::StoreU(hn::DemoteTo(floats, v.v), floats, p);
  }
  static ZRAKA_INLINE M from_bits(std::uint32_t b) {
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(b)};
    return {hn::LoadMaskBits(wide::dd, bytes)};
  }
  /// base[index[i]] in lane i.
  static ZRAKA_INLINE F gather(const double* base, const std::int32_t* index) {
    const hn::RebindToSigned<wide::Dd> wide_index;
    const auto at = hn::LoadU(hn::Rebind<std::int32_t, wide::Dd>(), index);
    return hn::GatherIndex(wide::dd, base, hn::PromoteTo(wide_index, at));
  }
  /// b in the lanes of m, 0 in the others.
  static ZRAKA_INLINE B bits_if(M m, std::uint64_t b) {
    const hn::RebindToUnsigned<wide::Dd> du;
    return hn::IfThenElseZero(hn::RebindMask(du, m.v), hn::Set(du, b));
  }
  static ZRAKA_INLINE B flip(B a, B b) { return hn::Xor(a, b); }
  static ZRAKA_INLINE B unite(B a, B b) { return hn::Or(a, b); }
  /// Whether bit number `index` of a table is set.
  static ZRAKA_INLINE M has_bit(std::uint64_t table, B index) {
    const hn::RebindToUnsigned<wide::Dd> du;
    const B one = hn::Set(du, 1);
    return {hn::RebindMask(wide::dd, hn::Eq(hn::And(hn::Shr(hn::Set(du, table), index), one), one))};
  }
};
#endif

namespace doubles {
template <class R>
struct Beside;
template <>
struct Beside<double> {
  using Lanes = ScalarDoubles;
};
#ifdef ZRAKA_WIDE
template <>
struct Beside<float> {
  using Lanes = WideDoubles;
};
#endif
}  // namespace doubles
/// The double lanes beside lanes L.
template <class L>
using DoublesOf = typename doubles::Beside<typename L::Real>::Lanes;

/// So many registers of doubles hold a register of the engine's.
template <class L>
inline constexpr std::size_t kDoubleParts = L::kWidth / DoublesOf<L>::kWidth;

}  // namespace zraka::ZRAKA_ISA
