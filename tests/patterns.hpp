// SPDX-License-Identifier: Apache-2.0
// Pictures that measures are tried on.
#pragma once

#include <cstdint>
#include <zraka/image.hpp>

namespace zraka {

/// A picture with edges and slopes of all channels, and one that differs from it in a patch and in
/// coarser steps of green on the right.
inline Image pattern() {
  Image image(96, 64);
  for (std::uint32_t y = 0; y < 64; ++y)
    for (std::uint32_t x = 0; x < 96; ++x) {
      image.row(y)[3 * x] = static_cast<float>((x * 5 + y * 3) % 256) / 255.0f;
      image.row(y)[3 * x + 1] = static_cast<float>(x * y % 256) / 255.0f;
      image.row(y)[3 * x + 2] = static_cast<float>((255 - x * 2 + y) % 256) / 255.0f;
    }
  return image;
}
inline Image changed_pattern() {
  Image image = pattern();
  for (std::uint32_t y = 0; y < 64; ++y)
    for (std::uint32_t x = 0; x < 96; ++x) {
      float* pixel = image.row(y) + 3 * x;
      if (x >= 30 && x < 60 && y >= 20 && y < 40) {
        pixel[0] = 200 / 255.0f;
        pixel[1] = 30 / 255.0f;
        pixel[2] = 90 / 255.0f;
      }
      if (x > 70) pixel[1] = static_cast<float>(x * y % 256 / 32 * 32) / 255.0f;
    }
  return image;
}

}  // namespace zraka
