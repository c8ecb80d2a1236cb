// SPDX-License-Identifier: Apache-2.0
// What columns are called, in all the files that name them.
#include <fmt/format.h>

#include <algorithm>

#include "particles/rows.hpp"

namespace zraka {
namespace {

struct Known {
  RowField field;
  std::string_view names;  ///< in small letters, with spaces around each
};
constexpr Known kKnown[] = {
    {RowField::x, " x xu position_x pos_x posx points:0 points_0 "},
    {RowField::y, " y yu position_y pos_y posy points:1 points_1 "},
    {RowField::z, " z zu position_z pos_z posz points:2 points_2 "},
    {RowField::radius, " radius "},
    {RowField::diameter, " diameter "},
    {RowField::species, " species element type symbol atom name "},
    {RowField::red, " r red color_x colour_x "},
    {RowField::green, " g green color_y colour_y "},
    {RowField::blue, " b blue color_z colour_z "},
    {RowField::shape_x, " shapex c_shape[1] c_diameter[1] "},
    {RowField::shape_y, " shapey c_shape[2] c_diameter[2] "},
    {RowField::shape_z, " shapez c_shape[3] c_diameter[3] "},
    {RowField::turn_w, " quatw c_orient[1] c_quat[1] c_q[1] "},
    {RowField::turn_x, " quati c_orient[2] c_quat[2] c_q[2] "},
    {RowField::turn_y, " quatj c_orient[3] c_quat[3] c_q[3] "},
    {RowField::turn_z, " quatk c_orient[4] c_quat[4] c_q[4] "},
};

RowField field_named(std::string_view name) {
  std::string word = " ";
  for (const char c : name) word += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  word += ' ';
  for (const Known& known : kKnown)
    if (known.names.find(word) != std::string_view::npos) return known.field;
  return RowField::skip;
}

}  // namespace

bool RowLayout::has(RowField field) const {
  return std::any_of(columns.begin(), columns.end(),
                     [&](const RowColumn& column) { return column.field == field; });
}

void RowLayout::add(std::string_view name, const ParticleOptions& options) {
  RowField field = field_named(name);
  if (field != RowField::skip && has(field)) field = RowField::skip;
  if (!options.column.empty() && name == options.column) {
    if (field == RowField::skip)
      field = RowField::value;
    else if (field != RowField::species)
      value_from = field;
  }
  columns.push_back({field, std::string(name)});
}

std::string RowLayout::problem(const ParticleOptions& options) const {
  std::string all;
  for (const RowColumn& column : columns)
    if (all.size() < 200) all += fmt::format("{}{}", all.empty() ? "" : ", ", shown(column.name));
  const auto missing = [&](std::string_view what) {
    return fmt::format("has no column {}: there are {}", what, all.empty() ? "none" : all);
  };
  constexpr RowField kPosition[] = {RowField::x, RowField::y, RowField::z};
  constexpr std::string_view kNames[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i)
    if (!has(kPosition[i])) return missing(kNames[i]);
  if (!options.column.empty() && !has(RowField::value) && value_from == RowField::skip) {
    const bool is_species = std::any_of(columns.begin(), columns.end(), [&](const RowColumn& c) {
      return c.field == RowField::species && c.name == options.column;
    });
    return is_species ? fmt::format(
                            "its column '{}' is a name, not a number: color_by = \"element\" "
                            "colours by it",
                            shown(options.column))
                      : missing("'" + shown(options.column) + "'");
  }
  return "";
}

}  // namespace zraka
