// SPDX-License-Identifier: Apache-2.0
// Points that fill the unit square evenly, however many of them are taken: the first two dimensions
// of Sobol's sequence, scrambled as Owen does. More dimensions are further pairs with scrambles of
// their own, each in an order of its own (padding: Burley, "Practical hash-based Owen scrambling",
// JCGT 9(4), 2020, section 5).
#pragma once

#include <cstdint>

#include "math/inline.hpp"
#include "sampling/hash.hpp"

namespace zraka {

/// More than 0 and less than 1.
struct Point2 {
  double u, v;
};

ZRAKA_INLINE constexpr std::uint32_t reverse_bits(std::uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0xFF00FF00u) >> 8) | ((x & 0x00FF00FFu) << 8);
  x = ((x & 0xF0F0F0F0u) >> 4) | ((x & 0x0F0F0F0Fu) << 4);
  x = ((x & 0xCCCCCCCCu) >> 2) | ((x & 0x33333333u) << 2);
  return ((x & 0xAAAAAAAAu) >> 1) | ((x & 0x55555555u) << 1);
}

/// Owen's nested uniform scrambling of a number whose bits are reversed: whether a bit is flipped
/// depends on the key and on the bits below it, which weigh more. Laine and Karras, "Stratified
/// sampling for stochastic transparency", 2011, section 3.1, with the constants of Vegdahl,
/// "Building a better LK hash", 2021, since the paper's leave patterns that can be seen.
ZRAKA_INLINE constexpr std::uint32_t scramble_reversed(std::uint32_t x, std::uint32_t key) {
  x ^= x * 0x3D20ADEAu;
  x += key;
  x *= (key >> 16) | 1;
  x ^= x * 0x05526C56u;
  return x ^ (x * 0x53A22864u);
}

/// The bits of the second coordinate from those of the index, both with the least first: Pascal's
/// triangle modulo 2 (Sobol 1967), by halves as in Ahmed, "An implementation algorithm of 2D Sobol
/// sequence fast, elegant, and compact", 2024.
ZRAKA_INLINE constexpr std::uint32_t second_sobol_reversed(std::uint32_t index) {
  index ^= (index >> 16) & 0x0000FFFFu;
  index ^= (index >> 8) & 0x00FF00FFu;
  index ^= (index >> 4) & 0x0F0F0F0Fu;
  index ^= (index >> 2) & 0x33333333u;
  return index ^ ((index >> 1) & 0x55555555u);
}

/// A scrambled and shuffled sequence; the key says which. Each 2^k points from a multiple of 2^k on
/// have one in each of the 2^k equal rectangles that halving the square makes, of any shape: a
/// (0,2)-sequence.
struct Sobol2 {
  std::uint32_t shuffle, scramble_u, scramble_v;

  constexpr explicit Sobol2(std::uint32_t key)
      : Sobol2(hash(key, 0), hash(key, 1), hash(key, 2)) {}
  /// From keys that another one had.
  ZRAKA_INLINE constexpr Sobol2(std::uint32_t for_order, std::uint32_t for_u, std::uint32_t for_v)
      : shuffle(for_order), scramble_u(for_u), scramble_v(for_v) {}

  constexpr Point2 operator[](std::uint32_t index) const {
    std::uint32_t u = 0, v = 0;
    find_bits(index, u, v);
    return {unit_of(u), unit_of(v)};
  }

  /// The same, in 2^-32.
  ZRAKA_INLINE constexpr void find_bits(std::uint32_t index, std::uint32_t& u,
                                        std::uint32_t& v) const {
    const std::uint32_t at = order(index);
    u = first_bits(at), v = second_bits(at);
  }

  /// The steps of this: where in the sequence, and from there each coordinate.
  ZRAKA_INLINE constexpr std::uint32_t order(std::uint32_t index) const {
    return reverse_bits(scramble_reversed(reverse_bits(index), shuffle));
  }
  ZRAKA_INLINE constexpr std::uint32_t first_bits(std::uint32_t at) const {
    return reverse_bits(scramble_reversed(at, scramble_u));
  }
  ZRAKA_INLINE constexpr std::uint32_t second_bits(std::uint32_t at) const {
    return reverse_bits(scramble_reversed(second_sobol_reversed(at), scramble_v));
  }
};

/// One point of it.
constexpr Point2 sobol_2d(std::uint32_t index, std::uint32_t scramble) {
  return Sobol2(scramble)[index];
}

}  // namespace zraka
