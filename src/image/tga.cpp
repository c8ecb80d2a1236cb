// SPDX-License-Identifier: Apache-2.0
// TGA as Truevision has it (its File Format Specification 2.0): grey, 15, 16, 24 and 32 bits, or by
// a colour map of these; plain or in runs; from any corner.
#include "core/phrase.hpp"
#include "image/raster.hpp"

namespace zraka {
namespace {

constexpr std::size_t kHeader = 18;
enum TgaKind : std::uint32_t { kMapped = 1, kColors = 2, kGrey = 3, kRuns = 8 };

struct TgaHeader {
  std::uint32_t kind, width, height, bits, map_first, map_size, map_bits, corner, alpha_bits;
  bool runs;
  std::size_t map_at, pixels_at;
};

TgaHeader header_of(std::string_view bytes) {
  const auto byte = [&](std::size_t at) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at]));
  };
  TgaHeader tga{};
  tga.runs = (byte(2) & kRuns) != 0;
  tga.kind = byte(2) & ~std::uint32_t{kRuns};
  const bool has_map = byte(1) == 1;
  tga.map_first = little16(bytes, 3);
  tga.map_size = has_map ? little16(bytes, 5) : 0;
  tga.map_bits = byte(7);
  tga.width = little16(bytes, 12), tga.height = little16(bytes, 14), tga.bits = byte(16);
  tga.corner = byte(17) >> 4 & 3, tga.alpha_bits = byte(17) & 15;
  tga.map_at = kHeader + byte(0);
  tga.pixels_at = tga.map_at + std::size_t{tga.map_size} * ((tga.map_bits + 7) / 8);
  return tga;
}

bool holds_color(std::uint32_t bits) {
  return bits == 15 || bits == 16 || bits == 24 || bits == 32;
}

/// A colour of so many bits.
RasterPixel color_at(std::string_view bytes, std::size_t at, std::uint32_t bits) {
  const auto value = [&](std::size_t k) {
    return static_cast<float>(static_cast<unsigned char>(bytes[at + k])) / 255.0f;
  };
  if (bits >= 24) return {value(2), value(1), value(0), bits == 32 ? value(3) : 1.0f};
  const std::uint32_t pixel = little16(bytes, at);
  const auto five = [&](int shift) { return static_cast<float>(pixel >> shift & 31) / 31.0f; };
  return {five(10), five(5), five(0), (pixel & 0x8000) != 0 ? 1.0f : 0.0f};
}

RasterPixel pixel_at(const ImageFile& file, const TgaHeader& tga, std::size_t at) {
  if (tga.kind == kColors) return color_at(file.bytes, at, tga.bits);
  const auto number = static_cast<unsigned char>(file.bytes[at]);
  if (tga.kind == kGrey) {
    const float grey = static_cast<float>(number) / 255.0f;
    return {grey, grey, grey};
  }
  if (number < tga.map_first || number - tga.map_first >= tga.map_size) return {0, 0, 0};
  return color_at(file.bytes, tga.map_at + (number - tga.map_first) * ((tga.map_bits + 7) / 8),
                  tga.map_bits);
}

/// Puts pixels where they belong, in the order of the file.
class TgaPicture {
 public:
  TgaPicture(const ImageFile& file, const TgaHeader& tga)
      : tga_(tga),
        picture_(file, tga.width, tga.height,
                 tga.alpha_bits > 0 && (tga.kind == kMapped ? tga.map_bits : tga.bits) != 24) {}

  bool is_full() const { return count_ == std::uint64_t{tga_.width} * tga_.height; }
  void put(const RasterPixel& pixel) {
    const auto x = static_cast<std::uint32_t>(count_ % tga_.width);
    const auto y = static_cast<std::uint32_t>(count_ / tga_.width);
    ++count_;
    picture_.put((tga_.corner & 1) != 0 ? tga_.width - 1 - x : x,
                 (tga_.corner & 2) != 0 ? y : tga_.height - 1 - y, pixel);
  }
  ReadImage finish() { return picture_.finish("TGA"); }

 private:
  const TgaHeader& tga_;
  RasterPicture picture_;
  std::uint64_t count_ = 0;
};

/// Runs of one pixel, and of several as they are.
bool read_runs(const ImageFile& file, const TgaHeader& tga, TgaPicture& picture) {
  const std::size_t size = (tga.bits + 7) / 8;
  std::size_t at = tga.pixels_at;
  while (!picture.is_full()) {
    if (at >= file.bytes.size()) return false;
    const auto packet = static_cast<unsigned char>(file.bytes[at++]);
    const std::size_t count = (packet & 127u) + 1, stored = packet >= 128 ? 1 : count;
    if (file.bytes.size() - at < stored * size) return false;
    for (std::size_t i = 0; i < count && !picture.is_full(); ++i)
      picture.put(pixel_at(file, tga, at + (stored == 1 ? 0 : i * size)));
    at += stored * size;
  }
  return true;
}

bool read_plain(const ImageFile& file, const TgaHeader& tga, TgaPicture& picture) {
  const std::size_t size = (tga.bits + 7) / 8;
  const std::uint64_t pixels = std::uint64_t{tga.width} * tga.height;
  if (file.bytes.size() < tga.pixels_at || (file.bytes.size() - tga.pixels_at) / size < pixels)
    return false;
  for (std::size_t i = 0; i < pixels; ++i)
    picture.put(pixel_at(file, tga, tga.pixels_at + i * size));
  return true;
}

}  // namespace

bool is_tga(std::string_view bytes) {
  if (bytes.size() < kHeader || static_cast<unsigned char>(bytes[1]) > 1) return false;
  const TgaHeader tga = header_of(bytes);
  const bool known = (static_cast<unsigned char>(bytes[2]) & ~11u) == 0 && tga.kind >= kMapped &&
                     tga.kind <= kGrey && (static_cast<unsigned char>(bytes[17]) & 0xC0) == 0;
  if (!known || tga.width == 0 || tga.height == 0) return false;
  if (tga.kind == kColors) return holds_color(tga.bits);
  if (tga.kind == kMapped) return tga.bits == 8 && tga.map_size > 0 && holds_color(tga.map_bits);
  return tga.bits == 8;
}

Result<ReadImage> parse_tga(const ImageFile& file) {
  const TgaHeader tga = header_of(file.bytes);
  if (const Result<void> fits = file.check_size(tga.width, tga.height); !fits)
    return tl::make_unexpected(fits.error());
  const auto cut_off = [&] {
    return failure(file.name,
                   phrase(Word::image_cut_off, file.bytes.size(), tga.width, tga.height));
  };
  // A run stands for 128 pixels at most: memory is taken only for what the file can hold.
  const std::uint64_t pixels = std::uint64_t{tga.width} * tga.height;
  const std::size_t size = file.bytes.size();
  if (tga.pixels_at > size || pixels / 128 > size - tga.pixels_at) return cut_off();
  TgaPicture picture(file, tga);
  if (!(tga.runs ? read_runs(file, tga, picture) : read_plain(file, tga, picture)))
    return cut_off();
  return picture.finish();
}

}  // namespace zraka
