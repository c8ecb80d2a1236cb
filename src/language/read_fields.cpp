// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "language/color.hpp"
#include "language/fields.hpp"

namespace zraka::language {
namespace {

using Kind = toml::Node::Kind;

std::string range_of(const Range& range, bool one) {
  const bool low = std::isfinite(range.least), high = std::isfinite(range.most);
  const std::string each = one ? "" : "each ";
  if (low && high)
    return fmt::format(" {}{} {} {} {}", each, range.above ? "between" : "from", range.least,
                       range.above ? "and" : "to", range.most);
  if (low && range.above) return fmt::format(" {}greater than {}", each, range.least);
  if (low) return fmt::format(", {}{} or more", each, range.least);
  return "";
}

bool in_range(double v, const Range& range) {
  return std::isfinite(v) && (range.above ? v > range.least : v >= range.least) &&
         (range.below ? v < range.most : v <= range.most);
}

bool is_number(const toml::Node& node) {
  return node.kind == Kind::number || node.kind == Kind::integer;
}

/// Three numbers in brackets, each in range.
bool read_three(const toml::Node& node, const Range& range, double* out) {
  if (node.kind != Kind::array || node.children.size() != 3) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!is_number(node.children[i]) || !in_range(node.children[i].number, range)) return false;
    out[i] = node.children[i].number;
  }
  return true;
}

FieldValue read_number(const toml::Node& node, const Range& range) {
  if (!is_number(node) || !in_range(node.number, range)) return {};
  return node.number;
}

FieldValue read_integer(const toml::Node& node, const Range& range) {
  if (node.kind != Kind::integer || !in_range(node.number, range)) return {};
  return node.integer;
}

FieldValue read_color(const toml::Node& node, const Range& range) {
  Color c;
  if (is_number(node) && in_range(node.number, range))
    return Color{node.number, node.number, node.number};
  if (node.kind == Kind::text) {
    const std::optional<Color> read = color_of_hex(node.text);
    return read ? FieldValue(*read) : FieldValue();
  }
  double rgb[3];
  if (!read_three(node, range, rgb)) return {};
  return Color{rgb[0], rgb[1], rgb[2]};
}

FieldValue read_vector(const toml::Node& node, const About& about) {
  double v[3];
  if (!read_three(node, about.range, v)) return {};
  if (about.unit == Unit::direction && v[0] == 0 && v[1] == 0 && v[2] == 0) return {};
  return Vec3{v[0], v[1], v[2]};
}

FieldValue read_points(const toml::Node& node, const About& about) {
  if (node.kind != Kind::array || node.children.size() < about.fewest ||
      node.children.size() > about.most)
    return {};
  Points points;
  for (const toml::Node& child : node.children) {
    const FieldValue value = read_vector(child, about);
    if (value.index() == 0) return {};
    points.push_back(std::get<Vec3>(value));
  }
  return points;
}

FieldValue plain_value(const toml::Node& node, const Field& field) {
  const About& about = field.about;
  switch (field.kind) {
    case FieldKind::number:
      return read_number(node, about.range);
    case FieldKind::integer:
      return read_integer(node, about.range);
    case FieldKind::boolean:
      return node.kind == Kind::boolean ? FieldValue(node.truth) : FieldValue();
    case FieldKind::vector:
      return read_vector(node, about);
    case FieldKind::color:
      return read_color(node, about.range);
    case FieldKind::text:
      return node.kind == Kind::text ? FieldValue(std::string(node.text)) : FieldValue();
    case FieldKind::points:
      return read_points(node, about);
    case FieldKind::choice:
    case FieldKind::table:
      break;
  }
  return {};
}

FieldValue read_choice(const toml::Node& node, const Field& field, std::string_view what,
                       Problems& problems) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < field.about.choices.size(); ++i) {
    const Choice& choice = field.about.choices[i];
    if (node.kind == Kind::text && choice.name == node.text) {
      if (choice.built) return Chosen{static_cast<int>(i)};
      problems.error(node.begin,
                     fmt::format("{} \"{}\" of {} is not built yet", field.key, choice.name, what));
      return {};
    }
    if (choice.built) names.push_back(choice.name);
  }
  const std::string message = fmt::format("{} of {} is {}: expected {}", field.key, what,
                                          shown(problems.source(node)), expected_of(field));
  if (node.kind == Kind::text)
    problems.unknown(node.begin, message, node.text, names, "it can be");
  else
    problems.error(node.begin, message);
  return {};
}

/// Names and tables where numbers are built: what the language names for this field besides.
bool is_later(const toml::Node& node, const Field& field) {
  if (field.about.later.empty()) return false;
  if (field.kind == FieldKind::color)
    return node.kind == Kind::table || (node.kind == Kind::text && !node.text.starts_with('#'));
  return node.kind == Kind::table || node.kind == Kind::text || node.kind == Kind::array;
}

