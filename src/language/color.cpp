// SPDX-License-Identifier: Apache-2.0
#include "language/color.hpp"

#include <fmt/format.h>

#include <charconv>

namespace zraka::language {
namespace {

/// The light of a byte by the sRGB curve (IEC 61966-2-1), of products and quotients alone, so that
/// it is the same on every system. x^2.4 is the twelfth power of x's fifth root, which Newton's
/// steps find from above.
double light_of(unsigned byte) {
  const double encoded = byte / 255.0;
  if (encoded <= 0.04045) return encoded / 12.92;
  const double x = (encoded + 0.055) / 1.055;
  double root = 1;
  for (int step = 0; step < 16; ++step) {
    const double fourth = root * root * root * root;
    root -= (fourth * root - x) / (5 * fourth);
  }
  const double cube = root * root * root;
  return cube * cube * cube * cube;
}

/// What people write first.
constexpr std::pair<std::string_view, std::string_view> kNames[] = {
    {"black", "#000000"},  {"white", "#ffffff"},  {"gray", "#808080"},  {"grey", "#808080"},
    {"red", "#ff0000"},    {"green", "#008000"},  {"blue", "#0000ff"},  {"yellow", "#ffff00"},
    {"orange", "#ffa500"}, {"purple", "#800080"}, {"brown", "#a52a2a"}, {"pink", "#ffc0cb"},
    {"cyan", "#00ffff"},   {"magenta", "#ff00ff"}};

}  // namespace

std::string hint_at_color(std::string_view name) {
  for (const auto& [known, hex] : kNames)
    if (known == name) return fmt::format("{} is \"{}\"", name, hex);
  return "";
}

std::optional<Color> color_of_hex(std::string_view text) {
  if (text.size() != 7 || text.front() != '#') return std::nullopt;
  double rgb[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const char* const begin = text.data() + 1 + 2 * i;
    unsigned value = 0;
    const auto [end, error] = std::from_chars(begin, begin + 2, value, 16);
    if (error != std::errc() || end != begin + 2) return std::nullopt;
    rgb[i] = light_of(value);
  }
  return Color{rgb[0], rgb[1], rgb[2]};
}

}  // namespace zraka::language
