// SPDX-License-Identifier: Apache-2.0
// Many points of Sobol's sequence, in lanes: the bits of sampling/sobol.hpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/engine.hpp"
#include "math/lanes.hpp"
#include "sampling/sobol.hpp"

namespace zraka::ZRAKA_ISA {

#if defined(ZRAKA_WIDE) && HWY_TARGET <= HWY_AVX2
/// The bits of numbers without a sign.
struct BitLanes {
  static constexpr hn::RebindToUnsigned<wide::D> kTag{};
  using U = hn::Vec<hn::RebindToUnsigned<wide::D>>;
  static constexpr std::size_t kWidth = HWY_LANES(float);
  static ZRAKA_INLINE U load(const std::uint32_t* p) { return hn::LoadU(kTag, p); }
  static ZRAKA_INLINE void store(U v, std::uint32_t* p) { hn::StoreU(v, kTag, p); }
  static ZRAKA_INLINE U all(std::uint32_t v) { return hn::Set(kTag, v); }
  static ZRAKA_INLINE U iota(std::uint32_t first) {
    return hn::Add(all(first), hn::Iota(kTag, 0));  // from `first` it would be made one by one
  }
};

/// As the functions of these names: compilers make no use of tables of half bytes by themselves.
ZRAKA_INLINE BitLanes::U reverse_bits(BitLanes::U x) {
  alignas(16) static constexpr std::uint8_t kBytes[16] = {3,  2,  1, 0, 7,  6,  5,  4,
                                                          11, 10, 9, 8, 15, 14, 13, 12};
  alignas(16) static constexpr std::uint8_t kLow[16] = {0x00, 0x80, 0x40, 0xC0, 0x20, 0xA0,
                                                        0x60, 0xE0, 0x10, 0x90, 0x50, 0xD0,
                                                        0x30, 0xB0, 0x70, 0xF0};
  alignas(16) static constexpr std::uint8_t kHigh[16] = {0, 8, 4, 12, 2, 10, 6, 14,
                                                         1, 9, 5, 13, 3, 11, 7, 15};
  const hn::Repartition<std::uint8_t, decltype(BitLanes::kTag)> bytes_tag;
  const auto half = hn::Set(bytes_tag, 15);
  const auto bytes =
      hn::TableLookupBytes(hn::BitCast(bytes_tag, x), hn::LoadDup128(bytes_tag, kBytes));
  const auto shifted = hn::ShiftRight<4>(hn::BitCast(BitLanes::kTag, bytes));
  const auto low = hn::TableLookupBytes(hn::LoadDup128(bytes_tag, kLow), hn::And(bytes, half));
  const auto high = hn::TableLookupBytes(hn::LoadDup128(bytes_tag, kHigh),
                                         hn::And(hn::BitCast(bytes_tag, shifted), half));
  return hn::BitCast(BitLanes::kTag, hn::Or(low, high));
}
ZRAKA_INLINE BitLanes::U scramble_reversed(BitLanes::U x, BitLanes::U key) {
  const auto times = [](BitLanes::U a, std::uint32_t b) { return hn::Mul(a, BitLanes::all(b)); };
  x = hn::Xor(x, times(x, 0x3D20ADEAu));
  x = hn::Add(x, key);
  x = hn::Mul(x, hn::Or(hn::ShiftRight<16>(key), BitLanes::all(1)));
  x = hn::Xor(x, times(x, 0x05526C56u));
  return hn::Xor(x, times(x, 0x53A22864u));
}
ZRAKA_INLINE BitLanes::U second_sobol_reversed(BitLanes::U index) {
  const auto masked = [](BitLanes::U a, std::uint32_t b) { return hn::And(a, BitLanes::all(b)); };
  index = hn::Xor(index, hn::ShiftRight<16>(index));
  index = hn::Xor(index, masked(hn::ShiftRight<8>(index), 0x00FF00FFu));
  index = hn::Xor(index, masked(hn::ShiftRight<4>(index), 0x0F0F0F0Fu));
  index = hn::Xor(index, masked(hn::ShiftRight<2>(index), 0x33333333u));
  return hn::Xor(index, masked(hn::ShiftRight<1>(index), 0x55555555u));
}
#else
/// Plain loops over these the compiler makes lanes of.
struct BitLanes {
  using U = std::uint32_t;
  static constexpr std::size_t kWidth = 1;
  static ZRAKA_INLINE U load(const std::uint32_t* p) { return *p; }
  static ZRAKA_INLINE void store(U v, std::uint32_t* p) { *p = v; }
  static ZRAKA_INLINE U all(std::uint32_t v) { return v; }
  static ZRAKA_INLINE U iota(std::uint32_t first) { return first; }
};
#endif

/// Points of sequences of their own, from number `first` of some arrays on.
class PointsOfEach {
 public:
  using U = BitLanes::U;
  ZRAKA_INLINE PointsOfEach(const SampleKeys& keys, std::size_t first)
      : shuffle_(keys.shuffle + first),
        u_(keys.u + first),
        v_(keys.v + first),
        number_(keys.number + first) {}
  ZRAKA_INLINE U number(std::size_t i) const { return BitLanes::load(number_ + i); }
  ZRAKA_INLINE U shuffle(std::size_t i) const { return BitLanes::load(shuffle_ + i); }
  ZRAKA_INLINE U u(std::size_t i) const { return BitLanes::load(u_ + i); }
  ZRAKA_INLINE U v(std::size_t i) const { return BitLanes::load(v_ + i); }

 private:
  const std::uint32_t *shuffle_, *u_, *v_, *number_;
};

/// Points of one sequence, from number `first` on.
class PointsOfOne {
 public:
  using U = BitLanes::U;
  ZRAKA_INLINE PointsOfOne(const Sobol2& sequence, std::uint32_t first)
      : sequence_(sequence), first_(first) {}
  ZRAKA_INLINE U number(std::size_t i) const {
    return BitLanes::iota(first_ + static_cast<std::uint32_t>(i));
  }
  ZRAKA_INLINE U shuffle(std::size_t) const { return BitLanes::all(sequence_.shuffle); }
  ZRAKA_INLINE U u(std::size_t) const { return BitLanes::all(sequence_.scramble_u); }
  ZRAKA_INLINE U v(std::size_t) const { return BitLanes::all(sequence_.scramble_v); }

 private:
  const Sobol2 sequence_;
  const std::uint32_t first_;
};

/// At a time; what is drawn from and to has room for whole registers.
inline constexpr std::size_t kMostPoints = 128;

/// As Sobol2::find_bits() of n points. One step of many points after the other: each waits long for
/// what is before it.
template <class Points>
ZRAKA_INLINE void find_bits(const Points& points, std::size_t n, std::uint32_t* __restrict u,
                            std::uint32_t* __restrict v) {
  constexpr std::size_t kWidth = BitLanes::kWidth;
  alignas(64) std::uint32_t places[kMostPoints];
  for (std::size_t i = 0; i < n; i += kWidth)
    BitLanes::store(reverse_bits(scramble_reversed(reverse_bits(points.number(i)),
                                                   points.shuffle(i))),
                    places + i);
  for (std::size_t i = 0; i < n; i += kWidth)
    BitLanes::store(reverse_bits(scramble_reversed(BitLanes::load(places + i), points.u(i))),
                    u + i);
  for (std::size_t i = 0; i < n; i += kWidth)
    BitLanes::store(reverse_bits(scramble_reversed(
                        second_sobol_reversed(BitLanes::load(places + i)), points.v(i))),
                    v + i);
}

}  // namespace zraka::ZRAKA_ISA
