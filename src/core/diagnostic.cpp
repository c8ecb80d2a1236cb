// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <zraka/diagnostic.hpp>

#include "core/phrase.hpp"
#include "core/text.hpp"

namespace zraka {

std::string to_string(const Diagnostic& d, Language language) {
  std::string text;
  if (!d.file.empty()) {
    text += shown_line(d.file);
    if (d.line > 0) text += fmt::format(":{}", d.line);
    if (d.line > 0 && d.column > 0) text += fmt::format(":{}", d.column);
    text += ": ";
  }
  text +=
      fmt::format("{}: {}\n", text_of(language, d.severity), shown_text(d.message_in(language)));
  const std::string excerpt = shown_text(d.excerpt);
  std::string_view rest = excerpt;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    text += fmt::format("  {}\n", rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  if (const std::string& hint = d.hint_in(language); !hint.empty())
    text += fmt::format("  {}\n", shown_text(hint));
  return text;
}

tl::unexpected<Diagnostics> failure(std::string file, std::string message, std::string hint) {
  Diagnostic d;
  d.file = std::move(file);
  d.message = std::move(message);
  d.hint = std::move(hint);
  return tl::make_unexpected(Diagnostics{std::move(d)});
}

std::string_view text_of(Language language, Severity severity) {
  constexpr Word kSeverities[] = {Word::severity_note, Word::severity_warning,
                                  Word::severity_error};
  return text_of(language, kSeverities[static_cast<int>(severity)]);
}

Phrase reason_of(int code) {
  switch (code) {
    case ENOENT:
      return phrase(Word::path_not_there);
    case EACCES:
      return phrase(Word::path_not_allowed);
    case ENOSPC:
      return phrase(Word::path_no_space);
    case ENOTDIR:
      return phrase(Word::path_no_folder_there);
    case EISDIR:
      return phrase(Word::path_folder_there_instead);
    case EROFS:
      return phrase(Word::path_only_read);
    case ELOOP:
      return phrase(Word::path_link_loop);
    default:
      return {std::strerror(code), std::strerror(code)};
  }
}

tl::unexpected<Diagnostics> failure(std::string file, Phrase message, Phrase hint) {
  return tl::make_unexpected(
      Diagnostics{problem(Severity::error, std::move(file), std::move(message), std::move(hint))});
}

Diagnostic problem(Severity severity, std::string file, Phrase message, Phrase hint) {
  Diagnostic d;
  d.severity = severity;
  d.file = std::move(file);
  d.message = std::move(message.english);
  d.hint = std::move(hint.english);
  d.croatian_message = std::move(message.croatian);
  d.croatian_hint = std::move(hint.croatian);
  return d;
}

}  // namespace zraka
