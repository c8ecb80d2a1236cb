// SPDX-License-Identifier: Apache-2.0
// Pictures of stored values in a quarter of their memory, for whoever keeps many.
#pragma once

#include <array>
#include <cstdint>
#include <vector>
#include <zraka/image.hpp>

namespace zraka {

/// A picture as as_stored() gives it for 8 bits, in bytes.
class PackedImage {
 public:
  PackedImage() = default;
  explicit PackedImage(const Image& stored);

  Image image() const;
  /// Red, green and blue of a pixel.
  std::array<std::uint8_t, 3> at(std::uint32_t x, std::uint32_t y) const;

 private:
  std::uint32_t width_ = 0, height_ = 0;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace zraka
