// SPDX-License-Identifier: Apache-2.0
// Lanes of floats in the registers of one instruction set, through Highway. Included by lanes.hpp.
#pragma once

#include <hwy/highway.h>

namespace zraka::ZRAKA_ISA {

namespace hn = hwy::HWY_NAMESPACE;

namespace wide {
using D = hn::ScalableTag<float>;
using Di = hn::RebindToSigned<D>;
inline constexpr D d{};
inline constexpr Di di{};
}  // namespace wide

// Lanes say themselves how they are copied: else compilers copy structs of them as bytes, sixteen
// at a time through memory, and loads of whole registers wait until all of these have been stored.

struct FloatLanes {
  hn::Vec<wide::D> v;
  FloatLanes() = default;                                           // any values
  ZRAKA_INLINE FloatLanes(hn::Vec<wide::D> lanes) : v(lanes) {}     // NOLINT: implicit on purpose
  ZRAKA_INLINE FloatLanes(float all) : v(hn::Set(wide::d, all)) {}  // NOLINT: implicit on purpose
  ZRAKA_INLINE FloatLanes(const FloatLanes& other) : v(other.v) {}
  ZRAKA_INLINE FloatLanes& operator=(const FloatLanes& other) {
    v = other.v;
    return *this;
  }
};
struct IndexLanes {
  hn::Vec<wide::Di> v;
  IndexLanes() = default;
  ZRAKA_INLINE IndexLanes(hn::Vec<wide::Di> lanes) : v(lanes) {}  // NOLINT: implicit on purpose
  ZRAKA_INLINE IndexLanes(std::int32_t all)
      : v(hn::Set(wide::di, all)) {}  // NOLINT: implicit on purpose
  ZRAKA_INLINE IndexLanes(const IndexLanes& other) : v(other.v) {}
  ZRAKA_INLINE IndexLanes& operator=(const IndexLanes& other) {
    v = other.v;
    return *this;
  }
};
struct MaskLanes {
  hn::Mask<wide::D> v;
  MaskLanes() = default;                                         // any values
  ZRAKA_INLINE MaskLanes(hn::Mask<wide::D> lanes) : v(lanes) {}  // NOLINT: implicit on purpose
  ZRAKA_INLINE MaskLanes(const MaskLanes& other) : v(other.v) {}
  ZRAKA_INLINE MaskLanes& operator=(const MaskLanes& other) {
    v = other.v;
    return *this;
  }
};

ZRAKA_INLINE FloatLanes operator+(FloatLanes a, FloatLanes b) {
  return hn::Add(a.v, b.v);
}
ZRAKA_INLINE FloatLanes operator-(FloatLanes a, FloatLanes b) {
  return hn::Sub(a.v, b.v);
}
ZRAKA_INLINE FloatLanes operator*(FloatLanes a, FloatLanes b) {
  return hn::Mul(a.v, b.v);
}
ZRAKA_INLINE FloatLanes operator/(FloatLanes a, FloatLanes b) {
  return hn::Div(a.v, b.v);
}
ZRAKA_INLINE FloatLanes operator-(FloatLanes a) {
  return hn::Neg(a.v);
}
ZRAKA_INLINE MaskLanes operator<(FloatLanes a, FloatLanes b) {
  return {hn::Lt(a.v, b.v)};
}
ZRAKA_INLINE MaskLanes operator>(FloatLanes a, FloatLanes b) {
  return {hn::Lt(b.v, a.v)};
}
ZRAKA_INLINE MaskLanes operator<=(FloatLanes a, FloatLanes b) {
  return {hn::Le(a.v, b.v)};
}
ZRAKA_INLINE MaskLanes operator>=(FloatLanes a, FloatLanes b) {
  return {hn::Le(b.v, a.v)};
}
ZRAKA_INLINE MaskLanes operator==(FloatLanes a, FloatLanes b) {
  return {hn::Eq(a.v, b.v)};
}
ZRAKA_INLINE IndexLanes operator+(IndexLanes a, IndexLanes b) {
  return hn::Add(a.v, b.v);
}
ZRAKA_INLINE IndexLanes operator*(IndexLanes a, IndexLanes b) {
  return hn::Mul(a.v, b.v);
}
ZRAKA_INLINE MaskLanes operator==(IndexLanes a, IndexLanes b) {
  return {hn::RebindMask(wide::d, hn::Eq(a.v, b.v))};
}
ZRAKA_INLINE MaskLanes operator>(IndexLanes a, IndexLanes b) {
  return {hn::RebindMask(wide::d, hn::Lt(b.v, a.v))};
}
ZRAKA_INLINE MaskLanes operator>=(IndexLanes a, IndexLanes b) {
  return {hn::RebindMask(wide::d, hn::Not(hn::Lt(a.v, b.v)))};
}

/// The least and the greatest of all lanes; without rounding, so in any order.
ZRAKA_INLINE float min_of(FloatLanes v) {
  return hn::GetLane(hn::MinOfLanes(wide::d, v.v));
}
ZRAKA_INLINE float max_of(FloatLanes v) {
  return hn::GetLane(hn::MaxOfLanes(wide::d, v.v));
}
#if HWY_TARGET == HWY_SCALAR
ZRAKA_INLINE void min_of_each(FloatLanes a, FloatLanes b, FloatLanes c, FloatLanes d,
                              float (&out)[4]) {
  out[0] = min_of(a), out[1] = min_of(b), out[2] = min_of(c), out[3] = min_of(d);
}
#else
/// The least of all blocks of four lanes, lane by lane.
template <class D>
ZRAKA_INLINE hn::Vec<hn::FixedTag<float, 4>> least_block(D d, hn::Vec<D> v) {
  if constexpr (hn::MaxLanes(d) > 4) {
    const hn::Half<D> half;
    return least_block(half, hn::Min(hn::LowerHalf(half, v), hn::UpperHalf(half, v)));
  } else {
    return v;
  }
}
/// The least of all lanes of each of four.
ZRAKA_INLINE void min_of_each(FloatLanes a, FloatLanes b, FloatLanes c, FloatLanes d,
                              float (&out)[4]) {
  // Four registers become one whose every block of four lanes has a least of each.
  using D2 = hn::RepartitionToWide<hn::RebindToUnsigned<wide::D>>;
  const auto pair = [](FloatLanes p, FloatLanes q) {
    return hn::BitCast(D2(), hn::Min(hn::InterleaveLower(wide::d, p.v, q.v),
                                     hn::InterleaveUpper(wide::d, p.v, q.v)));
  };
  const auto ab = pair(a, b), cd = pair(c, d);
  const auto least = hn::Min(hn::BitCast(wide::d, hn::InterleaveLower(D2(), ab, cd)),
                             hn::BitCast(wide::d, hn::InterleaveUpper(D2(), ab, cd)));
  hn::StoreU(least_block(wide::d, least), hn::FixedTag<float, 4>(), out);
}
#endif
/// Bit i is set where lane i is true.
ZRAKA_INLINE std::uint32_t bits(MaskLanes m) {
#if HWY_TARGET <= HWY_AVX3  // by way of bytes it takes four instructions more
  return m.v.raw;
#else
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(wide::d, m.v, bytes);
  return static_cast<std::uint32_t>(bytes[0] | bytes[1] << 8);
#endif
}
ZRAKA_INLINE bool any(MaskLanes m) {
  return !hn::AllFalse(wide::d, m.v);
}
ZRAKA_INLINE bool all(MaskLanes m) {
  return hn::AllTrue(wide::d, m.v);
}
ZRAKA_INLINE std::size_t count(MaskLanes m) {
  return hn::CountTrue(wide::d, m.v);
}
ZRAKA_INLINE MaskLanes both(MaskLanes a, MaskLanes b) {
  return {hn::And(a.v, b.v)};
}
ZRAKA_INLINE MaskLanes either(MaskLanes a, MaskLanes b) {
  return {hn::Or(a.v, b.v)};
}
ZRAKA_INLINE MaskLanes but_not(MaskLanes a, MaskLanes b) {
  return {hn::AndNot(b.v, a.v)};
}
ZRAKA_INLINE FloatLanes select(MaskLanes m, FloatLanes a, FloatLanes b) {
  return hn::IfThenElse(m.v, a.v, b.v);
}
ZRAKA_INLINE IndexLanes select(MaskLanes m, IndexLanes a, IndexLanes b) {
  return hn::IfThenElse(hn::RebindMask(wide::di, m.v), a.v, b.v);
}
/// Sets bits that were not set, where m holds.
ZRAKA_INLINE IndexLanes set_bits(MaskLanes m, IndexLanes bits, IndexLanes to) {
  const auto where = hn::RebindMask(wide::di, m.v);
#if HWY_TARGET <= HWY_AVX3
  return hn::IfThenElse(where, hn::Or(to.v, bits.v), to.v);
#else  // a choice takes three instructions
  return hn::Or(to.v, hn::IfThenElseZero(where, bits.v));
#endif
}
/// Keys that have the order of numbers that are not below 0, and of equal ones that of lanes, of
/// which `first` is the first one's number: below 16.
ZRAKA_INLINE IndexLanes keys_of(FloatLanes v, std::size_t first) {
  return hn::Or(hn::AndNot(hn::Set(wide::di, 15), hn::BitCast(wide::di, v.v)),
                hn::Iota(wide::di, static_cast<std::int32_t>(first)));
}
ZRAKA_INLINE FloatLanes sqrt(FloatLanes a) {
  return hn::Sqrt(a.v);
}
#if HWY_ARCH_X86
// The registers' own: a < b ? a : b, also for NaN and for zeros of both signs.
ZRAKA_INLINE FloatLanes min(FloatLanes a, FloatLanes b) {
  return hn::Min(a.v, b.v);
}
ZRAKA_INLINE FloatLanes max(FloatLanes a, FloatLanes b) {
  return hn::Max(a.v, b.v);
}
#else
ZRAKA_INLINE FloatLanes min(FloatLanes a, FloatLanes b) {
  return select(a < b, a, b);
}
ZRAKA_INLINE FloatLanes max(FloatLanes a, FloatLanes b) {
  return select(a > b, a, b);
}
#endif
/// a·b - c, rounded once or twice: for the tests of boxes only, which may differ between
/// instruction sets.
ZRAKA_INLINE FloatLanes roughly_mul_sub(FloatLanes a, FloatLanes b, FloatLanes c) {
  return hn::MulSub(a.v, b.v, c.v);
}
/// a·b + c, likewise.
ZRAKA_INLINE FloatLanes roughly_mul_add(FloatLanes a, FloatLanes b, FloatLanes c) {
  return hn::MulAdd(a.v, b.v, c.v);
}
ZRAKA_INLINE FloatLanes copy_sign(FloatLanes magnitude, FloatLanes sign) {
  return hn::CopySign(magnitude.v, sign.v);
}
ZRAKA_INLINE FloatLanes abs(FloatLanes a) {
  return hn::Abs(a.v);
}
ZRAKA_INLINE std::int32_t first_lane(IndexLanes v) {
  return hn::GetLane(v.v);
}
/// Exponent and mantissa of a positive normal number: a = m·2^e with m in [√½, √2).
ZRAKA_INLINE void split_exponent(FloatLanes a, FloatLanes& e, FloatLanes& m) {
  const auto bits = hn::BitCast(wide::di, a.v);
  const auto exponent = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(wide::di, 0x3f3504f3)));  // √½
  e = hn::ConvertTo(wide::d, exponent);
  m = hn::BitCast(wide::d, hn::Sub(bits, hn::ShiftLeft<23>(exponent)));
}
/// a·2^n for an integral n with both a and the result normal numbers.
ZRAKA_INLINE FloatLanes scale_by_power(FloatLanes a, FloatLanes n) {
  const auto exponent = hn::ShiftLeft<23>(hn::ConvertTo(wide::di, n.v));
  return hn::BitCast(wide::d, hn::Add(hn::BitCast(wide::di, a.v), exponent));
}
ZRAKA_INLINE FloatLanes round_to_integer(FloatLanes a) {
  return hn::Round(a.v);
}

