// SPDX-License-Identifier: Apache-2.0
#include "school/grade/rubric.hpp"

#include <algorithm>

#include "core/file.hpp"
#include "core/json.hpp"
#include "core/phrase.hpp"
#include "core/text.hpp"

namespace zraka {

Rubric default_rubric() {
  Rubric rubric;
  for (const MistakeEntry& entry : lab_mistakes())
    if (entry.allowed) rubric.allowed.insert(entry.mistake);
  return rubric;
}

Result<Rubric> read_rubric(const std::string& path) {
  constexpr std::string_view kKeys = "marks, tolerance, share, for_mistake, once, allowed";
  constexpr std::uint64_t kMostOfRubric = std::uint64_t{1} << 16;
  const Result<std::string> text = read_file(path, kMostOfRubric);
  if (!text) return tl::make_unexpected(text.error());
  const Result<Json> json = Json::parse(*text, path);
  if (!json) return tl::make_unexpected(json.error());
  if (!json->is_object())
    return failure(path, phrase(Word::rubric_no_object),
                   phrase(Word::rubric_shown, "docs/grade.md"));
  Rubric rubric = default_rubric();
  const auto number = [&](const std::string& key, const Json& value, double most,
                          double& to) -> Result<void> {
    double read = 0;
    if (!value.get_number(read) || !(read >= 0 && read <= most))
      return failure(path, phrase(Word::rubric_number, key, most));
    to = read;
    return {};
  };
  for (const auto& [key, value] : *json->if_object()) {
    Result<void> good;
    if (key == "tolerance") {
      good = number(key, value, 255, rubric.tolerance);
    } else if (key == "share") {
      good = number(key, value, 1, rubric.share);
    } else if (key == "for_mistake") {
      good = number(key, value, 1, rubric.for_mistake);
    } else if (key == "once") {
      if (value.if_bool() == nullptr)
        return failure(path, phrase(Word::rubric_once, key,
                                    phrase(Word::rubric_true_or_false, "true", "false")));
      rubric.once = *value.if_bool();
    } else if (key == "marks") {
      if (!value.is_array() || value.size() != rubric.marks.size())
        return failure(path, phrase(Word::rubric_seven, key));
      for (std::size_t i = 0; i < rubric.marks.size(); ++i)
        if (!(*value.if_array())[i].get_number(rubric.marks[i]) || !(rubric.marks[i] >= 0))
          return failure(path, phrase(Word::rubric_mark, key, i + 1));
    } else if (key == "allowed") {
      if (!value.is_array()) return failure(path, phrase(Word::rubric_allowed, key));
      rubric.allowed.clear();
      for (const Json& one : *value.if_array()) {
        const std::string name = one.if_string() != nullptr ? *one.if_string() : one.dump();
        const std::optional<Mistake> mistake = mistake_named(name);
        if (!mistake)
          return failure(path, phrase(Word::rubric_no_mistake, key, shown(name)),
                         phrase(Word::rubric_list, "zraka grade --list"));
        rubric.allowed.insert(*mistake);
      }
    } else {
      return failure(path, phrase(Word::rubric_unknown, shown(key)),
                     Phrase{std::string(kKeys), std::string(kKeys)});
    }
    if (!good) return tl::make_unexpected(good.error());
  }
  return rubric;
}

void mark(const Rubric& rubric, std::vector<StageGrade>& grades) {
  std::set<Mistake> before;
  for (StageGrade& grade : grades) {
    grade.of = rubric.marks[static_cast<std::size_t>(grade.stage - 1)];
    if (grade.verdict == Verdict::right) grade.marks = grade.of;
    if (grade.verdict != Verdict::mistaken && grade.verdict != Verdict::probable) continue;
    const auto allowed = [&](Mistake mistake) { return rubric.allowed.contains(mistake); };
    const auto counted = [&](Mistake mistake) {
      return allowed(mistake) || (rubric.once && before.contains(mistake));
    };
    grade.repeated = grade.made_only([&](Mistake mistake) { return before.contains(mistake); });
    // What is only probable leaves something that nobody has looked at.
    const bool free = grade.verdict == Verdict::mistaken && grade.made_only(counted);
    grade.marks = free ? grade.of : grade.of * rubric.for_mistake;
    before.insert(grade.mistakes.begin(), grade.mistakes.end());
  }
}

}  // namespace zraka
