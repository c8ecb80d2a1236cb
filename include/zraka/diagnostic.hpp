// SPDX-License-Identifier: Apache-2.0
// What went wrong, where, and what to do about it: the only error type of the public API.
#pragma once

#include <cstddef>
#include <string>
#include <tl/expected.hpp>
#include <vector>
#include <zraka/api.hpp>

namespace zraka {

enum class Severity { note, warning, error };

/// The languages in which people are spoken to.
enum class Language { english, croatian };

/// One problem, in words for people. A file of "" means that no file is concerned; line and column
/// count from 1 (columns in characters, not bytes), and 0 means "the file as a whole".
struct Diagnostic {
  Severity severity = Severity::error;
  std::string file{};
  std::size_t line = 0;
  std::size_t column = 0;
  std::string message{};
  std::string hint{};  ///< what to do about it; may be empty
  std::string
      excerpt{};  ///< the line of the file that is concerned, and a caret below it; may be empty
  /// Message and hint in Croatian, for the problems that a student meets; else empty.
  std::string croatian_message{}, croatian_hint{};

  /// The message in a language, in English where there is no other.
  const std::string& message_in(Language language) const {
    return language == Language::croatian && !croatian_message.empty() ? croatian_message : message;
  }
  const std::string& hint_in(Language language) const {
    return language == Language::croatian && !croatian_message.empty() ? croatian_hint : hint;
  }
};

using Diagnostics = std::vector<Diagnostic>;

/// A value, or all the problems that stood in its way.
template <class T>
using Result = tl::expected<T, Diagnostics>;

/// `file:line:column: error: message`, the excerpt and the hint on lines of their own. Safe on a
/// terminal, whatever the file's name and text hold: controls are replaced.
ZRAKA_API std::string to_string(const Diagnostic& diagnostic,
                                Language language = Language::english);

/// A failed result with one error about a file as a whole (or about none, if `file` is empty).
ZRAKA_API tl::unexpected<Diagnostics> failure(std::string file, std::string message,
                                              std::string hint = {});

}  // namespace zraka
