// SPDX-License-Identifier: Apache-2.0
// What readers of plain rasters share: numbers with the least byte first, and where pixels go.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "image/readers.hpp"

namespace zraka {

/// The number at `at` of a file that is long enough.
inline std::uint32_t little16(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]) |
         static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + 1])) << 8;
}
inline std::uint32_t little32(std::string_view bytes, std::size_t at) {
  return little16(bytes, at) | little16(bytes, at + 2) << 16;
}

/// Stored values, and how opaque a pixel is: 0 to 1.
struct RasterPixel {
  float r, g, b, alpha = 1;
};

/// Takes a picture's pixels, in any order. Where all that a file says of how opaque they are is 0,
/// it says nothing: many programs leave these bytes empty.
class RasterPicture {
 public:
  RasterPicture(const ImageFile& file, std::uint32_t width, std::uint32_t height, bool has_alpha)
      : file_(file), image_(width, height) {
    if (has_alpha) alpha_.assign(image_.pixels.size() / 3, 0.0f);
  }

  void put(std::uint32_t x, std::uint32_t y, const RasterPixel& pixel) {
    float* const to = image_.row(y) + std::size_t{3} * x;
    to[0] = pixel.r, to[1] = pixel.g, to[2] = pixel.b;
    if (alpha_.empty()) return;
    alpha_[std::size_t{image_.width} * y + x] = pixel.alpha;
    some_ = some_ || pixel.alpha > 0;
    see_through_ = see_through_ || pixel.alpha < 1;
  }

  ReadImage finish(std::string format) {
    ReadImage read;
    read.format = std::move(format);
    read.alpha = some_ && see_through_;
    if (read.alpha && file_.alpha != nullptr)
      *file_.alpha = std::move(alpha_);
    else if (read.alpha)
      for (std::size_t i = 0; i < image_.pixels.size(); ++i) image_.pixels[i] *= alpha_[i / 3];
    read.image = std::move(image_);
    return read;
  }

 private:
  const ImageFile& file_;
  Image image_;
  std::vector<float> alpha_;
  bool some_ = false, see_through_ = false;
};

}  // namespace zraka
