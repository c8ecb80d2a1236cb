// SPDX-License-Identifier: Apache-2.0
#include "mesh/mtl.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/take_word.hpp"
#include "core/text.hpp"

namespace zraka {
namespace {

std::optional<double> take_number(std::string_view& line) {
  const std::optional<double> value = parse_number(take_word(line));
  return value && std::isfinite(*value) ? value : std::nullopt;
}

/// One number is grey; spectra are passed over.
void take_color(std::string_view line, Color& color) {
  const std::optional<double> r = take_number(line);
  if (!r) return;
  const std::optional<double> g = take_number(line), b = take_number(line);
  const auto good = [](double value) { return std::max(value, 0.0); };
  color = {good(*r), good(g.value_or(*r)), good(b.value_or(*r))};
}

void take_value(std::string_view line, double least, double most, double& value) {
  if (const std::optional<double> number = take_number(line))
    value = std::clamp(*number, least, most);
}

/// The name behind options like -s 1 1 1.
std::string picture_of(std::string_view line) {
  line = trimmed(line);
  if (line.starts_with('-')) {
    const std::size_t space = line.find_last_of(" \t");
    if (space == std::string_view::npos) return {};
    line.remove_prefix(space + 1);
  }
  std::string name(line);
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

void read_line(std::string_view keyword, std::string_view rest, MtlMaterial& m) {
  constexpr double kLarge = 1e6;
  double number = 0;
  if (keyword == "Kd") take_color(rest, m.diffuse);
  if (keyword == "Ks") take_color(rest, m.specular);
  if (keyword == "Ke") take_color(rest, m.emission);
  if (keyword == "Ns") take_value(rest, 0, kLarge, m.shininess);
  if (keyword == "Ni") take_value(rest, 1, 10, m.ior);
  if (keyword == "d" && !trimmed(rest).starts_with("-")) take_value(rest, 0, 1, m.opacity);
  if (keyword == "Tr") {
    take_value(rest, 0, 1, number);
    m.opacity = 1 - number;
  }
  if (keyword == "illum") {
    take_value(rest, 0, 10, number);
    m.illumination = static_cast<int>(number);
  }
  if (keyword == "map_Kd") m.diffuse_map = picture_of(rest);
}

}  // namespace

std::vector<MtlMaterial> parse_mtl(std::string_view text) {
  std::vector<MtlMaterial> all;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::string_view keyword = take_word(line);
    if (keyword == "newmtl")
      all.push_back({.name = std::string(trimmed(line))});
    else if (!all.empty() && !keyword.starts_with('#'))
      read_line(keyword, line, all.back());
  }
  return all;
}

}  // namespace zraka
