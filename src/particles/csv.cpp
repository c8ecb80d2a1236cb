// SPDX-License-Identifier: Apache-2.0
// Reader of tables of text: a line of names, then a line for each particle.
#include <fmt/format.h>

#include <algorithm>

#include "particles/rows.hpp"

namespace zraka {
namespace {

struct Header {
  std::string_view line;
  char separator;
  std::vector<std::string_view> names;
};

/// The first line that is not empty, nor a comment before a line that is none; a # before the names
/// does not count.
Header header_of(std::string_view text) {
  const char *at = text.data(), *const end = at + text.size();
  std::string_view line;
  while (at != end) {
    line = line_at(at, end);
    at = behind_line(line, end);
    if (trimmed(line).empty()) continue;
    if (trimmed(line).front() != '#' || at == end || *at != '#') break;
  }
  Header header{line, ' ', {}};
  std::string_view rest = trimmed(line);
  if (rest.starts_with('#')) rest = trimmed(rest.substr(1));
  for (const char separator : {',', ';', '\t'})
    if (rest.find(separator) != std::string_view::npos) {
      header.separator = separator;
      break;
    }
  constexpr std::size_t kMostColumns = 10000;
  while (!rest.empty() && header.names.size() < kMostColumns) {
    const std::size_t stop =
        std::min(header.separator == ' ' ? rest.find_first_of(" \t") : rest.find(header.separator),
                 rest.size());
    std::string_view name = trimmed(rest.substr(0, stop));
    if (name.size() >= 2 && name.front() == '"' && name.back() == '"')
      name = name.substr(1, name.size() - 2);
    header.names.push_back(name);
    rest.remove_prefix(std::min(stop + 1, rest.size()));
    if (header.separator == ' ') rest = trimmed(rest);
  }
  return header;
}

RowLayout layout_of(const Header& header, const ParticleOptions& options) {
  RowLayout layout;
  layout.separator = header.separator;
  layout.species_prefix = "type ";
  for (const std::string_view name : header.names) layout.add(name, options);
  return layout;
}

}  // namespace

bool is_csv(std::string_view text) {
  const Header header = header_of(text);
  return header.names.size() >= 3 && header.line.size() < 60000 &&
         layout_of(header, {}).problem({}).empty();
}

Result<Particles> parse_csv(std::string_view text, const std::string& name,
                            const ParticleOptions& options) {
  TextProblems problems(text, name);
  const Header header = header_of(text);
  RowLayout layout = layout_of(header, options);
  const char* const end = text.data() + text.size();
  const auto refuse = [&](const char* at, std::string message, std::string hint = {}) {
    problems.add(at, std::move(message), std::move(hint));
    return problems.failure();
  };
  if (const std::string problem = layout.problem(options); !problem.empty())
    return refuse(header.line.data() != nullptr ? header.line.data() : end, "the table " + problem,
                  "its first line names the columns, as in x,y,z,radius");
  while (layout.columns.back().field == RowField::skip) layout.columns.pop_back();
  const char* const begin = behind_line(header.line, end);
  const char* last = end;
  while (last != begin && (last[-1] == '\n' || last[-1] == '\r' || last[-1] == ' ')) --last;
  const std::uint64_t count = count_lines(begin, last);
  if (count == 0) return refuse(end, "there are no particles below the names of the columns");
  if (options.frame > 1) return refuse(begin, "a table has one frame only");
  Particles particles;
  read_rows(begin, last, count, layout, particles, problems);
  if (problems.any()) return problems.failure();
  particles.in_angstrom = std::any_of(
      header.names.begin(), header.names.end(),
      [](std::string_view column) { return column == "element" || column == "Element"; });
  return particles;
}

}  // namespace zraka
