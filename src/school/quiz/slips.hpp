// SPDX-License-Identifier: Apache-2.0
// Colours that come out of a pixel's terms where something slips.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>
#include <zraka/explain.hpp>

#include "core/words.hpp"

namespace zraka {

struct Slip {
  Word what{};
  std::array<std::uint8_t, 3> color{};  ///< as an 8 bit file stores it
};

/// All slips that a pixel of one tree can show, whose first ray hits a shape. `unshadowed` is the
/// same pixel without shadow rays, for what a shadow takes away.
std::vector<Slip> slips_of(const Explanation& explanation,
                           const std::optional<Explanation>& unshadowed);

/// The pixel's colour as an 8 bit file stores it.
std::array<std::uint8_t, 3> stored_color(const Float3& color, Transfer transfer);

}  // namespace zraka
