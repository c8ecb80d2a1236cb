// SPDX-License-Identifier: Apache-2.0
// The sRGB curve (IEC 61966-2-1) and powers, by our own power function, so that files and numbers
// are equal on every system. Relative error about 2^-21.
#pragma once

#define ZRAKA_ISA isa_plain
#include "math/power.hpp"
#undef ZRAKA_ISA

namespace zraka {

/// From linear light, 0…1, to what a file holds and a screen is given.
inline double encode_srgb(double linear) {
  if (linear <= 0.0031308) return 12.92 * linear;
  return 1.055 * isa_plain::power(linear, 1 / 2.4) - 0.055;
}

/// The way back: the linear light that a screen makes of a value of 0…1.
inline double decode_srgb(double encoded) {
  if (encoded <= 0.04045) return encoded / 12.92;
  return isa_plain::power((encoded + 0.055) / 1.055, 2.4);
}

/// x^n for x ≥ 0.
inline double plain_power(double x, double n) {
  return isa_plain::power(x, n);
}

}  // namespace zraka
