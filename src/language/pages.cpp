// SPDX-License-Identifier: Apache-2.0
// The reference in docs/scene-language/.
#include <fmt/format.h>

#include "language/facts.hpp"
#include "language/help.hpp"
#include "materials/dispersion.hpp"
#include "materials/glasses.hpp"

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
      meaning += fmt::format("; `{}`: {}", in_quotes(choice.name), choice.text);
    out += fmt::format("| `{}` | {} | {} | {} |\n", facts.key, cell(meaning), cell(facts.value),
                       cell(facts.state));
  }
  for (const Field& field : table.fields)
    for (const Table* inner : field.tables) {
      const std::string which =
          field.about.by_kind       ? fmt::format(" of kind `{}`", in_quotes(inner->name))
          : field.tables.size() > 1 ? fmt::format(" as `{}`", form_of(field, *inner))
                                    : "";
      out += fmt::format("\n`{}`{}: {}\n\n", field.key, which, inner->text);
      add_table(*inner, out);
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
}

std::string glasses_page() {
  std::string out =
      "# Glasses, crystals, plastics and liquids\n"
      "What `glass = \"…\"` of a material can be, in any case. It sets `ior`, the index at the "
      "line d (587.56 nm), and\n"
      "`dispersion`. V is Abbe's number, (n_d - 1)/(n_F - n_C). This page is made by\n"
      "`zraka help --pages docs/scene-language`.\n\n"
      "| Name | n_d | V | Formula | Coefficients (λ in µm) | Source |\n|---|---|---|---|---|---|\n";
  const std::span<const Glass> all = glasses();
  for (std::size_t i = 0, next = 0; i < all.size(); i = next) {
    // Several names of one stand in one row.
    const Glass& glass = all[i];
    std::string names;
    for (; next < all.size() && all[next].dispersion == glass.dispersion; ++next)
      names += fmt::format("{}{}", names.empty() ? "" : ", ", all[next].name);
    const bool cauchy = glass.dispersion.kind == Dispersion::Kind::cauchy;
    out += fmt::format("| {} | {:.5f} | {:.2f} | {} | {} | {} |\n", names, glass.ior(),
                       abbe_number(glass.dispersion, 1), cauchy ? "Cauchy" : "Sellmeier",
                       fmt::join(std::span(glass.dispersion.numbers).first(cauchy ? 3 : 6), ", "),
                       glass.source);
  }
  return out;
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
    if (section->family != nullptr)
      add_family(*section, out);
    else
      add_table(*section->table, out), out += "\n";
  }
  out.pop_back();
  return {{"reference.md", out}, {"glasses.md", glasses_page()}};
}

}  // namespace zraka::language
