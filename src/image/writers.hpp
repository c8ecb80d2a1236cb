// SPDX-License-Identifier: Apache-2.0
// The writers of pictures; the list of them is in write_image.cpp.
#pragma once

#include <cstdio>
#include <string>
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

/// What the system says of the stream's failure, or that there was none.
std::string stream_problem(std::FILE* stream);

}  // namespace zraka
