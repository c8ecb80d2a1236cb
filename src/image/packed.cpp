// SPDX-License-Identifier: Apache-2.0
#include "image/packed.hpp"

#include <algorithm>
#include <cmath>

namespace zraka {

PackedImage::PackedImage(const Image& stored)
    : width_(stored.width), height_(stored.height), bytes_(stored.pixels.size()) {
  std::transform(stored.pixels.begin(), stored.pixels.end(), bytes_.begin(), [](float value) {
    return static_cast<std::uint8_t>(std::lround(255.0F * value));
  });
}

Image PackedImage::image() const {
  Image image(width_, height_);
  std::transform(bytes_.begin(), bytes_.end(), image.pixels.begin(),
                 [](std::uint8_t value) { return static_cast<float>(value) / 255.0F; });
  return image;
}

std::array<std::uint8_t, 3> PackedImage::at(std::uint32_t x, std::uint32_t y) const {
  const std::uint8_t* const pixel = bytes_.data() + 3 * (std::size_t{width_} * y + x);
  return {pixel[0], pixel[1], pixel[2]};
}

}  // namespace zraka
