// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <zraka/diagnostic.hpp>

#include "core/text.hpp"

namespace zraka {

std::string to_string(const Diagnostic& d) {
  std::string text;
  if (!d.file.empty()) {
    text += shown_line(d.file);
    if (d.line > 0) text += fmt::format(":{}", d.line);
    if (d.line > 0 && d.column > 0) text += fmt::format(":{}", d.column);
    text += ": ";
  }
  constexpr const char* kNames[] = {"note", "warning", "error"};
  text += fmt::format("{}: {}\n", kNames[static_cast<int>(d.severity)], shown_text(d.message));
  const std::string excerpt = shown_text(d.excerpt);
  std::string_view rest = excerpt;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    text += fmt::format("  {}\n", rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  if (!d.hint.empty()) text += fmt::format("  {}\n", shown_text(d.hint));
  return text;
}

tl::unexpected<Diagnostics> failure(std::string file, std::string message, std::string hint) {
  Diagnostic d;
  d.file = std::move(file);
  d.message = std::move(message);
  d.hint = std::move(hint);
  return tl::make_unexpected(Diagnostics{std::move(d)});
}

}  // namespace zraka
