// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"
#include "language/color.hpp"
#include "language/section.hpp"
#include "language/textures.hpp"
#include "language/transforms.hpp"

namespace zraka::language {
namespace {

using Kind = toml::Node::Kind;

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
  const double only = field.only_number.value_or(0);
  if (field.only_number && value_as(FieldKind::color, node) == FieldValue(Color{only, only, only}))
    return;
  if (!field.only_word.empty() && node.kind == Kind::text && node.text == field.only_word) return;
  if (field.only_vector && value_as(FieldKind::vector, node) == FieldValue(*field.only_vector))
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

void refuse(const toml::Node& node, const Field& field, std::string_view what, Problems& problems) {
  std::string hint;
  if (field.kind == FieldKind::color && node.kind == Kind::text) hint = hint_at_color(node.text);
  problems.error(node.begin,
                 fmt::format("{} of {} is {}: expected {}", field.key, what,
                             shown(problems.source(node)), expected_of(field)),
                 std::move(hint));
}

/// A list of tables, which whoever has the field reads.
void check_shapes(const toml::Node& node, const Field& field, std::string_view what,
                  Problems& problems) {
  if (node.kind != Kind::array || node.children.size() < field.about.fewest)
    return refuse(node, field, what, problems);
  for (const toml::Node& child : node.children)
    if (child.kind != Kind::table)
      problems.error(child.begin, fmt::format("{} of {} has {} in it: expected {}", field.key, what,
                                              shown(problems.source(child)), expected_of(field)));
}

FieldValue read_value(const toml::Node& node, const Field& field, std::string_view what,
                      Input& input) {
  Problems& problems = input.problems;
  if (field.kind == FieldKind::choice) return read_choice(node, field, what, problems);
  if (field.kind == FieldKind::transform) {
    const std::optional<Transform> transform = read_transform(node, field.key, what, problems);
    return transform ? FieldValue(*transform) : FieldValue();
  }
  FieldValue value = value_as(field.kind, node);
  if (value.index() != 0 && allowed(field, value)) return value;
  const bool may_be_texture = field.about.textured || field.kind == FieldKind::texture;
  const bool no_color = field.kind == FieldKind::color && node.kind == Kind::text &&
                        node.text.starts_with('#') && !input.textures.contains(node.text);
  if (may_be_texture && !no_color && (node.kind == Kind::text || node.kind == Kind::table)) {
    const std::optional<std::uint32_t> texture = read_texture(node, field, what, input);
    return texture ? FieldValue(TextureIndex{*texture}) : FieldValue();
  }
  if (is_later(node, field))
    problems.error(node.begin, fmt::format("{} for {} of {} is not built yet", field.about.later,
                                           field.key, what));
  else
    refuse(node, field, what, problems);
  return {};
}

void read_field(const toml::Node& node, const Field& field, std::string_view what, void* object,
                Input& input) {
  Problems& problems = input.problems;
  if (!field.built) return refuse_not_built(node, field, what, problems);
  if (field.kind == FieldKind::shapes) return check_shapes(node, field, what, problems);
  if (field.kind == FieldKind::table) {
    if (node.kind == Kind::table)
      return read_fields(node, *field.table, fmt::format("{} of {}", field.key, what),
                         field.inside(object), input);
    return refuse(node, field, what, problems);
  }
  FieldValue value = read_value(node, field, what, input);
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

void read_fields(const toml::Node& node, std::string_view what, std::span<const Part> parts,
                 Input& input, std::string_view also) {
  Problems& problems = input.problems;
  std::size_t read = 0;
  for (const Part& part : parts)
    for (const Field& field : part.table->fields) {
      const toml::Node* const child = node.find(field.key);
      read += child != nullptr;
      if (child != nullptr)
        read_field(*child, field, what, part.object, input);
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
                 Input& input) {
  const Part part{&table, object};
  read_fields(node, what, {&part, 1}, input);
}

}  // namespace zraka::language
