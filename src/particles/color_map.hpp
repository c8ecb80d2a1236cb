// SPDX-License-Identifier: Apache-2.0
// Colours for numbers.
#pragma once

#include <cstdint>
#include <string_view>

namespace zraka {

/// In the order of kColorMapNames.
enum class ColorMap : std::uint8_t { viridis, plasma, inferno, magma, coolwarm, grey };
inline constexpr std::string_view kColorMapNames[] = {"viridis", "plasma",   "inferno",
                                                      "magma",   "coolwarm", "grey"};

/// Its colour at `t` of 0…1, sRGB as 0xRRGGBB.
std::uint32_t color_at(ColorMap map, double t);

/// Colours for things of different kinds that have none of their own: Okabe and Ito's, "Color
/// Universal Design" (2008), which people see apart who see red and green alike.
std::uint32_t color_of_kind(std::size_t kind);

}  // namespace zraka
