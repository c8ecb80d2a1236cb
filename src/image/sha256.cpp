// SPDX-License-Identifier: Apache-2.0
// The fingerprint of a picture, through libmd.
#include <sha2.h>

#include <array>
#include <bit>
#include <zraka/image.hpp>

namespace zraka {

static_assert(std::endian::native == std::endian::little,
              "the fingerprint is of little-endian bytes");

std::string sha256(const Image& image) {
  SHA2_CTX context;
  SHA256Init(&context);
  const std::array<std::uint32_t, 2> size = {image.width, image.height};
  SHA256Update(&context, reinterpret_cast<const std::uint8_t*>(size.data()), sizeof(size));
  SHA256Update(&context, reinterpret_cast<const std::uint8_t*>(image.pixels.data()),
               image.pixels.size() * sizeof(float));
  std::array<char, SHA256_DIGEST_STRING_LENGTH> text{};
  SHA256End(&context, text.data());
  return text.data();
}

}  // namespace zraka
