// SPDX-License-Identifier: Apache-2.0
// The fingerprint of a picture, through Nettle.
#include <nettle/base16.h>
#include <nettle/sha2.h>

#include <array>
#include <bit>
#include <cstdint>
#include <zraka/image.hpp>

namespace zraka {

static_assert(std::endian::native == std::endian::little,
              "the fingerprint is of little-endian bytes");

std::string sha256(const Image& image) {
  sha256_ctx context;
  sha256_init(&context);
  const std::array<std::uint32_t, 2> size = {image.width, image.height};
  sha256_update(&context, sizeof(size), reinterpret_cast<const std::uint8_t*>(size.data()));
  sha256_update(&context, image.pixels.size() * sizeof(float),
                reinterpret_cast<const std::uint8_t*>(image.pixels.data()));
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&context, digest.size(), digest.data());
  std::string text(BASE16_ENCODE_LENGTH(SHA256_DIGEST_SIZE), ' ');
  base16_encode_update(text.data(), digest.size(), digest.data());
  return text;
}

}  // namespace zraka
