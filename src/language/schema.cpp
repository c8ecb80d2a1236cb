// SPDX-License-Identifier: Apache-2.0
// JSON Schema (draft 7) of the scene language.
#include <cmath>

#include "core/json.hpp"
#include "language/help.hpp"
#include "language/sections.hpp"
#include "language/shapes.hpp"
#include "language/textures.hpp"

namespace zraka::language {
namespace {

struct JsonOf {
  const Field& field;
  Json operator()(std::monostate) const { return {}; }
  Json operator()(const Vec3& v) const { return {v.x, v.y, v.z}; }
  Json operator()(const Color& c) const { return {c.r, c.g, c.b}; }
  Json operator()(const Chosen& chosen) const {
    return field.about.choices[static_cast<std::size_t>(chosen.index)].name;
  }
  template <class T>
  Json operator()(const std::vector<T>& values) const {
    Json all = Json::array();
    for (const T& value : values) all.push_back((*this)(value));
    return all;
  }
  Json operator()(const CornerUvs& uvs) const {
    Json all = Json::array();
    for (const auto& [u, v] : uvs) all.push_back({u, v});
    return all;
  }
  // Only what moves nothing is anybody's default.
  Json operator()(const Transform&) const { return Json::array(); }
  Json operator()(const TextureIndex&) const { return {}; }
  Json operator()(const ShapeTables&) const { return {}; }
  Json operator()(const auto& value) const { return value; }
};

Json number_of(const Range& range, const char* type) {
  Json json = {{"type", type}};
  if (std::isfinite(range.least)) json[range.above ? "exclusiveMinimum" : "minimum"] = range.least;
  if (std::isfinite(range.most)) json[range.below ? "exclusiveMaximum" : "maximum"] = range.most;
  return json;
}

Json array_of(Json items, std::size_t fewest, std::size_t most) {
  Json json = {{"type", "array"}};
  json["items"] = std::move(items);
  json["minItems"] = fewest;
  if (most != std::numeric_limits<std::size_t>::max()) json["maxItems"] = most;
  return json;
}

Json vector_of(const About& about) {
  Json json = array_of(number_of(about.range, "number"), 3, 3);
  if (about.unit == Unit::direction || about.unit == Unit::attenuation)
    json["not"] = {{"const", {0, 0, 0}}};
  return json;
}

Json color_of(const About& about) {
  Json any = Json::array();
  any.push_back(vector_of(about));
  any.push_back(number_of(about.range, "number"));
  any.push_back({{"type", "string"}, {"pattern", "^#[0-9A-Fa-f]{6}$"}});
  return {{"anyOf", any}};
}

/// What stands among the definitions.
Json defined(const char* name) {
  Json all = Json::array();  // beside a bare $ref no other key would count
  all.push_back({{"$ref", std::string("#/definitions/") + name}});
  return {{"allOf", all}};
}

/// Names cannot be checked.
Json or_texture(Json value) {
  Json any = Json::array();
  any.push_back(std::move(value));
  any.push_back({{"type", "string"}});
  any.push_back(defined("texture"));
  return {{"anyOf", any}};
}

/// A table of these keys and no others.
Json table_with(std::initializer_list<std::pair<const char*, Json>> keys) {
  Json properties = Json::object(), required = Json::array();
  for (const auto& [key, value] : keys) {
    properties[key] = value;
    required.push_back(key);
  }
  Json json = {{"type", "object"}};
  json["properties"] = std::move(properties);
  json["required"] = std::move(required);
  json["additionalProperties"] = false;
  return json;
}

Json transform_schema() {
  const Json number = number_of({}, "number"), vector = array_of(number, 3, 3);
  Json direction = vector;
  direction["not"] = {{"const", {0, 0, 0}}};
  Json factor = number;
  factor["not"] = {{"const", 0}};
  Json scale = Json::array();
  scale.push_back(factor);
  scale.push_back(array_of(factor, 3, 3));
  Json steps = Json::array();
  steps.push_back(table_with({{"scale", {{"anyOf", scale}}}}));
  steps.push_back(table_with({{"rotate", direction}, {"by_deg", number}}));
  steps.push_back(table_with({{"translate", vector}}));
  steps.push_back(table_with({{"matrix", array_of(array_of(number, 4, 4), 3, 3)}}));
  return array_of({{"anyOf", steps}}, 0, std::numeric_limits<std::size_t>::max());
}

Json choice_of(const About& about) {
  Json names = Json::array();
  for (const Choice& choice : about.choices) names.push_back(choice.name);
  return {{"enum", names}};
}

Json object_of(const std::vector<const Table*>& tables, std::string_view kind = "",
               bool kind_needed = false);

/// Of a field that has two keys.
Json one_key_of(const Field& field) {
  Json keys = Json::array();
  for (const std::string_view key : {field.key, field.about.also})
    keys.push_back({{"required", Json::array({key})}});
  return {{"oneOf", keys}};
}

Json plain_value_of(const Field& field) {
  const About& about = field.about;
  switch (field.kind) {
    case FieldKind::number:
      return number_of(about.range, "number");
    case FieldKind::integer:
      return number_of(about.range, "integer");
    case FieldKind::boolean:
      return {{"type", "boolean"}};
    case FieldKind::vector:
      return vector_of(about);
    case FieldKind::color:
      return color_of(about);
    case FieldKind::text:
      return {{"type", "string"}};
    case FieldKind::points:
      return array_of(vector_of(about), about.fewest, about.most);
    case FieldKind::colors:
      return array_of(color_of(about), about.fewest, about.most);
    case FieldKind::numbers:
      return array_of(number_of(about.range, "number"), about.fewest, about.most);
    case FieldKind::uvs:
      return array_of(array_of(number_of({}, "number"), 2, 2), 3, 3);
    case FieldKind::transform:
      return defined("transform");
    case FieldKind::texture: {
      Json any = Json::array();
      any.push_back({{"type", "string"}});
      any.push_back(defined("texture"));
      return {{"anyOf", any}};
    }
    case FieldKind::shapes:
      return array_of(defined(about.closed ? "body" : "shape"), about.fewest, about.most);
    case FieldKind::choice:
      return choice_of(about);
    case FieldKind::integers:
      return array_of(number_of(about.range, "integer"), about.fewest, about.most);
    case FieldKind::table:
      break;
  }
  return {};
}

Json value_of(const Field& field) {
  const Json value = plain_value_of(field);
  if (field.about.textured) return or_texture(value);
  if (field.tables.empty()) return value;
  Json any = Json::array();
  if (!value.is_null()) any.push_back(value);
  for (const Table* table : field.tables)
    any.push_back(object_of({table}, field.about.by_kind ? table->name : "", field.about.by_kind));
  return {{"anyOf", any}};
}

Json schema_of(const Field& field, const Table& table) {
  Json json = value_of(field);
  json["description"] = field.about.text;
  if (field.about.required || field.get == nullptr) return json;
  Json value = std::visit(JsonOf{field}, field.get(table.defaults()));
  if (!value.is_null()) json["default"] = std::move(value);
  return json;
}

Json object_of(const std::vector<const Table*>& tables, std::string_view kind, bool kind_needed) {
  Json properties = Json::object(), required = Json::array(), either = Json::array();
  bool has_two_keys = false;
  if (!kind.empty()) properties["kind"] = {{"const", kind}};
  if (kind_needed) required.push_back("kind");
  for (const Table* table : tables)
    for (const Field& field : table->fields) {
      const Json json = schema_of(field, *table);
      properties[field.key] = json;
      if (!field.about.also.empty()) {
        properties[field.about.also] = json;
        if (field.about.required) either.push_back(one_key_of(field)), has_two_keys = true;
      } else if (field.about.required) {
        required.push_back(field.key);
      }
    }
  Json json = {{"type", "object"}};
  json["description"] = tables.front()->text;
  json["properties"] = std::move(properties);
  json["required"] = std::move(required);
  if (has_two_keys) json["allOf"] = std::move(either);
  json["additionalProperties"] = false;
  return json;
}

Json item_of(const Section& section, bool closed = false) {
  if (section.family == nullptr) return object_of({section.table});
  const Family& family = *section.family;
  Json kinds = Json::array();
  for (const Kind* kind : family.kinds)
    if (kind->closed || !closed)
      kinds.push_back(
          object_of({&kind->table, &family.common}, kind->name, kind->name != family.default_kind));
  return {{"anyOf", kinds}};
}

Json schema_of(const Section& section) {
  Json json = section.family == &kShapeFamily     ? defined("shape")
              : section.family == &kTextureFamily ? defined("texture")
                                                  : item_of(section);
  switch (section.form) {
    case Section::Form::one:
      return json;
    case Section::Form::list:
      return {{"type", "array"}, {"description", section.text}, {"items", json}};
    case Section::Form::named:
      return {{"type", "object"}, {"description", section.text}, {"additionalProperties", json}};
  }
  return json;
}

}  // namespace

std::string json_schema() {
  Json properties = Json::object();
  for (const Section* section : kSections) properties[section->key] = schema_of(*section);
  const Json json = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                     {"title", "A scene of zraka"},
                     {"type", "object"},
                     {"properties", properties},
                     {"additionalProperties", false},
                     {"definitions",
                      {{"shape", item_of(section::shape)},
                       {"body", item_of(section::shape, true)},
                       {"texture", item_of(section::texture)},
                       {"transform", transform_schema()}}}};
  return json.dump(2) + "\n";
}

}  // namespace zraka::language
