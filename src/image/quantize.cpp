// SPDX-License-Identifier: Apache-2.0
#include "image/quantize.hpp"

#define ZRAKA_ISA isa_plain
#include "math/power.hpp"

namespace zraka {
namespace {

/// The sRGB curve of IEC 61966-2-1 by our own power, so that files are equal on every system.
double encode_srgb(double linear) {
  if (linear <= 0.0031308) return 12.92 * linear;
  return 1.055 * isa_plain::power(linear, 1 / 2.4) - 0.055;
}

}  // namespace

std::uint16_t quantize(float value, Transfer transfer, int bits) {
  if (!(value > 0)) return 0;
  double v = value < 1 ? static_cast<double>(value) : 1.0;
  if (transfer == Transfer::srgb) v = encode_srgb(v);
  return static_cast<std::uint16_t>(v * (bits == 16 ? 65535 : 255) + 0.5);
}

void RowQuantizer::row(const float* values, std::size_t count, unsigned char* out) const {
  if (transfer_ == Transfer::linear && bits_ == 8) {  // the loop that the compiler can make wide
    for (std::size_t i = 0; i < count; ++i) {
      const float at_least_0 = values[i] > 0 ? values[i] : 0.0f;
      const double v = at_least_0 < 1 ? static_cast<double>(at_least_0) : 1.0;
      out[i] = static_cast<unsigned char>(static_cast<int>(v * 255 + 0.5));
    }
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint16_t v = quantize(values[i], transfer_, bits_);
    if (bits_ == 16) *out++ = static_cast<unsigned char>(v >> 8);
    *out++ = static_cast<unsigned char>(v & 0xFF);
  }
}

}  // namespace zraka
