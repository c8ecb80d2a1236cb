// SPDX-License-Identifier: Apache-2.0
// The readers of pictures; the list of them is in read_image.cpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>
#include <zraka/image.hpp>

namespace zraka {

/// What every reader gets: a whole file whose first bytes are of its kind.
struct ImageFile {
  std::string_view bytes;
  const std::string& name;
  std::uint64_t max_pixels;
  /// nullptr: transparent pixels are laid over black; else they keep their colours, and this gets
  /// how opaque each is, where the file says so.
  std::vector<float>* alpha = nullptr;

  /// Fails where a size is 0 or has too many pixels; to be asked before memory is taken.
  Result<void> check_size(std::uint64_t width, std::uint64_t height) const;
};

/// parse_image() that keeps the colours of transparent pixels: `alpha` gets how opaque each is, and
/// stays empty where all are.
Result<ReadImage> parse_image_with_alpha(std::string_view bytes, const std::string& name,
                                         std::uint64_t max_pixels, std::vector<float>& alpha);

/// By libpng. Corrections of gamma, profiles and text in the file are passed over.
Result<ReadImage> parse_png(const ImageFile& file);
/// By libjpeg: grey and YCbCr or RGB; a damaged file is an error, not a picture with grey in it.
Result<ReadImage> parse_jpeg(const ImageFile& file);
/// P2, P3, P5 and P6 of netpbm: the first picture of the file.
Result<ReadImage> parse_pnm(const ImageFile& file);
/// PFM, colour (PF) and grey (Pf).
Result<ReadImage> parse_pfm(const ImageFile& file);
/// Radiance's RGBE, in any order of lines, with runs of either kind or none; an exposure that the
/// header notes is not undone.
Result<ReadImage> parse_hdr(const ImageFile& file);
/// BMP, not packed; how opaque pixels are only where its masks say so.
Result<ReadImage> parse_bmp(const ImageFile& file);
/// TGA, which has no first bytes of its own: is_tga() says whether a file's first ones can be a
/// header, which few other files' can.
bool is_tga(std::string_view bytes);
Result<ReadImage> parse_tga(const ImageFile& file);
/// By OpenEXRCore: one part of scan lines or tiles with R, G and B, or Y alone; the display window,
/// black where the file has no pixels.
Result<ReadImage> parse_exr(const ImageFile& file);

}  // namespace zraka
