// SPDX-License-Identifier: Apache-2.0
// From an image to the caller's memory.
#pragma once

#include <zraka/renderer.hpp>

#include "engine/engine.hpp"

namespace zraka {

/// What is wrong with a buffer for pictures of this size; empty when all is well.
Diagnostics check_buffer(const PixelBuffer& buffer, std::uint32_t width, std::uint32_t height);

/// Writes part of an image into a buffer that check_buffer() finds nothing wrong with; `alpha` has
/// a value a pixel of the image, or is nullptr where all are opaque.
void write_pixels(const Image& image, const TileRect& part, const float* alpha, Transfer transfer,
                  const PixelBuffer& buffer);

}  // namespace zraka