namespace wide {
/// For each mask of eight lanes the indices of those that are set, a byte each. Highway's own table
/// is copied to the stack by g++ 12, a kilobyte at every use.
struct PackTable {
  alignas(64) std::uint8_t indices[256][8];
  constexpr PackTable() : indices{} {
    for (unsigned mask = 0; mask < 256; ++mask)
      for (unsigned lane = 0, to = 0; lane < 8; ++lane)
        if ((mask >> lane & 1) != 0) indices[mask][to++] = static_cast<std::uint8_t>(lane);
  }
};
inline constexpr PackTable kPackTable{};

template <class Tag>
ZRAKA_INLINE hn::Vec<Tag> pack(Tag tag, hn::Vec<Tag> v, hn::Mask<Tag> m, std::uint32_t mask_bits) {
  if constexpr (hn::MaxLanes(Tag()) == 8) {
    const auto bytes =
        hn::LoadU(hn::Rebind<std::uint8_t, Tag>(), kPackTable.indices[mask_bits & 0xFF]);
    const auto indices = hn::IndicesFromVec(tag, hn::PromoteTo(hn::RebindToSigned<Tag>(), bytes));
    return hn::TableLookupLanes(v, indices);
  } else {
    return hn::Compress(v, m);
  }
}
}  // namespace wide

