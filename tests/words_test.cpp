// SPDX-License-Identifier: Apache-2.0
#include "core/words.hpp"

#include <gtest/gtest.h>

#include <set>

#include "language.hpp"

namespace zraka {
namespace {

std::multiset<char> places(std::string_view text) {
  std::multiset<char> found;
  for (std::size_t i = 0; i + 2 < text.size(); ++i)
    if (text[i] == '{' && text[i + 2] == '}') found.insert(text[i + 1]);
  return found;
}

TEST(Words, HaveTheSamePlacesInAllLanguages) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(Word::count); ++i) {
    const auto word = static_cast<Word>(i);
    const std::string_view english = text_of(Language::english, word),
                           croatian = text_of(Language::croatian, word);
    EXPECT_FALSE(english.empty()) << name_of(word);
    EXPECT_FALSE(croatian.empty()) << name_of(word);
    EXPECT_EQ(places(english), places(croatian)) << name_of(word);
    const std::string v[] = {"a", "b", "c", "d", "e", "f", "g", "h"};
    for (const Language language : {Language::english, Language::croatian})
      EXPECT_NO_THROW(say(language, word, v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]))
          << name_of(word);
  }
}

TEST(Words, AreNotEnglishInCroatian) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(Word::count); ++i)
    EXPECT_EQ(english_words_in(text_of(Language::croatian, static_cast<Word>(i))), "");
  EXPECT_EQ(english_words_in("zraka hits kuglu"), "hits ");
}

TEST(Words, AreSaidWithValuesInTheirPlaces) {
  EXPECT_EQ(say(Language::english, Word::meets, "sphere 3", "1.5", "(0, 0, 1)"),
            "hits sphere 3 at t = 1.5, in the point (0, 0, 1)");
  EXPECT_EQ(say(Language::croatian, Word::meets, "kuglu 3", "1.5", "(0, 0, 1)"),
            "pogađa kuglu 3 za t = 1.5, u točki (0, 0, 1)");
}

TEST(Words, BeginSentencesWithCapitals) {
  EXPECT_EQ(capitalized("dark"), "Dark");
  EXPECT_EQ(capitalized("čćđšž"), "Čćđšž");
  EXPECT_EQ(capitalized("ćud"), "Ćud");
  EXPECT_EQ(capitalized("đak"), "Đak");
  EXPECT_EQ(capitalized("šum"), "Šum");
  EXPECT_EQ(capitalized("žut"), "Žut");
  EXPECT_EQ(capitalized("Žut"), "Žut");
  EXPECT_EQ(capitalized("79 %"), "79 %");
  EXPECT_EQ(capitalized(""), "");
}

TEST(Words, KnowLanguagesByTheirCodes) {
  EXPECT_EQ(language_named("hr"), Language::croatian);
  EXPECT_EQ(language_named("en"), Language::english);
  EXPECT_EQ(language_named("de"), std::nullopt);
  EXPECT_EQ(code_of(Language::croatian), "hr");
}

}  // namespace
}  // namespace zraka
