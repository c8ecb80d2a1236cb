// SPDX-License-Identifier: Apache-2.0
// Asks in turns, until there are enough questions or nothing is left to ask.
#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <zraka/school/quiz.hpp>

#include "core/phrase.hpp"
#include "image/page_picture.hpp"
#include "render/prepare.hpp"
#include "school/quiz/ask.hpp"

namespace zraka {
namespace {

constexpr std::string_view kKindNames[] = {"stage", "mistake", "color"};

Diagnostics problems_of(const QuizOptions& options) {
  Diagnostics problems;
  const auto add = [&](std::string message, std::string hint) {
    problems.push_back({.message = std::move(message), .hint = std::move(hint)});
  };
  if (options.questions < 1 || options.questions > kMaxQuestions)
    add(fmt::format("{} questions are out of range", options.questions),
        fmt::format("1 to {} can be asked for", +kMaxQuestions));
  if (options.kinds.empty()) add("no kind of question is asked for", "stage, mistake or color");
  if (!language_named(options.language))
    add(fmt::format("there are no words in the language '{}'", options.language), "en or hr");
  return problems;
}

/// Each kind asks the same questions whichever others are asked beside it.
std::vector<std::unique_ptr<Asker>> askers_of(Studio& studio, const QuizOptions& options) {
  const Language language = *language_named(options.language);
  Random seeds(options.seed);
  std::vector<std::unique_ptr<Asker>> askers;
  for (const QuizKind kind : kQuizKinds) {
    const std::uint64_t seed = seeds.next();
    if (!options.kinds.contains(kind)) continue;
    askers.push_back(kind == QuizKind::color ? make_color_asker(studio, language, seed)
                                             : make_variant_asker(studio, language, kind, seed));
  }
  seeds.shuffle(askers);
  return askers;
}

Result<Quiz> asked(Studio& studio, const QuizOptions& options) {
  Quiz quiz;
  const Result<std::size_t> right = add_picture(quiz, studio.right());
  if (!right) return tl::make_unexpected(right.error());
  std::vector<std::unique_ptr<Asker>> askers = askers_of(studio, options);
  const auto wanted = static_cast<std::size_t>(options.questions);
  for (std::size_t turn = 0; !askers.empty() && quiz.questions.size() < wanted;) {
    turn %= askers.size();
    Result<std::optional<QuizQuestion>> question = askers[turn]->next(quiz);
    if (!question) return tl::make_unexpected(question.error());
    if (*question) {
      quiz.questions.push_back(std::move(**question));
      ++turn;
    } else {
      askers.erase(askers.begin() + static_cast<std::ptrdiff_t>(turn));
    }
  }
  if (quiz.questions.empty() && is_beyond_the_lab(studio.scene(), studio.options()))
    return failure("", phrase(Word::quiz_beyond), phrase(Word::mistake_rules));
  if (quiz.questions.empty())
    return failure("", phrase(Word::quiz_nothing), phrase(Word::quiz_needs));
  return quiz;
}

}  // namespace

std::string_view name_of(QuizKind kind) {
  return kKindNames[static_cast<int>(kind)];
}

std::optional<QuizKind> quiz_kind_named(std::string_view name) {
  for (const QuizKind kind : kQuizKinds)
    if (name == name_of(kind)) return kind;
  return std::nullopt;
}

std::string color_text(const std::array<std::uint8_t, 3>& color) {
  return fmt::format("({}, {}, {})", color[0], color[1], color[2]);
}

Result<std::size_t> add_picture(Quiz& quiz, const Image& stored) {
  Result<std::string> png = png_for_page(stored);
  if (!png) return tl::make_unexpected(png.error());
  quiz.pictures.push_back({stored.width, stored.height, std::move(*png)});
  return quiz.pictures.size() - 1;
}

void set_choices(QuizQuestion& question, QuizChoice right, std::vector<QuizChoice> wrong,
                 Random& random) {
  question.choices = std::move(wrong);
  random.shuffle(question.choices);
  question.answer = static_cast<std::size_t>(random.below(question.choices.size() + 1));
  question.choices.insert(question.choices.begin() + static_cast<std::ptrdiff_t>(question.answer),
                          std::move(right));
}

Result<Quiz> make_quiz(const Scene& scene, const RenderOptions& options, const QuizOptions& quiz) {
  Diagnostics problems = problems_of(quiz);
  if (!problems.empty()) return tl::make_unexpected(std::move(problems));
  try {
    Result<Studio> studio = Studio::create(scene, options);
    if (!studio) return tl::make_unexpected(studio.error());
    return asked(*studio, quiz);
  } catch (const std::bad_alloc&) {
    return failure("", phrase(Word::quiz_memory), phrase(Word::quiz_smaller));
  }
}

}  // namespace zraka
