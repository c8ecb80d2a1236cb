// SPDX-License-Identifier: Apache-2.0
// Pictures side by side on one sheet, and the differences between them.
#pragma once

#include <string>
#include <vector>
#include <zraka/image.hpp>

namespace zraka::app {

struct Captioned {
  const Image* image;
  std::string caption;
};

/// |a - b|·gain for each component, both clamped to 0…1 first. The gain makes the largest
/// difference white, but is at most kMostGain, so that rounding does not look like a difference.
/// The pictures have the same size.
struct Difference {
  Image image;
  double gain = 1;
  std::uint64_t pixels = 0;  ///< that differ in files of 8 bits, written through `transfer`
};
inline constexpr double kMostGain = 16;
Difference difference(const Image& a, const Image& b, Transfer transfer);

/// Rows of pictures of the same size, reduced to at most `side` pixels, with captions where a font
/// is there.
Image contact_sheet(const std::vector<std::vector<Captioned>>& rows, std::uint32_t side);

}  // namespace zraka::app
