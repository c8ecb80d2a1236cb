// SPDX-License-Identifier: Apache-2.0
// Numbers by chance that are the same on every machine, whatever its standard library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace zraka {

/// SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  /// 0 or more, less than 1.
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  /// One of 0…n-1, each as likely as the others; n is 1 or more.
  std::uint64_t below(std::uint64_t n) {
    // The 2^64 mod n numbers that would favour the first remainders are drawn again.
    const std::uint64_t uneven = (0 - n) % n;
    std::uint64_t drawn = next();
    while (drawn < uneven) drawn = next();
    return drawn % n;
  }

  /// Every order is as likely (Fisher and Yates).
  template <class T>
  void shuffle(std::vector<T>& list) {
    for (std::size_t i = list.size(); i > 1; --i) {
      const auto j = static_cast<std::size_t>(below(i));
      if (j != i - 1) std::swap(list[i - 1], list[j]);
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace zraka
