// SPDX-License-Identifier: Apache-2.0
// PPM and PFM (netpbm's manuals ppm(5) and pfm(5)).
#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <vector>

#include "image/stored_pixels.hpp"
#include "image/writers.hpp"

namespace zraka {

std::string put_ppm(std::FILE* stream, const PictureToWrite& picture, const WriteOptions& options) {
  const Image& image = picture.image;
  const StoredPixels pixels(image, nullptr, options);
  ByteStream out(stream);
  out.put(
      fmt::format("P6\n{} {}\n{}\n", image.width, image.height, options.bits == 16 ? 65535 : 255));
  std::vector<unsigned char> row(pixels.bytes() * image.width);
  for (std::uint32_t y = 0; y < image.height; ++y) {
    pixels.get(y, 0, image.width, row.data());
    if (!out.put(row.data(), row.size())) break;
  }
  return out.problem();
}

std::string put_pfm(std::FILE* stream, const PictureToWrite& picture, const WriteOptions&) {
  const Image& image = picture.image;
  ByteStream out(stream);
  out.put(
      fmt::format("PF\n{} {}\n-1.0\n", image.width, image.height));  // below 0: least byte first
  std::vector<std::uint32_t> row(std::size_t{3} * image.width);
  for (std::uint32_t y = image.height; y-- > 0;) {  // from the bottom
    std::memcpy(row.data(), image.row(y), row.size() * sizeof(float));
    if constexpr (std::endian::native == std::endian::big)
      for (std::uint32_t& bits : row) bits = __builtin_bswap32(bits);
    if (!out.put(row.data(), row.size() * sizeof(float))) break;
  }
  return out.problem();
}

}  // namespace zraka
