// SPDX-License-Identifier: Apache-2.0
#include "image/scene_images.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/in_parallel.hpp"
#include "image/transfer.hpp"

namespace zraka {
namespace {

/// Of 0 to 1; values of 8 bits, which most are, by a table.
class SrgbDecoder {
 public:
  SrgbDecoder() {
    for (std::size_t i = 0; i < 256; ++i) light_[i] = decoded(stored(i));
  }
  float operator()(float value) const {
    const auto i = static_cast<std::size_t>(value * 255 + 0.5f);
    return i < 256 && stored(i) == value ? light_[i] : decoded(value);
  }

 private:
  static float stored(std::size_t i) { return static_cast<float>(i) / 255; }
  static float decoded(float value) {
    return static_cast<float>(decode_srgb(static_cast<double>(value)));
  }
  std::array<float, 256> light_{};
};

}  // namespace

Image linear_image(ReadImage&& read, Transfer transfer) {
  Image image = std::move(read.image);
  if (read.floats || transfer == Transfer::linear) return image;
  const SrgbDecoder decode;
  in_parallel(image.pixels.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) image.pixels[i] = decode(image.pixels[i]);
  });
  return image;
}

Result<std::shared_ptr<const Image>> SceneImages::read(const std::string& path,
                                                       Transfer transfer) const {
  Result<ReadImage> read = read_image(path, max_pixels_);
  if (!read) return tl::make_unexpected(read.error());
  const std::vector<float>& pixels = read->image.pixels;
  for (std::size_t i = 0; read->floats && i < pixels.size(); ++i)
    if (!std::isfinite(pixels[i]))
      return failure(path,
                     fmt::format("pixel ({}, {}) holds {}: a texture needs finite numbers",
                                 i / 3 % read->image.width, i / 3 / read->image.width, pixels[i]));
  return std::make_shared<const Image>(linear_image(std::move(*read), transfer));
}

Result<std::shared_ptr<const Image>> SceneImages::load(const std::string& name, Transfer transfer) {
  const Result<std::string> path = folder_.path_of(name);
  if (!path) return tl::make_unexpected(path.error());
  const auto key = std::make_pair(*path, transfer);
  const auto found = loaded_.find(key);
  if (found != loaded_.end()) return found->second;
  return loaded_.emplace(key, read(*path, transfer)).first->second;
}

}  // namespace zraka
