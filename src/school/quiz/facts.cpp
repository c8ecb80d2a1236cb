// SPDX-License-Identifier: Apache-2.0
#include "school/quiz/facts.hpp"

#include "explain/formulas.hpp"
#include "explain/names.hpp"

namespace zraka {
namespace {

class Facts {
 public:
  Facts(Language language, const Explanation& explanation)
      : language_(language),
        e_(explanation),
        rays_(explanation.trees.front().rays),
        hit_(*rays_.front().hit) {}

  std::vector<std::string> list() {
    material();
    for (std::size_t i = 0; i < hit_.lights.size(); ++i) light(i);
    child(hit_.reflected, Word::ray_reflected, Word::no_reflected, hit_.k1);
    child(hit_.refracted, Word::ray_refracted, Word::no_refracted, hit_.k2);
    say(e_.profile.transfer == Transfer::linear ? Word::quiz_stored : Word::quiz_stored_curve);
    return std::move(lines_);
  }

 private:
  template <class... Values>
  std::string text(Word word, const Values&... values) const {
    return zraka::say(language_, word, values...);
  }
  template <class... Values>
  void say(Word word, const Values&... values) {
    lines_.push_back(capitalized(text(word, values...)));
  }
  void material();
  void light(std::size_t i);
  void child(const Child& child, Word ray, Word none, float share);
  std::string reach(const LightTerms& at) const;

  Language language_;
  const Explanation& e_;
  const std::vector<ExplainedRay>& rays_;
  const ExplainedHit& hit_;
  std::vector<std::string> lines_;
};

void Facts::material() {
  say(Word::quiz_hits, label_of(language_, hit_.shape, Case::accusative),
      short_vector(language_, hit_.normal));
  std::string numbers;
  const auto add = [&](const char* name, const std::string& number) {
    numbers +=
        fmt::format("{}{} = {}", numbers.empty() ? "" : between_numbers(language_), name, number);
  };
  if (e_.terms.ambient) {
    add("Ia", short_vector(language_, e_.ambient_light));
    add("ka", short_vector(language_, hit_.ka));
  }
  if (e_.terms.diffuse) add("kd", short_vector(language_, hit_.kd));
  if (e_.terms.specular) {
    add("ks", short_vector(language_, hit_.ks));
    add("n", short_number(language_, hit_.shininess));
  }
  if (e_.terms.reflection) add("k1", short_number(language_, hit_.k1));
  if (e_.terms.refraction) add("k2", short_number(language_, hit_.k2));
  lines_.push_back(numbers);
}

std::string Facts::reach(const LightTerms& at) const {
  switch (at.reach) {
    case Reach::lit:
      return text(Word::reach_lit);
    case Reach::unchecked:
      return text(Word::reach_unchecked);
    case Reach::behind:
      return "";  // L·N says it
    case Reach::dark:
      return "";  // not in the lab
    case Reach::blocked:
      break;
  }
  return text(Word::quiz_blocked, label_of(language_, at.blocker->shape, Case::accusative));
}

void Facts::light(std::size_t i) {
  const LightTerms& at = hit_.lights[i];
  const std::string_view between = between_numbers(language_);
  std::string line = fmt::format("{}: Ii = {}{}L·N = {}", text(Word::light, light_number(i)),
                                 short_vector(language_, e_.lights[i].color), between,
                                 short_number(language_, at.l_n));
  if (at.r_v) line += fmt::format("{}R·V = {}", between, short_number(language_, *at.r_v));
  if (const std::string more = reach(at); !more.empty()) line += fmt::format("; {}", more);
  lines_.push_back(capitalized(line));
}

/// What a ray brings back, or why there is none; nothing where its share is 0.
void Facts::child(const Child& child, Word ray, Word none, float share) {
  if (child.ray >= 0) {
    const Float3& color = rays_[static_cast<std::size_t>(child.ray)].color;
    const std::string name = ray == Word::ray_refracted ? "k2"
                             : child.share == share     ? "k1"
                                                        : "k1 + k2";
    say(Word::quiz_brings, text(ray), name, short_number(language_, child.share),
        short_vector(language_, color));
    return;
  }
  if (child.absence == Absence::depth)
    say(Word::quiz_absent, text(none), text(Word::absent_depth, e_.max_depth));
  if (child.absence == Absence::total)
    say(Word::quiz_absent, text(none),
        fmt::format("{}; {}", text(Word::total_reflection),
                    text(e_.profile.mirror_when_total ? Word::total_mirrored : Word::total_black)));
}

}  // namespace

std::vector<std::string> facts_of(Language language, const Explanation& explanation) {
  return Facts(language, explanation).list();
}

}  // namespace zraka
