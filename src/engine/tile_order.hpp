// SPDX-License-Identifier: Apache-2.0
// The order of a tile's rays, for the engine and for who reads its arrays.
#pragma once

#include "engine/engine.hpp"
#include "math/inline.hpp"

namespace zraka {

/// Squares of 4×4 pixels row by row, so that rays in neighbouring lanes stay together through the
/// scene. Calls function(column, row) for each pixel of the tile.
template <class Function>
ZRAKA_INLINE void each_pixel(const TileRect& tile, const Function& function) {
  constexpr std::int32_t kSide = 4;
  for (std::int32_t top = 0; top < tile.height; top += kSide)
    for (std::int32_t left = 0; left < tile.width; left += kSide)
      for (std::int32_t y = top; y < tile.height && y < top + kSide; ++y)
        for (std::int32_t x = left; x < tile.width && x < left + kSide; ++x) function(x, y);
}

}  // namespace zraka
