// SPDX-License-Identifier: Apache-2.0
// Finds English words where only Croatian ones may be.
#pragma once

#include <set>
#include <string>

#include "core/words.hpp"

namespace zraka {

/// Calls function(word) for each run of letters, Croatian ones among them, in small letters.
template <class Function>
void each_word(std::string_view text, const Function& function) {
  std::string word;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char c = i < text.size() ? text[i] : ' ';
    const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    if (c == '\xC4' || c == '\xC5') {
      word += text.substr(i++, 2);
    } else if (lower >= 'a' && lower <= 'z') {
      word += lower;
    } else {
      if (!word.empty()) function(word);
      word.clear();
    }
  }
}

/// The words of a text that words.def has in English, and that are no Croatian words as well.
inline std::string english_words_in(std::string_view text) {
  static const std::set<std::string> english = [] {
    std::set<std::string> words;
    for (std::size_t i = 0; i < static_cast<std::size_t>(Word::count); ++i)
      each_word(text_of(Language::english, static_cast<Word>(i)), [&](const std::string& word) {
        if (word.size() > 1) words.insert(word);
      });
    for (const char* both :
         {"to",  "no",   "on",      "do",   "zraka", "javascript", "program", "srgb", "input",
          "txt", "png", "pdf",  "jpeg",    "gzip", "utf",   "docs",       "nff",     "toml", "md",
          "bmp", "tga",
          "zip", "json", "ppm",     "pgm",  "pfm",   "exr",        "mib",     "kd",   "ka",
          "ks",  "ni",   "openexr", "cmyk", "width", "radiance",   "hdr",    "fresnel", "particles", "tachyon", "gltf"})
      words.erase(both);
    return words;
  }();
  std::string found;
  each_word(text, [&](const std::string& word) {
    if (english.contains(word)) found += word + " ";
  });
  return found;
}

}  // namespace zraka
