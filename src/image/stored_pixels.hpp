// SPDX-License-Identifier: Apache-2.0
// A picture's pixels as files of integers hold them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <zraka/write_image.hpp>

#include "image/quantize.hpp"
#include "image/tone_map.hpp"

namespace zraka {

/// Colours divided by alpha, tone-mapped and quantized. May be asked by several threads at once.
class StoredPixels {
 public:
  /// `alpha` is one value a pixel, which every pixel gets as a fourth one; nullptr: there are
  /// three.
  StoredPixels(const Image& image, const float* alpha, const WriteOptions& options);

  /// Of a pixel: at most 8.
  std::size_t bytes() const { return bytes_; }
  /// The pixels [x, x + count) of row y, two bytes a value (high byte first) for 16 bits.
  void get(std::uint32_t y, std::size_t x, std::size_t count, unsigned char* out) const;

 private:
  void get_some(std::uint32_t y, std::size_t x, std::size_t count, unsigned char* out) const;

  const Image& image_;
  const float* alpha_;
  RowQuantizer quantizer_;
  ToneMapper tone_;
  int bits_;
  std::size_t bytes_;
};

}  // namespace zraka
