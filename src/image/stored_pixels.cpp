// SPDX-License-Identifier: Apache-2.0
#include "image/stored_pixels.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace zraka {
namespace {

constexpr std::size_t kAtOnce = 256;

}  // namespace

StoredPixels::StoredPixels(const Image& image, const float* alpha, const WriteOptions& options)
    : image_(image),
      alpha_(alpha),
      quantizer_(options.transfer, options.bits),
      tone_(options.tone),
      bits_(options.bits),
      bytes_(static_cast<std::size_t>(options.bits / 8) * (alpha == nullptr ? 3 : 4)) {}

void StoredPixels::get(std::uint32_t y, std::size_t x, std::size_t count,
                       unsigned char* out) const {
  if (alpha_ == nullptr && tone_.does_nothing()) {
    quantizer_.row(image_.row(y) + 3 * x, 3 * count, out);
    return;
  }
  for (std::size_t done = 0; done < count; done += kAtOnce)
    get_some(y, x + done, std::min(kAtOnce, count - done), out + done * bytes_);
}

void StoredPixels::get_some(std::uint32_t y, std::size_t x, std::size_t count,
                            unsigned char* out) const {
  std::array<float, 3 * kAtOnce> colors;
  std::copy_n(image_.row(y) + 3 * x, 3 * count, colors.data());
  const float* const alpha =
      alpha_ == nullptr ? nullptr : alpha_ + std::size_t{image_.width} * y + x;
  for (std::size_t i = 0; alpha != nullptr && i < count; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      colors[3 * i + c] = alpha[i] > 0 ? colors[3 * i + c] / alpha[i] : 0.0f;
  tone_.apply(colors.data(), count);
  if (alpha == nullptr) {
    quantizer_.row(colors.data(), 3 * count, out);
    return;
  }
  std::array<unsigned char, 6 * kAtOnce> stored;
  quantizer_.row(colors.data(), 3 * count, stored.data());
  const std::size_t value = bytes_ / 4;
  for (std::size_t i = 0; i < count; ++i, out += bytes_) {
    std::memcpy(out, stored.data() + 3 * value * i, 3 * value);
    const std::uint16_t covered = quantize(alpha[i], Transfer::linear, bits_);
    if (value == 2) out[6] = static_cast<unsigned char>(covered >> 8);
    out[bytes_ - 1] = static_cast<unsigned char>(covered & 0xFF);
  }
}

}  // namespace zraka
