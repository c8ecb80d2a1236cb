// SPDX-License-Identifier: Apache-2.0
// Pictures as files of all kinds, written by the libraries themselves, for the readers to read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>
#include <zraka/image.hpp>
#include <zraka/limits.hpp>

namespace zraka {

/// A PNG of rows that are packed as the format wants them.
struct PngKind {
  int color_type = 2;  ///< PNG_COLOR_TYPE_…
  int bits = 8;
  bool interlaced = false;
  std::vector<unsigned char> palette{};       ///< three bytes a colour
  std::vector<unsigned char> transparency{};  ///< alpha of the palette's colours
};
std::string png_file(std::uint32_t width, std::uint32_t height, const PngKind& kind,
                     const std::vector<std::vector<unsigned char>>& rows);

/// A JPEG of bytes with `channels` (1, 3 or 4) a pixel.
struct JpegKind {
  int quality = 90;
  int channels = 3;
  bool progressive = false;
  bool subsampled = false;
  bool many_scans = false;  ///< each coefficient in a scan of its own: 190 for three channels
};
std::string jpeg_file(std::uint32_t width, std::uint32_t height, const JpegKind& kind,
                      const std::vector<unsigned char>& pixels);
/// The picture's values as bytes, then as above.
std::string jpeg_file(const Image& image, int quality);

/// An OpenEXR; value(channel's name, x, y) gives what a channel holds, x and y in the data window.
struct ExrKind {
  std::vector<std::string> channels = {"R", "G", "B"};
  bool half = false;
  bool tiled = false;
  int compression = 3;              ///< Imf::Compression: 0 none, 1 RLE, 2 ZIPS, 3 ZIP, 4 PIZ…
  int display[4] = {0, 0, 15, 11};  ///< left, top, right, bottom, all of them in the window
  int data[4] = {0, 0, 15, 11};
};
using ExrValue = std::function<float(const std::string& channel, int x, int y)>;
std::string exr_file(const ExrKind& kind, const ExrValue& value);
/// A value that is another one in each channel and at most places, exact as a half.
float exr_sample(const std::string& channel, int x, int y);

/// A Radiance picture of four bytes a pixel, as they are or with runs of either kind.
enum class HdrRuns { none, of_pixels, of_bytes };
std::string hdr_file(std::uint32_t width, std::uint32_t height, HdrRuns runs,
                     const std::vector<unsigned char>& pixels,
                     const std::string& header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n");

/// What is wrong with a file called "a" of these bytes, or "read".
std::string error_of(std::string_view bytes, std::uint64_t max_pixels = kMaxPixels);

}  // namespace zraka
