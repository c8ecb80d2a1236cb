// SPDX-License-Identifier: Apache-2.0
#include "language/color.hpp"

#include <charconv>

#include "image/transfer.hpp"

namespace zraka::language {

std::optional<Color> color_of_hex(std::string_view text) {
  if (text.size() != 7 || text.front() != '#') return std::nullopt;
  double rgb[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const char* const begin = text.data() + 1 + 2 * i;
    unsigned value = 0;
    const auto [end, error] = std::from_chars(begin, begin + 2, value, 16);
    if (error != std::errc() || end != begin + 2) return std::nullopt;
    rgb[i] = decode_srgb(value / 255.0);
  }
  return Color{rgb[0], rgb[1], rgb[2]};
}

}  // namespace zraka::language
