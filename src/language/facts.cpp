// SPDX-License-Identifier: Apache-2.0
#include "language/facts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace zraka::language {
namespace {

std::string_view unit_of(const Field& field) {
  const Unit unit = field.about.unit;
  return unit == Unit::length ? ", in scene units" : unit == Unit::degrees ? ", in degrees" : "";
}

std::string state_of(const Field& field, const Table& table) {
  if (field.about.required) return "required";
  if (field.get == nullptr) return "";
  const std::string value = text_of(field, field.get(table.defaults()));
  return value.empty() || value == "\"\"" ? "" : fmt::format("default {}", value);
}

}  // namespace

FieldFacts facts_of(const Field& field, const Table& table) {
  const About& about = field.about;
  FieldFacts facts{std::string(field.key), std::string(about.text), "", state_of(field, table)};
  if (!about.symbol.empty()) facts.meaning += fmt::format(" ({})", about.symbol);
  if (!about.also.empty()) facts.meaning += fmt::format(" (also `{}`)", about.also);
  facts.value = fmt::format("{}{}", expected_of(field), unit_of(field));
  return facts;
}

std::vector<Topic> topics() {
  std::vector<Topic> all;
  for (const Section* section : kSections) {
    all.push_back({section->key, section});
    if (section->family == nullptr) continue;
    for (const Kind* kind : section->family->kinds) all.push_back({kind->name, section, kind});
  }
  return all;
}

std::vector<const Table*> tables_of(const Topic& topic) {
  std::vector<const Table*> tables;
  if (topic.kind != nullptr) tables.push_back(&topic.kind->table);
  if (topic.section->table != nullptr) tables.push_back(topic.section->table);
  if (topic.section->family != nullptr && !topic.section->family->common.fields.empty())
    tables.push_back(&topic.section->family->common);
  return tables;
}

std::string header_of(const Section& section) {
  switch (section.form) {
    case Section::Form::one:
      return fmt::format("[{}]", section.key);
    case Section::Form::list:
      return fmt::format("[[{}]]", section.key);
    case Section::Form::named:
      return fmt::format("[{}.NAME]", section.key);
  }
  return "";
}

namespace {

/// A shape before a light of the same keyword.
const Topic* find_kind(std::string_view word, const std::vector<Topic>& all) {
  const Topic* found = nullptr;
  for (const Topic& topic : all)
    if (topic.kind != nullptr && topic.kind->name == word && (!found || topic.is_called(word)))
      found = &topic;
  return found;
}

/// "'fov_deg' below [camera]" where a section of which there is one has such a field.
std::string place_of_field(std::string_view word, const std::vector<Topic>& all,
                           const Problems& problems) {
  std::vector<std::string_view> keys;
  std::vector<const Section*> sections;
  for (const Topic& topic : all) {
    if (topic.section->form != Section::Form::one) continue;
    for (const Table* table : tables_of(topic))
      for (const Field& field : table->fields)
        if (std::find(keys.begin(), keys.end(), field.key) == keys.end())
          keys.push_back(field.key), sections.push_back(topic.section);
  }
  const std::string hint = problems.hint_at(word, keys, "");
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (hint == fmt::format("did you mean '{}'?", keys[i]))
      return fmt::format("write {} = … below {}", keys[i], header_of(*sections[i]));
  return "";
}

}  // namespace

std::string hint_at_section(std::string_view word, const Problems& problems) {
  if (problems.enough()) return "";
  const std::vector<Topic> all = topics();
  if (const Topic* const topic = find_kind(word, all))
    return fmt::format("write {} with kind = {}", header_of(*topic->section),
                       in_quotes(topic->kind->name));
  std::vector<std::string_view> sections;
  for (const Section* section : kSections) sections.push_back(section->key);
  const std::string hint = problems.hint_at(word, sections, "sections");
  if (hint.starts_with("did you mean")) return hint;
  if (const std::string field = place_of_field(word, all, problems); !field.empty()) return field;
  std::vector<std::string_view> kinds;
  for (const Topic& topic : all)
    if (topic.kind != nullptr) kinds.push_back(topic.kind->name);
  const std::string kind = problems.hint_at(word, kinds, "");
  for (const std::string_view each : kinds)
    if (kind == fmt::format("did you mean '{}'?", each)) return hint_at_section(each, problems);
  return hint;
}

std::string opening_of(const Topic& topic) {
  std::string text = header_of(*topic.section) + "\n";
  if (topic.kind != nullptr && topic.kind->name != topic.section->family->default_kind)
    text += fmt::format("kind = {}\n", in_quotes(topic.kind->name));
  return text;
}

}  // namespace zraka::language
