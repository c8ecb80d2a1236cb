// SPDX-License-Identifier: Apache-2.0
// From linear floats to stored integers.
#pragma once

#include <array>
#include <cstddef>
#include <zraka/image.hpp>

namespace zraka {

/// quantize() for many values.
class RowQuantizer {
 public:
  RowQuantizer(Transfer transfer, int bits);
  /// `count` values into bytes, two a value (high byte first) for 16 bits.
  void row(const float* values, std::size_t count, unsigned char* out) const;

 private:
  Transfer transfer_;
  int bits_;
  /// For 8 bits: the least float that is stored as each value; and what the least float of so many
  /// leading bits is stored as, from 2^-12 to 1. Any other of these bits is stored as that or as
  /// the next value.
  std::array<float, 257> least_{};
  std::array<unsigned char, 12 * 128 + 1> start_{};
};

}  // namespace zraka
