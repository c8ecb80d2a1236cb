// SPDX-License-Identifier: Apache-2.0

#include "core/json.hpp"

#include "school/quiz/view.hpp"

namespace zraka {
namespace {

std::string text_of_json(const Json& json) {
  return json.dump(2) + "\n";
}

Json choice_json(QuizKind kind, const QuizChoice& choice) {
  Json json = {{"text", choice.text}};
  if (kind == QuizKind::mistake) json["mistake"] = entry_of(choice.mistake).key;
  if (kind == QuizKind::color) json["color"] = choice.color;
  return json;
}

Json pictures_json(const Quiz& quiz, const QuizView& view, const QuizQuestion& question) {
  Json pictures = Json::array();
  for (const QuizQuestion::Shown& shown : question.pictures)
    pictures.push_back({{"caption", shown.caption},
                        {"src", view.files.empty() ? data_url(quiz.pictures[shown.picture])
                                                   : view.files[shown.picture]}});
  return pictures;
}

void add_answer(Json& json, const QuizQuestion& question) {
  json["answer"] = question.answer;
  json["reason"] = question.reason;
  json["pixel"] = {question.x, question.y};
  if (question.kind != QuizKind::color) return;
  json["sums"] = question.sums;
  Json slips = Json::array();
  for (const QuizChoice& choice : question.choices)
    slips.push_back(choice.reason.empty() ? Json() : Json(choice.reason));
  json["slips"] = slips;
}

}  // namespace

std::string quiz_json(const Quiz& quiz, const QuizView& view) {
  Json questions = Json::array();
  for (const QuizQuestion& question : quiz.questions) {
    Json json = {{"kind", name_of(question.kind)},
                 {"question", question.text},
                 {"pictures", pictures_json(quiz, view, question)}};
    if (!question.facts.empty()) json["facts"] = question.facts;
    for (const QuizChoice& choice : question.choices)
      json["choices"].push_back(choice_json(question.kind, choice));
    if (view.answers) add_answer(json, question);
    questions.push_back(std::move(json));
  }
  return text_of_json(questions);
}

std::string quiz_answers_json(const Quiz& quiz) {
  Json answers = Json::array();
  for (const QuizQuestion& question : quiz.questions) {
    Json json = {{"kind", name_of(question.kind)},
                 {"question", question.text},
                 {"right", question.choices[question.answer].text}};
    add_answer(json, question);
    answers.push_back(std::move(json));
  }
  return text_of_json(answers);
}

}  // namespace zraka
