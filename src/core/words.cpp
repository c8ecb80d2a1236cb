// SPDX-License-Identifier: Apache-2.0
#include "core/words.hpp"

#include <cstddef>

namespace zraka {
namespace {

struct Entry {
  std::string_view name, english, croatian;
};

constexpr Entry kEntries[] = {
#define ZRAKA_WORD(name, english, croatian) Entry{#name, english, croatian},
#include "core/problems.def"
#include "core/words.def"
#undef ZRAKA_WORD
};

const Entry& entry(Word word) {
  return kEntries[static_cast<std::size_t>(word)];
}

}  // namespace

std::optional<Language> language_named(std::string_view name) {
  if (name == "en") return Language::english;
  if (name == "hr") return Language::croatian;
  return std::nullopt;
}

std::string_view code_of(Language language) {
  return language == Language::english ? "en" : "hr";
}

std::string_view text_of(Language language, Word word) {
  return language == Language::english ? entry(word).english : entry(word).croatian;
}

std::string_view name_of(Word word) {
  return entry(word).name;
}

std::string capitalized(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  // č ć đ š ž are followed by their capitals' codes less one.
  const bool two = text.size() > 1 && (text[0] == '\xC4' || text[0] == '\xC5');
  if (two && (static_cast<unsigned char>(text[1]) == 0x8D || text[1] == '\x87' ||
              text[1] == '\x91' || text[1] == '\xA1' || text[1] == '\xBE'))
    text[1] = static_cast<char>(text[1] - 1);
  return text;
}

}  // namespace zraka
