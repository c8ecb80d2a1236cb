// SPDX-License-Identifier: Apache-2.0
#include "particles/color_map.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

namespace zraka {
namespace {

// The maps of Smith and van der Walt ("A better default colormap for Matplotlib", 2015) at tenths
// from end to end, and straight lines between: nowhere further off than eyes can tell.
constexpr std::uint32_t kViridis[] = {0x440154, 0x482878, 0x3E4A89, 0x31688E, 0x26828E,
                                      0x1F9E89, 0x35B779, 0x6DCD59, 0xB4DE2C, 0xFDE725};
constexpr std::uint32_t kPlasma[] = {0x0D0887, 0x47039F, 0x7301A8, 0x9C179E, 0xBD3786,
                                     0xD8576B, 0xED7953, 0xFA9E3B, 0xFDC926, 0xF0F921};
constexpr std::uint32_t kInferno[] = {0x000004, 0x1B0C42, 0x4B0C6B, 0x781C6D, 0xA52C60,
                                      0xCF4446, 0xED6925, 0xFB9A06, 0xF7D03C, 0xFCFFA4};
constexpr std::uint32_t kMagma[] = {0x000004, 0x180F3E, 0x451077, 0x721F81, 0x9F2F7F,
                                    0xCD4071, 0xF1605D, 0xFD9567, 0xFEC98D, 0xFCFDBF};
// By the formula of Moreland, "Diverging Color Maps for Scientific Visualization" (2009), from
// (59, 76, 192) to (180, 4, 38).
constexpr std::uint32_t kCoolWarm[] = {0x3B4CC0, 0x4E68D7, 0x6282EA, 0x779AF7, 0x8DB0FE, 0xA3C2FF,
                                       0xB8D0F9, 0xCCD9EE, 0xDDDDDD, 0xECD3C6, 0xF5C4AD, 0xF7B194,
                                       0xF49A7B, 0xEC7F63, 0xDE614C, 0xCB3E38, 0xB40426};
constexpr std::uint32_t kGrey[] = {0x000000, 0xFFFFFF};

std::span<const std::uint32_t> stops_of(ColorMap map) {
  switch (map) {
    case ColorMap::viridis:
      return kViridis;
    case ColorMap::plasma:
      return kPlasma;
    case ColorMap::inferno:
      return kInferno;
    case ColorMap::magma:
      return kMagma;
    case ColorMap::coolwarm:
      return kCoolWarm;
    case ColorMap::grey:
      break;
  }
  return kGrey;
}

}  // namespace

std::uint32_t color_at(ColorMap map, double t) {
  const std::span<const std::uint32_t> stops = stops_of(map);
  const double at = std::clamp(t, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double part = at - static_cast<double>(i);
  std::uint32_t color = 0;
  for (const int shift : {16, 8, 0}) {
    const double from = (stops[i] >> shift) & 255, to = (stops[i + 1] >> shift) & 255;
    color |= static_cast<std::uint32_t>(from + part * (to - from) + 0.5) << shift;
  }
  return color;
}

std::uint32_t color_of_kind(std::size_t kind) {
  constexpr std::uint32_t kColors[] = {0x0072B2, 0xE69F00, 0x009E73, 0xCC79A7,
                                       0x56B4E9, 0xD55E00, 0xF0E442, 0x999999};
  return kColors[kind % std::size(kColors)];
}

}  // namespace zraka