struct WideLanes {
  using Real = float;
  using F = FloatLanes;
  using I = IndexLanes;
  using M = MaskLanes;
  static constexpr std::size_t kWidth = HWY_LANES(float);

  static ZRAKA_INLINE F load(const float* p) { return hn::LoadU(wide::d, p); }
  static ZRAKA_INLINE F load_box(const float* p) { return hn::LoadU(wide::d, p); }
  static ZRAKA_INLINE I load(const std::int32_t* p) { return hn::LoadU(wide::di, p); }
  static ZRAKA_INLINE void store(F v, float* p) { hn::StoreU(v.v, wide::d, p); }
  static ZRAKA_INLINE void store(I v, std::int32_t* p) { hn::StoreU(v.v, wide::di, p); }
  static ZRAKA_INLINE F gather(const float* base, I index) {
    return hn::GatherIndex(wide::d, base, index.v);
  }
  static ZRAKA_INLINE I gather(const std::int32_t* base, I index) {
    return hn::GatherIndex(wide::di, base, index.v);
  }
  /// out[k] is base[at + k], lane by lane. With AVX2 and AVX-512, `base` and all of `at` are
  /// multiples of 16 bytes: to load a row for each lane and turn them takes half the time of four
  /// gathers.
  static ZRAKA_INLINE void gather_four(const float* base, I at, F (&out)[4]) {
#if HWY_TARGET <= HWY_AVX2
    alignas(64) std::int32_t indices[kWidth];
    hn::Store(at.v, wide::di, indices);
    const auto row = [&](std::size_t lane) { return _mm_load_ps(base + indices[lane]); };
    const auto each_fourth = [&](std::size_t lane) -> hn::Vec<wide::D> {
#if HWY_TARGET <= HWY_AVX3
      __m512 v = _mm512_castps128_ps512(row(lane));
      v = _mm512_insertf32x4(v, row(lane + 4), 1);
      v = _mm512_insertf32x4(v, row(lane + 8), 2);
      return {_mm512_insertf32x4(v, row(lane + 12), 3)};
#else
      return {_mm256_insertf128_ps(_mm256_castps128_ps256(row(lane)), row(lane + 4), 1)};
#endif
    };
    const auto a = each_fourth(0), b = each_fourth(1), c = each_fourth(2), d = each_fourth(3);
    using D2 = hn::RepartitionToWide<hn::RebindToUnsigned<wide::D>>;
    const auto pair = [](auto v) { return hn::BitCast(D2(), v); };
    const auto ab0 = pair(hn::InterleaveLower(wide::d, a, b));
    const auto ab1 = pair(hn::InterleaveUpper(wide::d, a, b));
    const auto cd0 = pair(hn::InterleaveLower(wide::d, c, d));
    const auto cd1 = pair(hn::InterleaveUpper(wide::d, c, d));
    out[0] = hn::BitCast(wide::d, hn::InterleaveLower(D2(), ab0, cd0));
    out[1] = hn::BitCast(wide::d, hn::InterleaveUpper(D2(), ab0, cd0));
    out[2] = hn::BitCast(wide::d, hn::InterleaveLower(D2(), ab1, cd1));
    out[3] = hn::BitCast(wide::d, hn::InterleaveUpper(D2(), ab1, cd1));
#else
    for (int k = 0; k < 4; ++k) out[k] = gather(base + k, at);
#endif
  }
  /// From a table of 32 values, or of kWidth where registers are narrow.
  static ZRAKA_INLINE F look_up(const float* table, I index) {
#if HWY_TARGET <= HWY_AVX3  // Highway 1.0 has no tables of two registers
    return hn::Vec<wide::D>{_mm512_permutex2var_ps(hn::LoadU(wide::d, table).raw, index.v.raw,
                                                   hn::LoadU(wide::d, table + kWidth).raw)};
#else
    return gather(table, index);
#endif
  }
  static ZRAKA_INLINE void scatter(F v, M m, float* base, I index) {
#if HWY_TARGET <= HWY_AVX3  // Highway 1.0 has no masked scatter
    _mm512_mask_i32scatter_ps(base, m.v.raw, index.v.raw, v.v.raw, sizeof(float));
#else
    alignas(64) float values[kWidth];
    alignas(64) std::int32_t indices[kWidth];
    hn::Store(v.v, wide::d, values);
    hn::Store(hn::IfThenElse(hn::RebindMask(wide::di, m.v), index.v, hn::Set(wide::di, -1)),
              wide::di, indices);
    for (std::size_t i = 0; i < kWidth; ++i)
      if (indices[i] >= 0) base[indices[i]] = values[i];
#endif
  }
  /// The lanes of m first; any values after them.
  static ZRAKA_INLINE F compress(F v, M m) {
    return wide::pack(wide::d, v.v, m.v, bits(m));
  }
  static ZRAKA_INLINE I compress(I v, M m) {
    return wide::pack(wide::di, v.v, hn::RebindMask(wide::di, m.v), bits(m));
  }
  /// May write up to kWidth values, of which the first count(m) are meant: a masked store would
  /// delay what is read from there soon.
  static ZRAKA_INLINE void compress_store(F v, M m, float* p) {
    store(compress(v, m), p);
  }
  static ZRAKA_INLINE void compress_store(I v, M m, std::int32_t* p) {
    store(compress(v, m), p);
  }
  static ZRAKA_INLINE M first(std::size_t n) {
    return {hn::FirstN(wide::d, n)};
  }
  static ZRAKA_INLINE M from_bits(std::uint32_t b) {
#if HWY_TARGET <= HWY_AVX3
    return {hn::Mask<wide::D>{static_cast<__mmask16>(b)}};
#else
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(b & 0xFF),
                                   static_cast<std::uint8_t>(b >> 8 & 0xFF)};
    return {hn::LoadMaskBits(wide::d, bytes)};
#endif
  }
  static ZRAKA_INLINE I iota(std::int32_t start) {
    return hn::Iota(wide::di, start);
  }
  static ZRAKA_INLINE F to_real(I v) {
    return hn::ConvertTo(wide::d, v.v);
  }
};

}  // namespace zraka::ZRAKA_ISA
