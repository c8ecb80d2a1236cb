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
  /// For 8 bits: the least float that is stored as each value; and a value to start looking from,
  /// for the leading bits of floats from 2^-12 to 1.
  std::array<float, 257> least_{};
  std::array<unsigned char, 12 * 32 + 1> start_{};
};

}  // namespace zraka
