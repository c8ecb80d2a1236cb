// SPDX-License-Identifier: Apache-2.0
// The reference in docs/scene-language/.
#include <fmt/format.h>

#include "language/facts.hpp"
#include "language/help.hpp"

namespace zraka::language {
namespace {

/// As it stands in a cell of a table.
std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '<') out += '\\';
    out += c;
  }
  return out;
}

void add_table(const Table& table, std::string& out) {
  out += "| Key | Meaning | Value | |\n|---|---|---|---|\n";
  for (const Field& field : table.fields) {
    const FieldFacts facts = facts_of(field, table);
    std::string meaning = facts.meaning;
    for (const Choice& choice : field.about.choices)
      meaning += fmt::format("; `{}`: {}{}", in_quotes(choice.name), choice.text,
                             choice.built ? "" : " (not built yet)");
    out += fmt::format("| `{}` | {} | {} | {} |\n", facts.key, cell(meaning), cell(facts.value),
                       cell(facts.state));
  }
  for (const Field& field : table.fields)
    if (field.table != nullptr) {
      out += fmt::format("\n`{}`: {}\n\n", field.key, field.table->text);
      add_table(*field.table, out);
    }
}

void add_opening(const Topic& topic, std::string& out) {
  out += fmt::format("```toml\n{}```\n\n", opening_of(topic));
}

void add_family(const Section& section, std::string& out) {
  const Family& family = *section.family;
  if (!family.common.fields.empty()) {
    out += fmt::format("{}\n\n", family.common.text);
    add_table(family.common, out);
    out += "\n";
  }
  for (const Kind* kind : family.kinds) {
    out += fmt::format("### {}\n{}\n\n", kind->table.name, kind->table.text);
    add_opening({kind->name, &section, kind}, out);
    add_table(kind->table, out);
    out += "\n";
  }
  if (!family.not_built.empty())
    out += fmt::format("Not built yet: {}.\n\n", fmt::join(family.not_built, ", "));
}

}  // namespace

std::vector<Page> pages() {
  std::string out =
      "# Reference of the scene language\n"
      "Every section, kind and key, as `zraka help KEYWORD` tells it. This page is made by\n"
      "`zraka help --pages docs/scene-language`: what it says comes from the tables that the "
      "reader uses.\n\n";
  for (const Section* section : kSections) {
    out += fmt::format("## {}\n{}\n\n", header_of(*section), section->text);
    if (section->read == nullptr)
      out += "Not built yet.\n\n";
    else if (section->family != nullptr)
      add_family(*section, out);
    else
      add_table(*section->table, out), out += "\n";
  }
  out.pop_back();
  return {{"reference.md", out}};
}

}  // namespace zraka::language
