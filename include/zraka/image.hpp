// SPDX-License-Identifier: Apache-2.0
// A picture in memory, and its way into a file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>
#include <zraka/diagnostic.hpp>

namespace zraka {

/// Linear RGB floats, row by row from the top, three a pixel.
struct Image {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<float> pixels;

  Image() = default;
  Image(std::uint32_t w, std::uint32_t h)
      : width(w), height(h), pixels(std::size_t{3} * w * h, 0.0f) {}
  float* row(std::uint32_t y) { return pixels.data() + std::size_t{3} * width * y; }
  const float* row(std::uint32_t y) const { return pixels.data() + std::size_t{3} * width * y; }
};

/// How a linear value becomes a stored one: as it is, or by the sRGB curve (IEC 61966-2-1).
enum class Transfer { linear, srgb };

struct PngOptions {
  int bits = 8;  ///< a channel: 8 or 16
  Transfer transfer = Transfer::linear;
};

/// Clamped to 0…1, by the transfer curve, then int(value·max + 0.5) with max 255 or 65535; NaN is
/// 0.
std::uint16_t quantize(float value, Transfer transfer, int bits);

/// Writes a PNG without dates beside `path` and renames it, so that a failure leaves an old file as
/// it was.
Result<void> write_png(const Image& image, const std::string& path, const PngOptions& options = {});

/// Reads an 8 or 16 bit PNG: stored values divided by their maximum, no curve undone.
Result<Image> read_png(const std::string& path);

/// SHA-256, in hexadecimal, of width and height (32 bit) and the pixels' float bits, all
/// little-endian.
std::string sha256(const Image& image);

}  // namespace zraka
