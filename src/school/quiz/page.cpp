// SPDX-License-Identifier: Apache-2.0
// The quiz as a page: to answer at a screen, or to print for a class.
#include "core/append.hpp"
#include "core/base64.hpp"
#include "core/page_css.hpp"
#include "core/text.hpp"
#include "explain/names.hpp"
#include "school/quiz/view.hpp"

namespace zraka {
namespace {

constexpr std::string_view kPageCss =
#include "school/quiz/page.css.inc"
    ;
constexpr std::string_view kPageJs =
#include "school/quiz/page.js.inc"
    ;

class Page {
 public:
  Page(const Quiz& quiz, const QuizView& view) : quiz_(quiz), view_(view) {}

  std::string questions();
  std::string answers();

 private:
  template <class... Values>
  std::string say(Word word, const Values&... values) const {
    return html_text(zraka::say(view_.language, word, values...));
  }
  template <class... Values>
  void put(fmt::format_string<Values...> text, Values&&... values) {
    append(out_, text, std::forward<Values>(values)...);
  }

  void head(Word title, bool with_seed);
  void question(std::size_t i);
  void pictures(const QuizQuestion& question);
  void choices(const QuizQuestion& question);
  void reasons(const QuizQuestion& question);
  std::string choice_text(QuizKind kind, std::size_t position, const QuizChoice& choice) const;

  const Quiz& quiz_;
  const QuizView& view_;
  std::string out_;
};

void Page::head(Word title, bool with_seed) {
  put("<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>\n{}{}</style>\n</head>\n<body>\n<header>\n<h1>{}</h1>\n",
      code_of(view_.language), say(title), kSharedCss, kPageCss, say(title));
  put("<p class=\"scene\">{}{}</p>\n",
      say(Word::report_scene, view_.scene,
          fmt::format("{}×{}", view_.resolution.width, view_.resolution.height),
          zraka::say(view_.language, word_of(view_.profile)), view_.max_depth),
      with_seed ? fmt::format(". {}", say(Word::quiz_seed, view_.seed)) : "");
}

/// "B" and what it says; a colour with a patch of it.
std::string Page::choice_text(QuizKind kind, std::size_t position, const QuizChoice& choice) const {
  std::string text = fmt::format("<b>{}</b>", letter_of(position));
  if (kind == QuizKind::color)
    text += fmt::format("<span class=\"swatch\" style=\"background:rgb{}\"></span>", choice.text);
  return text + fmt::format("<span>{}</span>", html_text(choice.text));
}

void Page::pictures(const QuizQuestion& question) {
  put("<div class=\"pictures\">\n");
  for (const QuizQuestion::Shown& shown : question.pictures) {
    const QuizPicture& picture = quiz_.pictures[shown.picture];
    const std::string caption = html_text(shown.caption);
    put("<figure><img src=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\"><figcaption>{}</figcaption>"
        "</figure>\n",
        data_url(picture), caption, picture.width, picture.height, caption);
  }
  if (!question.facts.empty()) {
    put("<ul class=\"facts\">\n");
    for (const std::string& fact : question.facts) put("<li>{}</li>\n", html_text(fact));
    put("</ul>\n");
  }
  put("</div>\n");
}

/// Something to press where the page knows the answer, something to tick where it does not.
void Page::choices(const QuizQuestion& question) {
  put("<ul class=\"choices\">\n");
  for (std::size_t c = 0; c < question.choices.size(); ++c) {
    const std::string text = choice_text(question.kind, c, question.choices[c]);
    if (view_.answers)
      put("<li><button type=\"button\" class=\"choice\" data-choice=\"{}\">{}</button></li>\n", c,
          text);
    else
      put("<li><div class=\"choice\">{}</div></li>\n", text);
  }
  put("</ul>\n");
}

void Page::reasons(const QuizQuestion& question) {
  put("<p class=\"right\" data-right=\"{}\">{}</p>\n", question.answer,
      choice_text(question.kind, question.answer, question.choices[question.answer]));
  for (const std::string& reason : question.reason) put("<p>{}</p>\n", html_prose(reason));
  if (!question.sums.empty()) put("<pre>{}</pre>\n", html_text(question.sums));
  if (question.kind != QuizKind::color) return;
  put("<ul class=\"slips\">\n");
  for (std::size_t c = 0; c < question.choices.size(); ++c)
    if (const QuizChoice& choice = question.choices[c]; !choice.reason.empty())
      put("<li>{}<span>{}</span></li>\n", choice_text(question.kind, c, choice),
          html_text(choice.reason));
  put("</ul>\n");
}

void Page::question(std::size_t i) {
  const QuizQuestion& question = quiz_.questions[i];
  put("<article class=\"{}\">\n<h2>{}</h2>\n<p class=\"ask\">{}</p>\n", name_of(question.kind),
      say(Word::quiz_question, i + 1), html_text(question.text));
  pictures(question);
  choices(question);
  if (view_.answers) {
    put("<details>\n<summary>{}</summary>\n", say(Word::quiz_answer));
    reasons(question);
    put("</details>\n");
  }
  put("</article>\n");
}

std::string Page::questions() {
  head(Word::quiz_title, view_.answers);
  if (!view_.answers) put("<p class=\"name\">{}</p>\n", say(Word::quiz_name));
  put("</header>\n<main data-good=\"{}\" data-bad=\"{}\">\n", say(Word::grade_right),
      say(Word::quiz_wrong));
  for (std::size_t i = 0; i < quiz_.questions.size(); ++i) question(i);
  put("</main>\n");
  if (view_.answers)
    put("<p class=\"score\" hidden><output data-text=\"{}\"></output>\n"
        "<button type=\"button\">{}</button></p>\n",
        html_text(text_of(view_.language, Word::quiz_score)), say(Word::quiz_again));
  put("<footer>{}</footer>\n", say(Word::quiz_made_by));
  if (view_.answers) put("<script>\n{}</script>\n", kPageJs);
  put("</body>\n</html>\n");
  return std::move(out_);
}

std::string Page::answers() {
  head(Word::quiz_answers_title, true);
  put("</header>\n<main>\n");
  for (std::size_t i = 0; i < quiz_.questions.size(); ++i) {
    const QuizQuestion& question = quiz_.questions[i];
    put("<article class=\"{}\">\n<h2>{}</h2>\n<p class=\"ask\">{}</p>\n", name_of(question.kind),
        say(Word::quiz_question, i + 1), html_text(question.text));
    reasons(question);
    put("</article>\n");
  }
  put("</main>\n<footer>{}</footer>\n</body>\n</html>\n", say(Word::quiz_made_by));
  return std::move(out_);
}

}  // namespace

std::string data_url(const QuizPicture& picture) {
  return "data:image/png;base64," + base64(picture.png);
}

std::string quiz_page(const Quiz& quiz, const QuizView& view) {
  return Page(quiz, view).questions();
}

std::string quiz_answers_page(const Quiz& quiz, const QuizView& view) {
  return Page(quiz, view).answers();
}

}  // namespace zraka
