// SPDX-License-Identifier: Apache-2.0
#include "school/grade/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/counted.hpp"
#include "core/json.hpp"
#include "core/text.hpp"
#include "explain/names.hpp"
#include "explain/sentence.hpp"
#include "school/mistakes/names.hpp"

namespace zraka {
namespace {

std::string percent(Language language, double share) {
  return share > 0 && share < 0.0005 ? fmt::format("< {} %", decimal(language, 0.1, 1))
                                     : fmt::format("{} %", decimal(language, 100 * share, 1));
}

std::string bytes(const std::array<float, 3>& pixel) {
  const auto byte = [](float v) { return std::lround(255 * static_cast<double>(v)); };
  return fmt::format("({}, {}, {})", byte(pixel[0]), byte(pixel[1]), byte(pixel[2]));
}

}  // namespace

std::string alignment_text(Language language, const Alignment& a) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (a.unpainted) add(say(language, Word::grade_unpainted));
  if (a.transposed) add(say(language, Word::grade_transposed));
  if (a.flipped) add(say(language, Word::grade_turned));
  if (a.scaled)
    add(say(language, Word::grade_scaled, percent(language, a.across), percent(language, a.down)));
  if (a.drawn_width != 0) add(say(language, Word::grade_drawn, a.drawn_width, a.drawn_height));
  if (a.cut)
    add(say(language, Word::grade_cut, decimal(language, a.left, 1), decimal(language, a.top, 1)));
  if (a.swapped) add(say(language, Word::grade_swapped));
  if (a.curve != Alignment::Curve::none) add(say(language, Word::grade_curve));
  return text.empty() ? text : say(language, Word::grade_aligned, text);
}

namespace {

bool costs_nothing(const Grader& grader, const StageGrade& stage) {
  return stage.made_only(
      [&](Mistake mistake) { return grader.rubric().allowed.contains(mistake); });
}

Json json_of(Language language, const Grader& grader, const StageGrade& stage) {
  std::string output;
  for (const std::string& line : findings(language, grader, stage))
    output += (output.empty() ? "" : "\n") + line;
  Json mistakes = Json::array(), pixels = Json::array();
  for (const Mistake mistake : stage.mistakes) mistakes.push_back(entry_of(mistake).key);
  for (const PixelPair& pair : stage.pixels)
    pixels.push_back({{"x", pair.x}, {"y", pair.y}, {"submitted", pair.a}, {"right", pair.b}});
  return {{"name", text_of(language, static_cast<Stage>(stage.stage))},
          {"number", std::to_string(stage.stage)},
          {"score", stage.marks},
          {"max_score", stage.of},
          {"status", stage.marks >= stage.of ? "passed" : "failed"},
          {"output", output},
          {"file", stage.file},
          {"verdict", key_of(stage.verdict)},
          {"mistakes", std::move(mistakes)},
          {"aligned", alignment_text(language, stage.alignment)},
          {"both", stage.both},
          {"visible", stage.alignment.visible},
          {"share_wrong", stage.share_wrong},
          {"share_left", stage.share_left},
          {"right_as", stage.right_as},
          {"pixels", std::move(pixels)}};
}

Json json_of(Language language, const Grader& grader, const Grade& grade) {
  Json tests = Json::array();
  for (const StageGrade& stage : grade.stages) tests.push_back(json_of(language, grader, stage));
  return {{"submission", grade.name},
          {"score", grade.marks},
          {"max_score", grade.of},
          {"output", grade.problems.empty() ? "" : to_string(grade.problems.front(), language)},
          {"tests", std::move(tests)}};
}

}  // namespace

std::string marks_text(Language language, double marks) {
  return with_comma(language, fmt::format("{:.4g}", marks));
}

std::string_view key_of(Verdict verdict) {
  constexpr std::string_view kKeys[] = {"right",   "mistaken", "probably",
                                        "unknown", "missing",  "unreadable"};
  return kKeys[static_cast<std::size_t>(verdict)];
}

char sign_of(Verdict verdict) {
  return "+!~?-x"[static_cast<std::size_t>(verdict)];
}

