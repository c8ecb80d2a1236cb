// SPDX-License-Identifier: Apache-2.0
#include "image/quantize.hpp"

#include <bit>
#include <limits>

#include "image/transfer.hpp"

namespace zraka {

std::uint16_t quantize(float value, Transfer transfer, int bits) {
  if (!(value > 0)) return 0;
  double v = value < 1 ? static_cast<double>(value) : 1.0;
  if (transfer == Transfer::srgb) v = encode_srgb(v);
  return static_cast<std::uint16_t>(v * (bits == 16 ? 65535 : 255) + 0.5);
}

namespace {

constexpr std::uint32_t kLeastBits = 0x39800000;  // 2^-12
constexpr int kStartShift = 23 - 7;               // 128 starts for each power of two

}  // namespace

RowQuantizer::RowQuantizer(Transfer transfer, int bits) : transfer_(transfer), bits_(bits) {
  if (bits != 8) return;
  // quantize() grows with its value, and the bits of positive floats grow with the float.
  for (int v = 1; v < 256; ++v) {
    std::uint32_t low = 0, high = 0x3F800000;  // 0 is stored as less than v, 1 is not
    while (high - low > 1) {
      const std::uint32_t middle = low + (high - low) / 2;
      (quantize(std::bit_cast<float>(middle), transfer, 8) < v ? low : high) = middle;
    }
    least_[static_cast<std::size_t>(v)] = std::bit_cast<float>(high);
  }
  least_[256] = std::numeric_limits<float>::infinity();
  std::size_t value = 0;
  for (std::size_t i = 0; i < start_.size(); ++i) {
    const auto leading =
        std::bit_cast<float>(kLeastBits + (static_cast<std::uint32_t>(i) << kStartShift));
    while (leading >= least_[value + 1]) ++value;
    start_[i] = static_cast<unsigned char>(value);
  }
}

void RowQuantizer::row(const float* values, std::size_t count, unsigned char* out) const {
  if (bits_ == 8 && transfer_ == Transfer::linear) {  // the loop that the compiler can make wide
    for (std::size_t i = 0; i < count; ++i) {
      const float at_least_0 = values[i] > 0 ? values[i] : 0.0f;
      const double v = at_least_0 < 1 ? static_cast<double>(at_least_0) : 1.0;
      out[i] = static_cast<unsigned char>(static_cast<int>(v * 255 + 0.5));
    }
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (bits_ == 16) {
      const std::uint16_t v = quantize(values[i], transfer_, bits_);
      *out++ = static_cast<unsigned char>(v >> 8);
      *out++ = static_cast<unsigned char>(v & 0xFF);
      continue;
    }
    const float value = values[i] > 0 ? (values[i] < 1 ? values[i] : 1.0f) : 0.0f;
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const std::size_t start =
        bits < kLeastBits ? 0 : start_[(bits - kLeastBits) >> kStartShift];
    *out++ = static_cast<unsigned char>(start + (value >= least_[start + 1] ? 1 : 0));
  }
}

}  // namespace zraka
