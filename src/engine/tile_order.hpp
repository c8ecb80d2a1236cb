// SPDX-License-Identifier: Apache-2.0
// The order of a tile's rays, for the engine and for who reads its arrays.
#pragma once

#include <algorithm>

#include "engine/engine.hpp"
#include "math/inline.hpp"

namespace zraka {

/// Squares of 4×4 pixels row by row, so that rays in neighbouring lanes stay together through the
/// scene. Calls function(column, row) for each pixel of the tile.
template <class Function>
ZRAKA_INLINE void each_pixel(const TileRect& tile, const Function& function) {
  constexpr std::int32_t kSide = 4;
  for (std::int32_t top = 0; top < tile.height; top += kSide)
    for (std::int32_t left = 0; left < tile.width; left += kSide) {
      const std::int32_t height = tile.height - top, width = tile.width - left;
      const bool whole = height >= kSide && width >= kSide;
      const auto square = [&](std::int32_t rows, std::int32_t columns) {
        for (std::int32_t y = 0; y < rows; ++y)
          for (std::int32_t x = 0; x < columns; ++x) function(left + x, top + y);
      };
      if (whole)
        square(kSide, kSide);  // which compilers unroll
      else
        square(std::min(height, kSide), std::min(width, kSide));
    }
}

}  // namespace zraka
