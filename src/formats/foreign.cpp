// SPDX-License-Identifier: Apache-2.0
#include "formats/foreign.hpp"

#include <algorithm>
#include <iterator>

#include "core/text.hpp"
#include "formats/formats.hpp"

namespace zraka {
namespace {

std::string_view line_of(std::string_view text, int number) {
  for (; number > 0; --number) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  return trimmed(text.substr(0, text.find('\n')));
}

/// The first line that is neither empty nor a comment, if there is one at the beginning of the
/// text.
std::string_view first_statement(std::string_view text, std::string_view comment) {
  constexpr int kMostLines = 200;
  for (int i = 0; i < kMostLines; ++i) {
    const std::string_view line = line_of(text, i);
    if (!line.empty() && !line.starts_with(comment)) return line;
  }
  return {};
}

bool is_povray(std::string_view text) {
  if (likeness_to_nff(text) == Likeness::sure) return false;  // NFF has comments of this kind
  const std::string_view line = first_statement(text, "//");
  return line.starts_with("#include") || line.starts_with("#version") ||
         line.starts_with("#declare") || line.starts_with("global_settings") ||
         line.starts_with("camera {") || line.starts_with("camera{");
}

struct Known {
  bool (*is)(std::string_view text);
  ForeignFormat name;
};

constexpr Known kKnown[] = {
    {is_povray, {"a POV-Ray scene", "POV-Rayeva scena"}},
    {[](std::string_view t) { return t.starts_with("\x89PNG"); }, {"a PNG picture", "slika PNG"}},
    {[](std::string_view t) { return t.starts_with("\xFF\xD8\xFF"); },
     {"a JPEG picture", "slika JPEG"}},
    {[](std::string_view t) { return t.starts_with("PK\x03\x04"); },
     {"a ZIP archive", "arhiva ZIP"}},
    {[](std::string_view t) { return t.starts_with("%PDF"); }, {"a PDF document", "dokument PDF"}},
};

}  // namespace

ForeignFormat foreign_format_of(std::string_view text) {
  for (const Known& known : kKnown)
    if (known.is(text)) return known.name;
  return {};
}

}  // namespace zraka
