// SPDX-License-Identifier: Apache-2.0
#include "image/quantize.hpp"

#include <algorithm>
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

constexpr float kLeast = 0x1p-13f;  // stored as 0
constexpr auto kLeastBits = std::bit_cast<std::uint32_t>(kLeast);
constexpr int kLowBits = 23 - 7;  // 128 sums for each power of two
constexpr std::uint32_t kLow = (1u << kLowBits) - 1;

/// What is no number becomes the least.
float clamped_to_stored(float value) {
  const float at_least = value > kLeast ? value : kLeast;
  return at_least < 1 ? at_least : 1.0f;
}

}  // namespace

RowQuantizer::RowQuantizer(Transfer transfer, int bits) : transfer_(transfer), bits_(bits) {
  if (bits != 8) return;
  // quantize() grows with its value, and the bits of positive floats grow with the float.
  std::array<std::uint32_t, 257> least;  // the bits of the least float that is stored as each
  for (int v = 1; v < 256; ++v) {
    std::uint32_t low = 0, high = 0x3F800000;  // 0 is stored as less than v, 1 is not
    while (high - low > 1) {
      const std::uint32_t middle = low + (high - low) / 2;
      (quantize(std::bit_cast<float>(middle), transfer, 8) < v ? low : high) = middle;
    }
    least[static_cast<std::size_t>(v)] = high;
  }
  least[256] = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const std::uint32_t first = kLeastBits + (static_cast<std::uint32_t>(i) << kLowBits);
    while (first >= least[value + 1]) ++value;
    const std::uint32_t to_next = std::min(least[value + 1] - first, kLow + 1);
    sums_[i] = (value << kLowBits) + (kLow + 1 - to_next);
  }
}

unsigned char RowQuantizer::stored(float value) const {
  const std::uint32_t above = std::bit_cast<std::uint32_t>(value) - kLeastBits;
  return static_cast<unsigned char>((sums_[above >> kLowBits] + (above & kLow)) >> kLowBits);
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
  if (bits_ == 8) {
    constexpr std::size_t kTogether = 32;
    std::size_t i = 0;
    for (; i + kTogether <= count; i += kTogether) {
      float some[kTogether];
      for (std::size_t k = 0; k < kTogether; ++k) some[k] = clamped_to_stored(values[i + k]);
      for (std::size_t k = 0; k < kTogether; ++k) out[i + k] = stored(some[k]);
    }
    for (; i < count; ++i) out[i] = stored(clamped_to_stored(values[i]));
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint16_t v = quantize(values[i], transfer_, bits_);
    *out++ = static_cast<unsigned char>(v >> 8);
    *out++ = static_cast<unsigned char>(v & 0xFF);
  }
}

}  // namespace zraka
