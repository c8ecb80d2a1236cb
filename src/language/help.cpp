// SPDX-License-Identifier: Apache-2.0
#include "language/help.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "language/facts.hpp"
#include "materials/glasses.hpp"

namespace zraka::language {
namespace {

/// Words in lines of at most `width` characters, all but the first indented.
std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
  std::string out;
  std::size_t used = 0;
  const auto length = [](std::string_view word) {
    return static_cast<std::size_t>(
        std::count_if(word.begin(), word.end(), [](char c) { return (c & 0xC0) != 0x80; }));
  };
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (used > 0 && used + 1 + length(word) > width) {
      out += '\n' + std::string(indent, ' ');
      used = 0;
    }
    if (used > 0) out += ' ', ++used;
    out += word;
    used += length(word);
  }
  return out;
}

constexpr std::size_t kLine = 96;

void add_choices(const Field& field, std::size_t indent, std::string& out) {
  for (const Choice& choice : field.about.choices)
    out += std::string(indent, ' ') +
           wrapped(fmt::format("{}: {}", in_quotes(choice.name), choice.text), kLine - indent,
                   indent + 2) +
           "\n";
}

void add_fields(const Table& table, std::size_t indent, std::string& out) {
  std::size_t widest = 0;
  for (const Field& field : table.fields) widest = std::max(widest, field.key.size());
  const std::size_t column = indent + widest + 2;
  for (const Field& field : table.fields) {
    const FieldFacts facts = facts_of(field, table);
    std::string words = facts.meaning;
    if (!facts.value.empty()) words += ": " + facts.value;
    if (!facts.state.empty()) words += "; " + facts.state;
    out += fmt::format("{}{:<{}}  {}\n", std::string(indent, ' '), facts.key, widest,
                       wrapped(words, kLine - column, column));
    add_choices(field, column, out);
    for (const Table* inner : field.tables) {
      if (field.tables.size() > 1)
        out += std::string(column, ' ') +
               wrapped(fmt::format("{}: {}", form_of(field, *inner), inner->text), kLine - column,
                       column + 2) +
               "\n";
      add_fields(*inner, column + (field.tables.size() > 1 ? 2 : 0), out);
    }
  }
}

void add_names(std::string_view title, const std::vector<std::string_view>& names,
               std::string& out) {
  if (!names.empty())
    out +=
        "  " + wrapped(fmt::format("{}: {}", title, fmt::join(names, ", ")), kLine - 2, 4) + "\n";
}

std::string help_on(const Topic& topic) {
  const Section& section = *topic.section;
  std::string out = topic.kind != nullptr
                        ? fmt::format("{}: {}\n\n", topic.kind->table.name, topic.kind->table.text)
                        : fmt::format("{}: {}\n\n", section.key, wrapped(section.text, kLine, 0));
  const std::string opening = opening_of(topic);
  for (std::size_t begin = 0; begin < opening.size();) {
    const std::size_t end = opening.find('\n', begin) + 1;
    out += "  " + opening.substr(begin, end - begin);
    begin = end;
  }
  for (const Table* table : tables_of(topic)) add_fields(*table, 2, out);
  std::vector<std::string_view> names;
  if (topic.kind == nullptr && section.family != nullptr)
    for (const Kind* kind : section.family->kinds) names.push_back(kind->name);
  add_names("kinds", names, out);
  names.clear();
  for (const Table* table : tables_of(topic))
    for (const Field& field : table->fields)
      if (field.about.unit == Unit::name_of_glass)
        for (const Glass& glass : glasses()) names.push_back(glass.name);
  add_names("glasses", names, out);
  return out;
}

}  // namespace

std::vector<std::string_view> keywords() {
  std::vector<std::string_view> all;
  for (const Topic& topic : topics())
    if (std::find(all.begin(), all.end(), topic.keyword) == all.end()) all.push_back(topic.keyword);
  return all;
}

std::string keywords_in_lines(std::string_view title) {
  return wrapped(fmt::format("{}{}", title, fmt::join(keywords(), ", ")), kLine, 2) + "\n";
}

std::optional<std::string> help_on(std::string_view keyword) {
  std::string out;
  const std::vector<Topic> all = topics();
  for (const bool called : {true, false})
    for (const Topic& topic : all)
      if (topic.is_called(keyword) == called &&
          (called || topic.keyword == keyword ||
           (topic.kind == nullptr && fmt::format("{} section", topic.keyword) == keyword)))
        out += (out.empty() ? "" : "\n") + help_on(topic);
  return out.empty() ? std::nullopt : std::optional(out);
}

}  // namespace zraka::language
