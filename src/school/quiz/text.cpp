// SPDX-License-Identifier: Apache-2.0
#include "school/quiz/view.hpp"

namespace zraka {
namespace {

/// Lines, each with something before it.
void add_lines(std::string& out, std::string_view lead, std::string_view lines) {
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    out += fmt::format("{}{}\n", lead, lines.substr(0, end));
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
}

}  // namespace

std::string quiz_text(const Quiz& quiz, const QuizView& view) {
  std::string out;
  for (std::size_t i = 0; i < quiz.questions.size(); ++i) {
    const QuizQuestion& question = quiz.questions[i];
    out += fmt::format("{}{}. {}\n", i == 0 ? "" : "\n", i + 1, question.text);
    if (!view.files.empty())
      for (const QuizQuestion::Shown& shown : question.pictures)
        out += fmt::format("   {}\n      {}\n", shown.caption, view.files[shown.picture]);
    for (const std::string& fact : question.facts) out += fmt::format("   - {}\n", fact);
    for (std::size_t c = 0; c < question.choices.size(); ++c)
      out += fmt::format("   {}  {}\n", letter_of(c), question.choices[c].text);
  }
  if (view.answers) out += fmt::format("\n{}", quiz_answers_text(quiz, view));
  return out;
}

std::string quiz_answers_text(const Quiz& quiz, const QuizView& view) {
  std::string out = fmt::format("{}\n", text_of(view.language, Word::quiz_answers));
  for (std::size_t i = 0; i < quiz.questions.size(); ++i) {
    const QuizQuestion& question = quiz.questions[i];
    out += fmt::format("\n{}. {}  {}\n", i + 1, letter_of(question.answer),
                       question.choices[question.answer].text);
    for (const std::string& reason : question.reason) add_lines(out, "   ", reason);
    add_lines(out, "   ", question.sums);
    for (std::size_t c = 0; c < question.choices.size(); ++c)
      if (const std::string& slip = question.choices[c].reason; !slip.empty())
        out += fmt::format("   {}  {}: {}\n", letter_of(c), question.choices[c].text, slip);
  }
  return out;
}

}  // namespace zraka
