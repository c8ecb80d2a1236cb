// SPDX-License-Identifier: Apache-2.0
// Texts in all languages at once, for problems: where one is found, nobody knows yet who will read
// of it.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <zraka/diagnostic.hpp>

#include "core/words.hpp"

namespace zraka {

struct Phrase {
  std::string english, croatian;
};

/// A text of words.def or problems.def with its {0}, {1}… replaced; a value that is a phrase itself
/// is put in in the same language.
template <class... Values>
Phrase phrase(Word word, const Values&... values) {
  [[maybe_unused]] const auto in =
      []<class Value>(Language language, const Value& value) -> const auto& {
    if constexpr (std::is_same_v<Value, Phrase>)
      return language == Language::english ? value.english : value.croatian;
    else
      return value;
  };
  return {say(Language::english, word, in(Language::english, values)...),
          say(Language::croatian, word, in(Language::croatian, values)...)};
}

/// "error", "warning" or "note".
std::string_view text_of(Language language, Severity severity);

/// What the system says of an errno; the reasons that a student meets, in all languages.
Phrase reason_of(int code);

/// One problem of a file as a whole, or of none if `file` is empty.
Diagnostic problem(Severity severity, std::string file, Phrase message, Phrase hint = {});

/// A failed result with one error.
tl::unexpected<Diagnostics> failure(std::string file, Phrase message, Phrase hint = {});

}  // namespace zraka