std::vector<std::string> findings(Language language, const Grader& grader,
                                  const StageGrade& stage) {
  std::vector<std::string> lines;
  if (stage.right_as != 0)
    lines.push_back(say(language, Word::grade_right_as,
                        text_of(language, static_cast<Stage>(stage.right_as))));
  if (stage.right_as != 0 && stage.right_as < stage.stage)
    lines.emplace_back(text_of(language, Word::grade_nothing_added));
  switch (stage.verdict) {
    case Verdict::right:
      lines.emplace_back(text_of(language, Word::grade_right));
      break;
    case Verdict::unknown:
      if (stage.right_as == 0)
        lines.push_back(say(language, Word::grade_differs, percent(language, stage.share_wrong)));
      else if (!stage.mistakes.empty())
        lines.push_back(say(language, Word::grade_perhaps, text_of(language, stage.mistakes[0])));
      break;
    case Verdict::probable:
      lines.push_back(say(language, Word::grade_probable, text_of(language, stage.mistakes[0])));
      lines.push_back(say(language, Word::grade_unexplained, percent(language, stage.share_wrong),
                          percent(language, stage.share_left)));
      break;
    case Verdict::missing:
      lines.emplace_back(text_of(language, Word::grade_missing));
      return lines;
    case Verdict::unreadable:
      lines.emplace_back(text_of(language, Word::grade_unreadable));
      if (!stage.problems.empty()) lines.push_back(to_string(stage.problems.front(), language));
      return lines;
    case Verdict::mistaken:
      for (std::size_t i = 0; i < stage.mistakes.size(); ++i) {
        const std::string text(text_of(language, stage.mistakes[i]));
        lines.push_back(i == 0                 ? text
                        : stage.both && i == 1 ? say(language, Word::grade_and, text)
                                               : say(language, Word::grade_or, text));
      }
      if (costs_nothing(grader, stage))
        lines.emplace_back(text_of(language, Word::grade_allowed));
      else if (stage.repeated)
        lines.emplace_back(text_of(language, Word::grade_repeated));
      lines.push_back(say(language, Word::grade_left, percent(language, stage.share_left)));
      break;
  }
  if (const std::string text = alignment_text(language, stage.alignment); !text.empty())
    lines.push_back(text);
  if (stage.alignment.visible < 0.995)
    lines.push_back(say(language, Word::grade_visible, percent(language, stage.alignment.visible)));
  if (!stage.pixels.empty()) {
    const PixelPair& pair = stage.pixels.front();
    lines.push_back(say(language, Word::grade_pixel, fmt::format("({}, {})", pair.x, pair.y),
                        bytes(pair.a), bytes(pair.b)));
    if (!stage.mistakes.empty())
      if (const std::optional<ToldApart> apart = grader.told_apart(stage)) {
        lines.push_back(say(language, Word::grade_right_pixel, in_words(language, apart->right)));
        lines.push_back(
            say(language, Word::grade_wrong_pixel, in_words(language, apart->mistaken)));
      }
  }
  return lines;
}

std::string grade_text(Language language, const Grader& grader, const Grade& grade) {
  std::string text = fmt::format("{}: {}\n", shown(grade.name),
                                 say(language, Word::grade_marks, marks_text(language, grade.marks),
                                     marks_text(language, grade.of)));
  for (const Diagnostic& problem : grade.problems)
    text += "  " + to_string(problem, language) + "\n";
  for (const StageGrade& stage : grade.stages) {
    const std::vector<std::string> lines = findings(language, grader, stage);
    text += fmt::format("  {}  {}/{}  {}\n", text_of(language, static_cast<Stage>(stage.stage)),
                        marks_text(language, stage.marks), marks_text(language, stage.of),
                        lines.front());
    for (std::size_t i = 1; i < lines.size(); ++i) text += fmt::format("      {}\n", lines[i]);
  }
  return text;
}

std::string grades_table(Language language, const std::vector<Grade>& grades) {
  std::size_t width = 0;
  for (const Grade& grade : grades) width = std::max(width, grade.name.size());
  width = std::min<std::size_t>(width, 40);
  std::string text;
  for (const Grade& grade : grades) {
    text += fmt::format("{:<{}}  {:>5}/{}", shown(grade.name), width,
                        marks_text(language, grade.marks), marks_text(language, grade.of));
    if (!grade.problems.empty()) {
      text += "  " + shown_line(grade.problems.front().message_in(language)) + "\n";
      continue;
    }
    std::set<Mistake> named;
    for (const StageGrade& stage : grade.stages) {
      text += fmt::format(" {}{}", stage.stage, sign_of(stage.verdict));
      if (stage.verdict != Verdict::unknown && !stage.mistakes.empty())
        named.insert(stage.mistakes.front());
    }
    for (const Mistake mistake : named) text += fmt::format("  {}", text_of(language, mistake));
    text += "\n";
  }
  return text;
}

std::string grade_json(Language language, const Grader& grader, const std::vector<Grade>& grades,
                       bool several) {
  Json all = Json::array();
  for (const Grade& grade : grades) all.push_back(json_of(language, grader, grade));
  const Json& json = several ? all : all.front();
  return json.dump(2) + "\n";
}

}  // namespace zraka
