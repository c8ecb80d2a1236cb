// SPDX-License-Identifier: Apache-2.0
#include "render/pixel_buffer.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <utility>

namespace zraka {
namespace {

std::ptrdiff_t bytes_of(const PixelBuffer& buffer) {
  return buffer.channels * (buffer.type == PixelBuffer::Type::float32 ? 4 : 1);
}

/// With strides that are said, not 0.
PixelBuffer with_strides(PixelBuffer buffer, std::uint32_t width) {
  if (buffer.pixel_stride == 0) buffer.pixel_stride = bytes_of(buffer);
  if (buffer.row_stride == 0) buffer.row_stride = buffer.pixel_stride * std::ptrdiff_t{width};
  return buffer;
}

}  // namespace

Diagnostics check_buffer(const PixelBuffer& given, std::uint32_t width, std::uint32_t height) {
  Diagnostics found;
  const auto complain = [&](std::string message, std::string hint) {
    found.push_back({.message = std::move(message), .hint = std::move(hint)});
  };
  if (given.data == nullptr) complain("the buffer has no memory", "its data is a null pointer");
  if (given.channels != 3 && given.channels != 4) {
    complain(fmt::format("{} channels: expected 3 (RGB) or 4 (RGBA)", given.channels), "");
    return found;
  }
  const PixelBuffer buffer = with_strides(given, width);
  if (std::abs(buffer.pixel_stride) < bytes_of(buffer))
    complain(fmt::format("a pixel stride of {} bytes: a pixel has {}", buffer.pixel_stride,
                         bytes_of(buffer)),
             "strides are in bytes; 0 means no gaps");
  // Rows may interleave, as those of a picture that lies on its side, but no two pixels overlap.
  else if (height > 1 && width > 1 &&
           std::abs(buffer.row_stride) < std::abs(buffer.pixel_stride) * std::ptrdiff_t{width} &&
           std::abs(buffer.pixel_stride) < std::abs(buffer.row_stride) * std::ptrdiff_t{height})
    complain(fmt::format("a row stride of {} bytes: a row has {}", buffer.row_stride,
                         std::abs(buffer.pixel_stride) * std::ptrdiff_t{width}),
             "strides are in bytes; 0 means no gaps");
  else if (height > 1 && std::abs(buffer.row_stride) < bytes_of(buffer))
    complain(fmt::format("a row stride of {} bytes: a pixel has {}", buffer.row_stride,
                         bytes_of(buffer)),
             "strides are in bytes; 0 means no gaps");
  return found;
}

void write_pixels(const Image& image, const TileRect& part, const float* alpha, Transfer transfer,
                  const PixelBuffer& given) {
  const PixelBuffer buffer = with_strides(given, image.width);
  for (std::int32_t y = part.y; y < part.y + part.height; ++y) {
    const float* color = image.row(static_cast<std::uint32_t>(y)) + std::ptrdiff_t{3} * part.x;
    auto* pixel = static_cast<unsigned char*>(buffer.data) + y * buffer.row_stride +
                  part.x * buffer.pixel_stride;
    for (std::int32_t x = part.x; x < part.x + part.width;
         ++x, color += 3, pixel += buffer.pixel_stride) {
      const float opacity = alpha == nullptr
                                ? 1.0f
                                : alpha[std::size_t{image.width} * static_cast<std::size_t>(y) +
                                        static_cast<std::size_t>(x)];
      const float values[4] = {color[0], color[1], color[2], opacity};
      if (buffer.type == PixelBuffer::Type::float32) {
        std::memcpy(pixel, values, static_cast<std::size_t>(bytes_of(buffer)));
        continue;
      }
      for (int c = 0; c < buffer.channels; ++c)
        pixel[c] =
            static_cast<unsigned char>(quantize(values[c], c < 3 ? transfer : Transfer::linear, 8));
    }
  }
}

}  // namespace zraka
