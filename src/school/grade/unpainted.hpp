// SPDX-License-Identifier: Apache-2.0
// A JPEG of a picture whose program left rows and columns unpainted on a scaled screen: without
// them it is the picture that was drawn, pixel by pixel.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>
#include <zraka/image.hpp>

#include "image/jpeg_again.hpp"

namespace zraka {

struct UnpaintedLines {
  Image handed_in;                           ///< with them
  std::vector<std::uint32_t> columns, rows;  ///< those that were painted
  std::array<float, 3> color{};              ///< of the others

  /// A picture of the same size without the lines that were not painted.
  Image painted(const Image& image) const;
  /// The other way: what was handed in, where a box of its painted pixels shows others.
  Image unpainted(const Image& painted, std::uint32_t left, std::uint32_t top, std::uint32_t right,
                  std::uint32_t bottom) const;
};

/// Those of a picture that was compressed with the tables; none where no lines lie as regularly as
/// such a program leaves them. A JPEG mixes their colour with those beside them, so that they can
/// be told by where they lie only.
std::optional<UnpaintedLines> find_unpainted(const Image& image, const JpegTables& tables);

}  // namespace zraka