void refuse_not_built(const toml::Node& node, const Field& field, std::string_view what,
                      Problems& problems) {
  const auto is_only = [&](const toml::Node& value) {
    return is_number(value) && value.number == *field.only_number;
  };
  if (field.only_number &&
      (is_only(node) || (node.kind == Kind::array && node.children.size() == 3 &&
                         std::all_of(node.children.begin(), node.children.end(), is_only))))
    return;
  if (!field.only_word.empty() && node.kind == Kind::text && node.text == field.only_word) return;
  double v[3];
  if (field.only_vector && read_three(node, {}, v) && Vec3{v[0], v[1], v[2]} == *field.only_vector)
    return;
  if (field.only_number)
    problems.error(node.begin, fmt::format("{} of {} other than {} is not built yet", field.key,
                                           what, *field.only_number));
  else if (!field.only_word.empty())
    problems.error(node.begin, fmt::format("{} of {} other than \"{}\" is not built yet", field.key,
                                           what, field.only_word));
  else if (field.only_vector)
    problems.error(node.begin, fmt::format("{} of {} other than {} is not built yet", field.key,
                                           what, text_of(*field.only_vector)));
  else
    problems.error(node.key_begin, fmt::format("{} of {} is not built yet", field.key, what));
}

void read_field(const toml::Node& node, const Field& field, std::string_view what, void* object,
                Problems& problems) {
  if (!field.built) return refuse_not_built(node, field, what, problems);
  if (field.kind == FieldKind::table) {
    if (node.kind == Kind::table)
      return read_fields(node, *field.table, fmt::format("{} of {}", field.key, what),
                         field.inside(object), problems);
    return problems.error(node.begin,
                          fmt::format("{} of {} is {}: expected {}", field.key, what,
                                      shown(problems.source(node)), expected_of(field)));
  }
  FieldValue value = read_value(node, field, what, problems);
  if (value.index() != 0) field.set(object, std::move(value));
}

/// The field that the lab's sheet calls so, "" if none is.
std::string_view key_of_symbol(std::string_view symbol, std::span<const Part> parts) {
  for (const Part& part : parts)
    for (const Field& field : part.table->fields)
      if (!symbol.empty() && field.about.symbol == symbol) return field.key;
  return {};
}

}  // namespace

std::string expected_of(const Field& field) {
  const About& about = field.about;
  switch (field.kind) {
    case FieldKind::number:
      return "a number" + range_of(about.range, true);
    case FieldKind::integer:
      return "a whole number" + range_of(about.range, true);
    case FieldKind::boolean:
      return "true or false";
    case FieldKind::vector:
      return about.unit == Unit::direction
                 ? "a direction [x, y, z], not all 0"
                 : "[x, y, z], finite numbers" + range_of(about.range, false);
    case FieldKind::color:
      return fmt::format("a colour: [r, g, b]{}, one number for grey, or \"#rrggbb\"",
                         range_of(about.range, false));
    case FieldKind::text:
      return about.unit == Unit::name_of_material ? "the name of a material, in quotes"
                                                  : "a text in quotes";
    case FieldKind::points:
      return about.fewest == about.most
                 ? fmt::format("{} of [x, y, z] in brackets", about.fewest)
                 : fmt::format("{} or more of [x, y, z] in brackets", about.fewest);
    case FieldKind::choice: {
      std::vector<std::string> names;
      for (const Choice& choice : about.choices)
        if (choice.built) names.push_back(quoted(choice.name));
      const std::string last = names.back();
      names.pop_back();
      return names.empty() ? last : fmt::format("{} or {}", fmt::join(names, ", "), last);
    }
    case FieldKind::table: {
      std::vector<std::string_view> keys;
      for (const Field& inner : field.table->fields) keys.push_back(inner.key);
      return fmt::format("a table {{{} = …}}", fmt::join(keys, " = …, "));
    }
  }
  return "";
}

FieldValue read_value(const toml::Node& node, const Field& field, std::string_view what,
                      Problems& problems) {
  if (field.kind == FieldKind::choice) return read_choice(node, field, what, problems);
  FieldValue value = plain_value(node, field);
  if (value.index() != 0) return value;
  if (is_later(node, field))
    problems.error(node.begin, fmt::format("{} for {} of {} is not built yet", field.about.later,
                                           field.key, what));
  else
    problems.error(node.begin, fmt::format("{} of {} is {}: expected {}", field.key, what,
                                           shown(problems.source(node)), expected_of(field)));
  return {};
}

void read_fields(const toml::Node& node, std::string_view what, std::span<const Part> parts,
                 Problems& problems, std::string_view also) {
  std::size_t read = 0;
  for (const Part& part : parts)
    for (const Field& field : part.table->fields) {
      const toml::Node* const child = node.find(field.key);
      read += child != nullptr;
      if (child != nullptr)
        read_field(*child, field, what, part.object, problems);
      else if (field.about.required && field.built)
        problems.missing(node.begin, fmt::format("{} has no {}: expected {}, {}", what, field.key,
                                                 field.about.text, expected_of(field)));
    }
  read += !also.empty() && node.find(also) != nullptr;
  if (read == node.children.size()) return;

  std::vector<std::string_view> known;
  if (!also.empty()) known.push_back(also);
  for (const Part& part : parts)
    for (const Field& field : part.table->fields) known.push_back(field.key);
  for (const toml::Node& child : node.children) {
    if (std::find(known.begin(), known.end(), child.key) != known.end()) continue;
    const std::string message = fmt::format("unknown field '{}' of {}", shown(child.key), what);
    const std::string_view meant = key_of_symbol(child.key, parts);
    if (meant.empty())
      problems.unknown(child.key_begin, message, child.key, known,
                       fmt::format("fields of {}", what));
    else
      problems.error(child.key_begin, message, fmt::format("did you mean '{}'?", meant));
  }
}

void read_fields(const toml::Node& node, const Table& table, std::string_view what, void* object,
                 Problems& problems) {
  const Part part{&table, object};
  read_fields(node, what, {&part, 1}, problems);
}

}  // namespace zraka::language
