// SPDX-License-Identifier: Apache-2.0
// From linear floats to stored integers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <zraka/image.hpp>

namespace zraka {

/// quantize() for many values.
class RowQuantizer {
 public:
  RowQuantizer(Transfer transfer, int bits);
  /// `count` values into bytes, two a value (high byte first) for 16 bits.
  void row(const float* values, std::size_t count, unsigned char* out) const;

 private:
  unsigned char stored(float clamped_value) const;

  Transfer transfer_;
  int bits_;
  /// For 8 bits, by the leading bits of floats from 2^-13 to 1: what the least float of these is
  /// stored as, times 2^16, and what is missing to the next value. Floats of the same leading bits
  /// are stored as that or as the next value, so the sum with the other 16 bits says which.
  std::array<std::uint32_t, 13 * 128 + 1> sums_{};
};

}  // namespace zraka
