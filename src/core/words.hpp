// SPDX-License-Identifier: Apache-2.0
// What the program says to people in their language. All texts stand in words.def and problems.def.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <zraka/diagnostic.hpp>

namespace zraka {

/// "en" or "hr".
std::optional<Language> language_named(std::string_view name);
std::string_view code_of(Language language);

enum class Word : std::uint16_t {
#define ZRAKA_WORD(name, english, croatian) name,
#include "core/problems.def"
#include "core/words.def"
#undef ZRAKA_WORD
  count
};

std::string_view text_of(Language language, Word word);
/// The name of a word in its list.
std::string_view name_of(Word word);

/// A text with its {0}, {1}… replaced.
template <class... Values>
std::string say(Language language, Word word, const Values&... values) {
  return fmt::format(fmt::runtime(text_of(language, word)), values...);
}

/// A sentence: the first letter large.
std::string capitalized(std::string text);

}  // namespace zraka
