// SPDX-License-Identifier: Apache-2.0
// Compresses a picture as a JPEG was that somebody has sent: what both lose is then the same.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>
#include <zraka/image.hpp>

namespace zraka {

/// How coarsely a JPEG's program has kept its colours.
struct JpegTables {
  std::vector<std::array<std::uint16_t, 64>> steps;  ///< row by row, for each channel
  std::vector<std::array<int, 2>> samples;           ///< of each channel, across and down
};

/// Those of a file of YCbCr; none of another one, or of what is no JPEG.
std::optional<JpegTables> jpeg_tables(std::string_view bytes);

/// As it is read from a JPEG with these tables; as it is where libjpeg does not want it.
Image compressed_again(const Image& image, const JpegTables& tables);

}  // namespace zraka
