// SPDX-License-Identifier: Apache-2.0
// A picture in memory, its way into a file, and back.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>
#include <zraka/api.hpp>
#include <zraka/diagnostic.hpp>
#include <zraka/limits.hpp>

namespace zraka {

/// RGB floats, row by row from the top, three a pixel: linear light where a picture was rendered,
/// for one that was read see ReadImage.
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
  int threads = 1;  ///< 0: one for each processor; the file is the same from any number
};

/// Clamped to 0…1, by the transfer curve, then int(value·max + 0.5) with max 255 or 65535; NaN is
/// 0.
ZRAKA_API std::uint16_t quantize(float value, Transfer transfer, int bits);

/// Writes a PNG without dates beside `path` and renames it, so that a failure leaves an old file as
/// it was.
ZRAKA_API Result<void> write_png(const Image& image, const std::string& path,
                                 const PngOptions& options = {});

/// The bytes that write_png() writes.
ZRAKA_API Result<std::string> encode_png(const Image& image, const PngOptions& options = {});

/// A picture from a file. Grey is three equal values; transparent pixels are laid over black, which
/// OpenEXR's already are (its colours are multiplied by alpha).
struct ReadImage {
  /// Integers divided by their largest value, no curve undone: nothing in such a file says reliably
  /// whether they went through one. Floats as they are, with their infinities and NaNs.
  Image image;
  /// "PNG", "JPEG", "BMP", "TGA", "PPM", "PGM", "PFM", "Radiance HDR" or "OpenEXR"
  std::string format;
  int bits = 8;         ///< of a stored value: 8 or 16 (fewer count as 8), or those of a float
  bool floats = false;  ///< linear light, not bounded by 1
  bool alpha = false;   ///< a PNG, BMP or TGA with pixels that are not opaque
};

/// Reads a picture that its first bytes, not its name, tell to be a PNG, a JPEG, a BMP, a TGA, a PPM or PGM
/// (text or binary, up to 16 bits), a PFM, a Radiance HDR or an OpenEXR (docs/compare.md). "-" is
/// standard input. Fails where the file is cut off, damaged or of another kind, or has more than
/// `max_pixels` pixels; a file's word about its size is not trusted with memory before it was
/// checked.
ZRAKA_API Result<ReadImage> read_image(const std::string& path,
                                       std::uint64_t max_pixels = kMaxPixels);

/// The same for a file in memory; `name` is for the messages.
ZRAKA_API Result<ReadImage> parse_image(std::string_view bytes, const std::string& name,
                                        std::uint64_t max_pixels = kMaxPixels);

/// SHA-256, in hexadecimal, of width and height (32 bit) and the pixels' float bits, all
/// little-endian.
ZRAKA_API std::string sha256(const Image& image);

}  // namespace zraka
