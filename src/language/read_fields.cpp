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

using NodeKind = toml::Node::Kind;

FieldValue read_choice(const toml::Node& node, const Field& field, std::string_view what,
                       Problems& problems) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < field.about.choices.size(); ++i) {
    const Choice& choice = field.about.choices[i];
    if (node.kind == NodeKind::text && choice.name == node.text) return Chosen{static_cast<int>(i)};
    names.push_back(choice.name);
  }
  const std::string message = fmt::format("{} of {} is {}: expected {}", field.key, what,
                                          shown(problems.source(node)), expected_of(field));
  if (node.kind == NodeKind::text)
    problems.unknown(node.begin, message, node.text, names, "it can be");
  else
    problems.error(node.begin, message);
  return {};
}

void refuse(const toml::Node& node, const Field& field, std::string_view what, Problems& problems) {
  std::string hint;
  if (field.kind == FieldKind::color && node.kind == NodeKind::text)
    hint = hint_at_color(node.text);
  problems.error(node.begin,
                 fmt::format("{} of {} is {}: expected {}", field.key, what,
                             shown(problems.source(node)), expected_of(field)),
                 std::move(hint));
}

/// A list of tables, which whoever has the field reads.
void check_shapes(const toml::Node& node, const Field& field, std::string_view what,
                  Problems& problems) {
  if (node.kind != NodeKind::array || node.children.size() < field.about.fewest)
    return refuse(node, field, what, problems);
  for (const toml::Node& child : node.children)
    if (child.kind != NodeKind::table)
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
  const bool no_color = field.kind == FieldKind::color && node.kind == NodeKind::text &&
                        node.text.starts_with('#') && !input.textures.contains(node.text);
  if (may_be_texture && !no_color &&
      (node.kind == NodeKind::text || node.kind == NodeKind::table)) {
    const std::optional<std::uint32_t> texture = read_texture(node, field, what, input);
    return texture ? FieldValue(TextureIndex{*texture}) : FieldValue();
  }
  refuse(node, field, what, problems);
  return {};
}

/// Which of a field's tables this is, by its kind; none, and the problem told, if it is none.
std::optional<std::size_t> table_by_kind(const toml::Node& node, const Field& field,
                                         std::string_view what, Problems& problems) {
  std::vector<std::string_view> names;
  for (const Table* table : field.tables) names.push_back(table->name);
  const std::string plural = fmt::format("kinds of {}", field.key);
  const toml::Node* const kind = node.find("kind");
  if (kind == nullptr) {
    problems.missing(node.begin, fmt::format("{} of {} has no kind", field.key, what),
                     fmt::format("{}: {}", plural, fmt::join(names, ", ")));
    return std::nullopt;
  }
  if (kind->kind == NodeKind::text)
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] == kind->text) return i;
  if (kind->kind == NodeKind::text)
    problems.unknown(
        kind->begin,
        fmt::format("unknown kind '{}' for {} of {}", shown(kind->text), field.key, what),
        kind->text, names, plural);
  else
    problems.error(kind->begin, fmt::format("kind of {} of {} is {}: expected a text in quotes",
                                            field.key, what, shown(problems.source(*kind))));
  return std::nullopt;
}

/// The same by the first keys of the tables, of which one has to be there.
std::optional<std::size_t> table_by_key(const toml::Node& node, const Field& field,
                                        std::string_view what, Problems& problems) {
  std::optional<std::size_t> found;
  std::size_t count = 0;
  for (std::size_t i = 0; i < field.tables.size(); ++i)
    if (node.find(field.tables[i]->fields.front().key) != nullptr) found = i, ++count;
  if (count == 1) return found;
  std::vector<std::string_view> known;
  for (const Table* table : field.tables)
    for (const Field& inner : table->fields) known.push_back(inner.key);
  if (count == 0 && !node.children.empty()) {
    const toml::Node& first = node.children.front();
    if (std::find(known.begin(), known.end(), first.key) == known.end()) {
      problems.unknown(
          first.key_begin,
          fmt::format("unknown field '{}' for {} of {}", shown(first.key), field.key, what),
          first.key, known, fmt::format("fields of {}", field.key));
      return std::nullopt;
    }
  }
  refuse(node, field, what, problems);
  return std::nullopt;
}

void read_table(const toml::Node& node, const Field& field, std::string_view what, void* object,
                Input& input) {
  std::optional<std::size_t> which = 0;
  if (field.about.by_kind)
    which = table_by_kind(node, field, what, input.problems);
  else if (field.tables.size() > 1 || field.kind != FieldKind::table)
    which = table_by_key(node, field, what, input.problems);
  if (!which) return;
  const Part part{field.tables[*which], field.inside(object, *which)};
  read_fields(node, fmt::format("{} of {}", field.key, what), {&part, 1}, input,
              field.about.by_kind ? "kind" : "");
}

void read_field(const toml::Node& node, const Field& field, std::string_view what, void* object,
                Input& input) {
  Problems& problems = input.problems;
  if (field.kind == FieldKind::shapes) return check_shapes(node, field, what, problems);
  if (!field.tables.empty() && node.kind == NodeKind::table)
    return read_table(node, field, what, object, input);
  if (field.kind == FieldKind::table) return refuse(node, field, what, problems);
  FieldValue value = read_value(node, field, what, input);
  if (value.index() != 0) field.set(object, std::move(value));
}

/// The node of a field, whichever of its keys it has; a problem if it has both.
const toml::Node* find_field(const toml::Node& node, const Field& field, std::string_view what,
                             Problems& problems) {
  const toml::Node* const child = node.find(field.key);
  if (field.about.also.empty()) return child;
  const toml::Node* const other = node.find(field.about.also);
  if (child != nullptr && other != nullptr)
    problems.error(other->key_begin, fmt::format("{} has {} and {}: expected one of them", what,
                                                 field.key, field.about.also));
  return child != nullptr ? child : other;
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
      const toml::Node* const child = find_field(node, field, what, problems);
      read += child != nullptr;
      if (child != nullptr)
        read_field(*child, field, what, part.object, input);
      else if (field.about.required)
        problems.missing(node.begin, fmt::format("{} has no {}: expected {}, {}", what, field.key,
                                                 field.about.text, expected_of(field)));
    }
  read += !also.empty() && node.find(also) != nullptr;
  if (read == node.children.size()) return;

  std::vector<std::string_view> known;
  if (!also.empty()) known.push_back(also);
  for (const Part& part : parts)
    for (const Field& field : part.table->fields)
      for (const std::string_view key : {field.key, field.about.also})
        if (!key.empty()) known.push_back(key);
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
