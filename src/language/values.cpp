// SPDX-License-Identifier: Apache-2.0
// Values of fields: what they may be, and how a file has them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "language/color.hpp"
#include "language/fields.hpp"
#include "language/transforms.hpp"

namespace zraka::language {
namespace {

using NodeKind = toml::Node::Kind;

std::string range_of(const Range& range, bool one) {
  const bool low = std::isfinite(range.least), high = std::isfinite(range.most);
  const std::string each = one ? "" : "each ";
  if (low && high && range.above != range.below)
    return fmt::format(" {}{} {} and {} {}", each, range.above ? "greater than" : "of at least",
                       range.least, range.below ? "less than" : "at most", range.most);
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

bool in_range(const Vec3& v, const About& about) {
  return in_range(v.x, about.range) && in_range(v.y, about.range) && in_range(v.z, about.range) &&
         !((about.unit == Unit::direction || about.unit == Unit::attenuation) && v == Vec3{});
}

bool is_number(const toml::Node& node) {
  return node.kind == NodeKind::number || node.kind == NodeKind::integer;
}

FieldValue vector_of(const toml::Node& node) {
  if (node.kind != NodeKind::array || node.children.size() != 3 ||
      !std::all_of(node.children.begin(), node.children.end(), is_number))
    return {};
  return Vec3{node.children[0].number, node.children[1].number, node.children[2].number};
}

FieldValue color_of(const toml::Node& node) {
  if (is_number(node)) return Color{node.number, node.number, node.number};
  if (node.kind == NodeKind::text) {
    const std::optional<Color> color = color_of_hex(node.text);
    return color ? FieldValue(*color) : FieldValue();
  }
  const FieldValue value = vector_of(node);
  const Vec3* const v = std::get_if<Vec3>(&value);
  return v != nullptr ? FieldValue(Color{v->x, v->y, v->z}) : FieldValue();
}

/// A list of what is a T by itself.
template <class T>
FieldValue list_of(const toml::Node& node, FieldValue (*one)(const toml::Node&)) {
  if (node.kind != NodeKind::array) return {};
  std::vector<T> all;
  for (const toml::Node& child : node.children) {
    const FieldValue value = one(child);
    if (value.index() == 0) return {};
    all.push_back(std::get<T>(value));
  }
  return all;
}

FieldValue number_of(const toml::Node& node) {
  return is_number(node) ? FieldValue(node.number) : FieldValue();
}

FieldValue integer_of(const toml::Node& node) {
  return node.kind == NodeKind::integer ? FieldValue(node.integer) : FieldValue();
}

FieldValue uvs_of(const toml::Node& node) {
  CornerUvs uvs{};
  if (node.kind != NodeKind::array || node.children.size() != uvs.size()) return {};
  for (std::size_t corner = 0; corner < uvs.size(); ++corner) {
    const toml::Node& uv = node.children[corner];
    if (uv.kind != NodeKind::array || uv.children.size() != 2) return {};
    for (std::size_t i = 0; i < 2; ++i) {
      if (!is_number(uv.children[i])) return {};
      const double number = uv.children[i].number;
      if (!(std::fabs(number) <= static_cast<double>(std::numeric_limits<float>::max()))) return {};
      uvs[corner][i] = static_cast<float>(number);
    }
  }
  return uvs;
}

struct Judge {
  const About& about;
  bool operator()(double number) const { return in_range(number, about.range); }
  bool operator()(std::int64_t number) const {
    return in_range(static_cast<double>(number), about.range);
  }
  bool operator()(const Vec3& v) const { return in_range(v, about); }
  bool operator()(const Color& c) const { return in_range(Vec3{c.r, c.g, c.b}, about); }
  bool operator()(const Points& points) const {
    return points.size() >= about.fewest && points.size() <= about.most &&
           std::all_of(points.begin(), points.end(),
                       [&](const Vec3& point) { return in_range(point, about); });
  }
  bool operator()(const Colors& colors) const {
    return colors.size() >= about.fewest && colors.size() <= about.most &&
           std::all_of(colors.begin(), colors.end(), *this);
  }
  bool operator()(const Numbers& numbers) const {
    return numbers.size() >= about.fewest && numbers.size() <= about.most &&
           std::all_of(numbers.begin(), numbers.end(), *this);
  }
  bool operator()(const Integers& numbers) const {
    return numbers.size() >= about.fewest && numbers.size() <= about.most &&
           std::all_of(numbers.begin(), numbers.end(), *this);
  }
  bool operator()(const CornerUvs& uvs) const {
    return std::all_of(uvs.begin(), uvs.end(), [](const std::array<float, 2>& uv) {
      return std::isfinite(uv[0]) && std::isfinite(uv[1]);
    });
  }
  bool operator()(const Transform& transform) const { return is_readable(transform); }
  bool operator()(const auto&) const { return true; }
};

/// "3", "3 or more".
std::string count_of(const About& about) {
  return fmt::format("{}{}", about.fewest, about.fewest == about.most ? "" : " or more");
}

}  // namespace

FieldValue value_as(FieldKind kind, const toml::Node& node) {
  switch (kind) {
    case FieldKind::number:
      return number_of(node);
    case FieldKind::integer:
      return integer_of(node);
    case FieldKind::boolean:
      return node.kind == NodeKind::boolean ? FieldValue(node.truth) : FieldValue();
    case FieldKind::vector:
      return vector_of(node);
    case FieldKind::color:
      return color_of(node);
    case FieldKind::text:
      return node.kind == NodeKind::text ? FieldValue(std::string(node.text)) : FieldValue();
    case FieldKind::points:
      return list_of<Vec3>(node, vector_of);
    case FieldKind::colors:
      return list_of<Color>(node, color_of);
    case FieldKind::numbers:
      return list_of<double>(node, number_of);
    case FieldKind::integers:
      return list_of<std::int64_t>(node, integer_of);
    case FieldKind::uvs:
      return uvs_of(node);
    case FieldKind::choice:
    case FieldKind::transform:
    case FieldKind::texture:
    case FieldKind::shapes:
    case FieldKind::table:
      break;
  }
  return {};
}

bool allowed(const Field& field, const FieldValue& value) {
  return std::visit(Judge{field.about}, value);
}

std::string form_of(const Field& field, const Table& table) {
  std::vector<std::string> keys;
  if (field.about.by_kind) keys.push_back(fmt::format("kind = {}", in_quotes(table.name)));
  for (const Field& inner : table.fields) keys.push_back(fmt::format("{} = …", inner.key));
  return fmt::format("{{{}}}", fmt::join(keys, ", "));
}

namespace {

/// "a, b or c"
std::string one_of(std::vector<std::string> all) {
  const std::string last = std::move(all.back());
  all.pop_back();
  return all.empty() ? last : fmt::format("{} or {}", fmt::join(all, ", "), last);
}

std::string expected_value_of(const Field& field) {
  const About& about = field.about;
  const std::string_view or_texture = about.textured ? ", or a texture" : "";
  switch (field.kind) {
    case FieldKind::number:
      return fmt::format("a number{}{}", range_of(about.range, true), or_texture);
    case FieldKind::integer:
      return "a whole number" + range_of(about.range, true);
    case FieldKind::boolean:
      return "true or false";
    case FieldKind::vector:
      if (about.unit == Unit::attenuation)
        return "[c, l, q]" + range_of(about.range, false) + ", not all 0";
      return about.unit == Unit::direction
                 ? "a direction [x, y, z], not all 0"
                 : "[x, y, z], finite numbers" + range_of(about.range, false);
    case FieldKind::color:
      return fmt::format("a colour: [r, g, b]{}, one number for grey, or \"#rrggbb\"{}",
                         range_of(about.range, false), or_texture);
    case FieldKind::text:
      switch (about.unit) {
        case Unit::name_of_material:
          return "the name of a material, in quotes";
        case Unit::name_of_group:
          return "the name of a group, in quotes";
        case Unit::name_of_glass:
          return "the name of a glass or of another clear material, in quotes";
        case Unit::picture:
          return "the name of a picture's file, in quotes";
        case Unit::mesh:
          return "the name of an .obj, .ply, .stl or .off file, in quotes";
        case Unit::particles:
          return "the name of a file of particles, in quotes";
        default:
          return "a text in quotes";
      }
    case FieldKind::points:
      return count_of(about) + " of [x, y, z] in brackets";
    case FieldKind::colors:
      return count_of(about) + " colours in brackets: [r, g, b]" + range_of(about.range, false) +
             ", one number for grey, or \"#rrggbb\"";
    case FieldKind::numbers:
      return count_of(about) + " finite numbers in brackets" + range_of(about.range, false);
    case FieldKind::integers:
      return count_of(about) + " whole numbers in brackets" + range_of(about.range, false);
    case FieldKind::uvs:
      return "3 of [u, v] in brackets, finite numbers";
    case FieldKind::transform:
      return expected_transform();
    case FieldKind::texture:
      return "the name of a texture, in quotes, or a table of one: {kind = …}";
    case FieldKind::shapes:
      return fmt::format("a list of shapes: [{{kind = …}}, …]{}",
                         about.fewest > 0 ? fmt::format(", {} or more", about.fewest) : "");
    case FieldKind::choice: {
      std::vector<std::string> names;
      for (const Choice& choice : about.choices) names.push_back(in_quotes(choice.name));
      return one_of(std::move(names));
    }
    case FieldKind::table:
      break;
  }
  return "";
}

}  // namespace

std::string expected_of(const Field& field) {
  const std::string value = expected_value_of(field);
  if (field.tables.empty()) return value;
  std::vector<std::string> forms;
  for (const Table* table : field.tables) forms.push_back(form_of(field, *table));
  return fmt::format("{}{}a table {}", value, value.empty() ? "" : "; or ",
                     one_of(std::move(forms)));
}

}  // namespace zraka::language
