// SPDX-License-Identifier: Apache-2.0
// The writers of pictures; the list of them is in write_image.cpp.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <zraka/write_image.hpp>

namespace zraka {

/// What every writer gets: a picture with pixels, whose layers, if there are any, are of its size.
struct PictureToWrite {
  const Image& image;
  const Layers& layers;
};

/// A writer puts a picture into a stream. Empty where all went well, else the reason. Its options
/// are those that its PictureFormat allows; bits are never 0.
using WriteFunction = std::string(std::FILE* stream, const PictureToWrite& picture,
                                  const WriteOptions& options);

/// By libpng: RGB, or with alpha RGBA, by all threads.
WriteFunction put_png;
/// By OpenEXRCore: one part of scan lines with all channels, deflated in blocks of 16 lines.
WriteFunction put_exr;
/// P6 of netpbm, in bytes.
WriteFunction put_ppm;
/// Colour PFM, the least byte first.
WriteFunction put_pfm;
/// By libjpeg: YCbCr, a sample of each for every pixel.
WriteFunction put_jpeg;
/// Radiance's RGBE, with runs.
WriteFunction put_hdr;

/// Bytes on their way into a stream; the first problem is the one that is told.
class ByteStream {
 public:
  explicit ByteStream(std::FILE* stream) : stream_(stream) {}

  /// False once there has been a problem.
  bool put(const void* bytes, std::size_t count);
  bool put(std::string_view text) { return put(text.data(), text.size()); }
  /// Whether all is in the file; else what the system says.
  std::string problem();

 private:
  std::FILE* stream_;
  int error_ = 0;
};

}  // namespace zraka
