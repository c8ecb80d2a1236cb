// SPDX-License-Identifier: Apache-2.0
// The scene language explained: for the terminal, as pages of documentation, and as a schema for
// editors. All of it comes from the tables that the reader uses.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zraka::language {

/// What help_on() knows: sections and kinds, each once.
std::vector<std::string_view> keywords();

/// The same in lines behind a title.
std::string keywords_in_lines(std::string_view title);

/// All about a section ("render" or "render section") or a kind; none where there is no such
/// keyword.
std::optional<std::string> help_on(std::string_view keyword);

struct Page {
  std::string name;  ///< of the file in docs/scene-language/
  std::string text;  ///< Markdown
};
std::vector<Page> pages();

/// JSON Schema (draft 7) of files whose TOML has been made JSON.
std::string json_schema();

}  // namespace zraka::language
