// SPDX-License-Identifier: Apache-2.0
// From linear floats to stored integers.
#pragma once

#include <cstddef>
#include <zraka/image.hpp>

namespace zraka {

/// quantize() for many values.
class RowQuantizer {
 public:
  RowQuantizer(Transfer transfer, int bits) : transfer_(transfer), bits_(bits) {}
  /// `count` values into bytes, two a value (high byte first) for 16 bits.
  void row(const float* values, std::size_t count, unsigned char* out) const;

 private:
  Transfer transfer_;
  int bits_;
};

}  // namespace zraka
