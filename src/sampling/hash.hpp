// SPDX-License-Identifier: Apache-2.0
// Random numbers without a state: what is drawn depends on what it is drawn for, and on nothing
// else, so that threads and tiles do not matter.
#pragma once

#include <cstdint>

namespace zraka {

/// Every bit of the result depends on all bits of the argument; a bijection. SplitMix64's (Steele,
/// Lea and Flood, "Fast splittable pseudorandom number generators", 2014).
constexpr std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

/// One number of several, in this order: seed, pixel, what it is for.
template <class... Numbers>
constexpr std::uint32_t hash(Numbers... numbers) {
  std::uint64_t state = 0;
  ((state = mix((state ^ static_cast<std::uint32_t>(numbers)) + 0x9E3779B97F4A7C15u)), ...);
  return static_cast<std::uint32_t>(state >> 32);
}

/// More than 0 and less than 1, in the middle of the 2^32 equal intervals.
constexpr double unit_of(std::uint32_t bits) {
  return (bits + 0.5) * 0x1p-32;
}

}  // namespace zraka
