// SPDX-License-Identifier: Apache-2.0
// Pictures and planes of numbers brought from one grid of pixels to another.
#pragma once

#include <cstdint>
#include <vector>
#include <zraka/image.hpp>

namespace zraka {

/// A grid of numbers.
struct Grid {
  std::uint32_t width = 0, height = 0;
  std::vector<float> values;
  Grid() = default;
  Grid(std::uint32_t w, std::uint32_t h) : width(w), height(h), values(std::size_t{w} * h) {}
  const float* row(std::uint32_t y) const { return values.data() + std::size_t{y} * width; }
  float* row(std::uint32_t y) { return values.data() + std::size_t{y} * width; }
};

/// Where a grid lies in another: x of the one, in pixels from its left edge, is left + x·across of
/// the other.
struct GridPlacement {
  double left = 0, top = 0, across = 1, down = 1;
  friend bool operator==(const GridPlacement&, const GridPlacement&) = default;
};

/// The inverse: where the other lies in the one.
GridPlacement inverse(const GridPlacement& placement);

/// A picture of width × height that lies in `image` as told: each pixel is the mean over its area
/// there, or over one pixel's where it covers less, which is bilinear interpolation. What lies
/// outside has the colour of the edge.
Image resampled(const Image& image, const GridPlacement& placement, std::uint32_t width,
                std::uint32_t height);
/// The same by the pixels that lie nearest.
Image repeated(const Image& image, const GridPlacement& placement, std::uint32_t width,
               std::uint32_t height);
Grid resampled(const Grid& grid, const GridPlacement& placement, std::uint32_t width,
               std::uint32_t height);

/// Columns and rows change places.
Image transposed(const Image& image);
Grid transposed(const Grid& grid);
Grid upside_down(const Grid& grid);

/// Fills rows and columns that a program left unpainted, which draws pixel by pixel on a scaled
/// screen: lines of one colour, a pixel wide, whose neighbours on both sides have others. Returns
/// whether there were any.
bool fill_unpainted(Image& image, bool jpeg);

}  // namespace zraka
