// SPDX-License-Identifier: Apache-2.0
// Which pair of dimensions of a pixel's samples is for what.
#pragma once

#include "sampling/sobol.hpp"

namespace zraka {

enum DimensionPair : std::uint32_t {
  kPixelPair,     ///< where in the pixel
  kLensPair,      ///< where on the lens
  kFirstFreePair  ///< from here on what happens in the scene
};

/// A sample's point in a pair of dimensions.
constexpr Point2 sample_point(std::uint32_t seed, std::int32_t x, std::int32_t y,
                              std::uint32_t number, std::uint32_t pair) {
  return sobol_2d(number, hash(seed, x, y, pair));
}

}  // namespace zraka
