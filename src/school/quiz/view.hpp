// SPDX-License-Identifier: Apache-2.0
// A quiz as a page for browsers, as JSON and as text.
#pragma once

#include <string>
#include <vector>
#include <zraka/school/quiz.hpp>

#include "core/words.hpp"

namespace zraka {

struct QuizView {
  Language language = Language::english;
  std::string scene{};  ///< its name
  Resolution resolution{};
  ProfileName profile = ProfileName::physical;
  int max_depth = 4;
  std::uint64_t seed = 1;
  /// Does the quiz hold its answers? Else nothing of them is in it, the seed neither.
  bool answers = true;
  /// Names of the pictures' files, in Quiz's order; empty where pictures come as data URLs.
  std::vector<std::string> files{};
};

/// A self-contained page. With answers each unfolds when a choice is made, or by hand.
std::string quiz_page(const Quiz& quiz, const QuizView& view);
/// The answers alone, as a page.
std::string quiz_answers_page(const Quiz& quiz, const QuizView& view);

/// JSON (docs/quiz.md): an array of questions.
std::string quiz_json(const Quiz& quiz, const QuizView& view);
std::string quiz_answers_json(const Quiz& quiz);

/// For a terminal. Pictures are shown by their files' names, and not at all without.
std::string quiz_text(const Quiz& quiz, const QuizView& view);
std::string quiz_answers_text(const Quiz& quiz, const QuizView& view);

/// What a choice is called: A, B, C, D.
inline char letter_of(std::size_t choice) {
  return static_cast<char>('A' + choice);
}

/// A picture as a page or JSON holds it.
std::string data_url(const QuizPicture& picture);

}  // namespace zraka
