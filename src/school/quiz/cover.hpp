// SPDX-License-Identifier: Apache-2.0
// A pixel that is asked for, marked and covered.
#pragma once

#include <cstdint>
#include <zraka/image.hpp>

namespace zraka {

/// The picture of stored values with a square of greys over the pixel's neighbourhood, so that no
/// neighbour gives its colour away, and a red cross whose middle is the pixel.
Image covered(const Image& stored, std::uint32_t x, std::uint32_t y);

}  // namespace zraka
