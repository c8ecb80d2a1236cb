// SPDX-License-Identifier: Apache-2.0
// JSON Schema (draft 7) of the scene language.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "language/help.hpp"
#include "language/sections.hpp"

namespace zraka::language {
namespace {

/// Members of an object; values are JSON, as all that text_of() writes is.
class Object {
 public:
  Object& add(std::string_view key, std::string_view value) {
    text_ += fmt::format("{}{}: {}", text_.empty() ? "" : ", ", quoted(key), value);
    return *this;
  }
  std::string text() const { return "{" + text_ + "}"; }

 private:
  std::string text_;
};

std::string list_of(const std::vector<std::string>& values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}

Object number_of(const Range& range, std::string_view type) {
  Object object;
  object.add("type", quoted(type));
  if (std::isfinite(range.least))
    object.add(range.above ? "exclusiveMinimum" : "minimum", text_of(range.least));
  if (std::isfinite(range.most))
    object.add(range.below ? "exclusiveMaximum" : "maximum", text_of(range.most));
  return object;
}

Object array_of(const std::string& items, std::size_t fewest, std::size_t most) {
  Object object;
  object.add("type", "\"array\"").add("items", items).add("minItems", std::to_string(fewest));
  if (most != std::numeric_limits<std::size_t>::max()) object.add("maxItems", std::to_string(most));
  return object;
}

Object vector_of(const About& about) {
  Object object = array_of(number_of(about.range, "number").text(), 3, 3);
  if (about.unit == Unit::direction) object.add("not", R"({"const": [0, 0, 0]})");
  return object;
}

std::string object_of(const std::vector<const Table*>& tables, const Kind* kind, bool kind_needed);

/// The one value that a field which is not built may have.
Object only_value(const Field& field) {
  Object object;
  if (field.only_number) {
    const std::string n = text_of(*field.only_number);
    return object.add("enum", fmt::format("[{0}, [{0}, {0}, {0}]]", n));
  }
  return object.add("const",
                    field.only_vector ? text_of(*field.only_vector) : quoted(field.only_word));
}

Object value_of(const Field& field) {
  if (!field.built) return only_value(field);
  const About& about = field.about;
  Object object;
  switch (field.kind) {
    case FieldKind::number:
      return number_of(about.range, "number");
    case FieldKind::integer:
      return number_of(about.range, "integer");
    case FieldKind::boolean:
      return object.add("type", "\"boolean\"");
    case FieldKind::vector:
      return vector_of(about);
    case FieldKind::color:
      return object.add("anyOf",
                        list_of({array_of(number_of(about.range, "number").text(), 3, 3).text(),
                                 number_of(about.range, "number").text(),
                                 R"({"type": "string", "pattern": "^#[0-9A-Fa-f]{6}$"})"}));
    case FieldKind::text:
      return object.add("type", "\"string\"");
    case FieldKind::points:
      return array_of(vector_of(about).text(), about.fewest, about.most);
    case FieldKind::choice: {
      std::vector<std::string> names;
      for (const Choice& choice : about.choices)
        if (choice.built) names.push_back(quoted(choice.name));
      return object.add("enum", list_of(names));
    }
    case FieldKind::table:
      break;
  }
  return object;
}

std::string schema_of(const Field& field, const Table& table) {
  if (field.kind == FieldKind::table) return object_of({field.table}, nullptr, false);
  Object object = value_of(field);
  object.add("description", quoted(field.about.text));
  if (field.built && !field.about.required)
    if (const std::string value = text_of(field, field.get(table.defaults())); !value.empty())
      object.add("default", value);
  return object.text();
}

std::string object_of(const std::vector<const Table*>& tables, const Kind* kind, bool kind_needed) {
  Object properties;
  std::vector<std::string> required;
  if (kind != nullptr) properties.add("kind", fmt::format("{{\"const\": {}}}", quoted(kind->name)));
  if (kind_needed) required.push_back("\"kind\"");
  for (const Table* table : tables)
    for (const Field& field : table->fields) {
      const bool has_value =
          field.built || field.only_number || field.only_vector || !field.only_word.empty();
      if (has_value) properties.add(field.key, schema_of(field, *table));
      if (field.built && field.about.required) required.push_back(quoted(field.key));
    }
  Object object;
  object.add("type", "\"object\"");
  if (!tables.empty()) object.add("description", quoted(tables.front()->text));
  object.add("properties", properties.text());
  if (!required.empty()) object.add("required", list_of(required));
  return object.add("additionalProperties", "false").text();
}

std::string schema_of(const Section& section) {
  std::string item;
  if (section.family != nullptr) {
    const Family& family = *section.family;
    std::vector<std::string> kinds;
    for (const Kind* kind : family.kinds)
      kinds.push_back(
          object_of({&kind->table, &family.common}, kind, kind->name != family.default_kind));
    item = Object().add("anyOf", list_of(kinds)).text();
  } else {
    item = object_of({section.table}, nullptr, false);
  }
  Object object;
  object.add("description", quoted(section.text));
  switch (section.form) {
    case Section::Form::one:
      return item;
    case Section::Form::list:
      return object.add("type", "\"array\"").add("items", item).text();
    case Section::Form::named:
      return object.add("type", "\"object\"").add("additionalProperties", item).text();
  }
  return "";
}

/// With a line for every member of an object.
std::string in_lines(std::string_view json) {
  std::string out;
  std::string levels;  // the brackets that are open
  bool inside = false, escaped = false;
  const auto new_line = [&] { out += '\n' + std::string(2 * levels.size(), ' '); };
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (inside) {
      out += c;
      inside = escaped || c != '"';
      escaped = !escaped && c == '\\';
      continue;
    }
    inside = c == '"';
    const bool in_object = !levels.empty() && levels.back() == '{';
    if (c == '}' || c == ']') {
      levels.pop_back();
      if (in_object) new_line();
      out += c;
    } else if (c == '{' || c == '[') {
      out += c;
      levels += c;
      if (c == '{') new_line();
    } else if (c == ',' && in_object) {
      out += c;
      new_line();
      ++i;  // the space
    } else {
      out += c;
    }
  }
  return out + "\n";
}

}  // namespace

std::string json_schema() {
  Object properties;
  for (const Section* section : kSections)
    if (section->read != nullptr) properties.add(section->key, schema_of(*section));
  return in_lines(Object()
                      .add("$schema", "\"http://json-schema.org/draft-07/schema#\"")
                      .add("title", "\"A scene of zraka\"")
                      .add("type", "\"object\"")
                      .add("properties", properties.text())
                      .add("additionalProperties", "false")
                      .text());
}

}  // namespace zraka::language
