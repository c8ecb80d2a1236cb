// SPDX-License-Identifier: Apache-2.0
// BMP as Windows writes it (its BITMAPFILEHEADER and what follows): 1, 4 and 8 bits a pixel with a
// palette, 16, 24 and 32 bits; not packed.
#include <bit>

#include "core/phrase.hpp"
#include "image/raster.hpp"

namespace zraka {
namespace {

constexpr std::size_t kFileHeader = 14, kCoreHeader = 12, kInfoHeader = 40;

/// Which bits of a pixel are a channel.
struct BmpChannel {
  std::uint32_t mask = 0;
  float of(std::uint32_t pixel) const {
    if (mask == 0) return 0;
    const int shift = std::countr_zero(mask);
    return static_cast<float>((pixel & mask) >> shift) / static_cast<float>(mask >> shift);
  }
};

struct BmpHeader {
  std::uint32_t width = 0, height = 0, bits = 0, encoding = 0;
  bool from_top = false;
  std::size_t pixels_at = 0, palette_at = 0, palette_entry = 4;
  BmpChannel r, g, b, alpha;
};

tl::unexpected<Diagnostics> ends_early(const ImageFile& file) {
  return failure(file.name, phrase(Word::image_no_header, "BMP"));
}

void find_bmp_channels(const ImageFile& file, std::size_t header, BmpHeader& bmp) {
  constexpr std::uint32_t kMasks = 3;  // the encoding that has them in the file
  constexpr std::size_t kWithAlpha = 56;
  if (bmp.bits == 16) bmp.r = {0x7C00}, bmp.g = {0x03E0}, bmp.b = {0x001F};
  if (bmp.bits >= 24) bmp.r = {0xFF0000}, bmp.g = {0x00FF00}, bmp.b = {0x0000FF};
  if (bmp.encoding != kMasks) return;
  const std::size_t at = kFileHeader + kInfoHeader;
  bmp.r = {little32(file.bytes, at)}, bmp.g = {little32(file.bytes, at + 4)};
  bmp.b = {little32(file.bytes, at + 8)};
  if (header >= kWithAlpha) bmp.alpha = {little32(file.bytes, at + 12)};
}

Result<BmpHeader> read_bmp_header(const ImageFile& file) {
  const std::string_view bytes = file.bytes;
  if (bytes.size() < kFileHeader + kCoreHeader) return ends_early(file);
  const std::uint32_t header = little32(bytes, kFileHeader);
  if (header != kCoreHeader && header < kInfoHeader) return ends_early(file);
  if (bytes.size() < kFileHeader + std::size_t{header}) return ends_early(file);
  BmpHeader bmp;
  bmp.pixels_at = little32(bytes, 10);
  bmp.palette_at = kFileHeader + header;
  if (header == kCoreHeader) {
    bmp.width = little16(bytes, 18), bmp.height = little16(bytes, 20);
    bmp.bits = little16(bytes, 24);
    bmp.palette_entry = 3;
  } else {
    bmp.width = little32(bytes, 18), bmp.height = little32(bytes, 22);
    bmp.bits = little16(bytes, 28);
    bmp.encoding = little32(bytes, 30);
    bmp.from_top = (bmp.height & 0x80000000u) != 0;
    if (bmp.from_top) bmp.height = 0u - bmp.height;
  }
  const bool masks = bmp.encoding == 3 && (bmp.bits == 16 || bmp.bits == 32);
  const bool plain = bmp.encoding == 0 && (bmp.bits == 1 || bmp.bits == 4 || bmp.bits == 8 ||
                                           bmp.bits == 16 || bmp.bits == 24 || bmp.bits == 32);
  if (!masks && !plain)
    return failure(file.name, phrase(Word::image_bmp_encoding, bmp.bits, bmp.encoding),
                   phrase(Word::image_save_as, phrase(Word::image_readable)));
  if (masks && bytes.size() < kFileHeader + kInfoHeader + 16) return ends_early(file);
  if (const Result<void> fits = file.check_size(bmp.width, bmp.height); !fits)
    return tl::make_unexpected(fits.error());
  find_bmp_channels(file, header, bmp);
  return bmp;
}

/// A pixel by its number in the palette, black where the file has no such entry.
RasterPixel from_palette(const ImageFile& file, const BmpHeader& bmp, std::uint32_t number) {
  const std::size_t at = bmp.palette_at + number * bmp.palette_entry;
  if (at + 3 > std::min<std::size_t>(bmp.pixels_at, file.bytes.size())) return {0, 0, 0};
  const auto value = [&](std::size_t k) {
    return static_cast<float>(static_cast<unsigned char>(file.bytes[at + k])) / 255.0f;
  };
  return {value(2), value(1), value(0)};
}

/// Pixel x of a row.
RasterPixel pixel_of(const ImageFile& file, const BmpHeader& bmp, std::string_view row,
                     std::uint32_t x) {
  const std::uint64_t bit = std::uint64_t{x} * bmp.bits;
  const std::size_t at = bit / 8;
  const auto byte = [&](std::size_t k) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(row[at + k]));
  };
  if (bmp.bits <= 8)
    return from_palette(file, bmp, byte(0) >> (8 - bmp.bits - bit % 8) & ((1u << bmp.bits) - 1));
  std::uint32_t pixel = 0;
  for (std::uint32_t k = 0; k < bmp.bits / 8; ++k) pixel |= byte(k) << 8 * k;
  return {bmp.r.of(pixel), bmp.g.of(pixel), bmp.b.of(pixel), bmp.alpha.of(pixel)};
}

}  // namespace

Result<ReadImage> parse_bmp(const ImageFile& file) {
  const Result<BmpHeader> header = read_bmp_header(file);
  if (!header) return tl::make_unexpected(header.error());
  const BmpHeader& bmp = *header;
  const std::uint64_t row = (std::uint64_t{bmp.width} * bmp.bits + 31) / 32 * 4;
  if (bmp.pixels_at > file.bytes.size() || file.bytes.size() - bmp.pixels_at < row * bmp.height)
    return failure(file.name,
                   phrase(Word::image_cut_off, file.bytes.size(), bmp.width, bmp.height));
  RasterPicture picture(file, bmp.width, bmp.height, bmp.alpha.mask != 0);
  for (std::uint32_t y = 0; y < bmp.height; ++y) {
    const std::string_view in = file.bytes.substr(bmp.pixels_at + row * y, row);
    const std::uint32_t to = bmp.from_top ? y : bmp.height - 1 - y;
    for (std::uint32_t x = 0; x < bmp.width; ++x) picture.put(x, to, pixel_of(file, bmp, in, x));
  }
  return picture.finish("BMP");
}

}  // namespace zraka
