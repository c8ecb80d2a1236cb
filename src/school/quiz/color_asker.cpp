// SPDX-License-Identifier: Apache-2.0
// What colour has this pixel?
#include <algorithm>
#include <cstdlib>
#include <set>

#include "explain/names.hpp"
#include "explain/sentence.hpp"
#include "explain/text.hpp"
#include "render/prepare.hpp"
#include "school/mistakes/names.hpp"
#include "school/quiz/ask.hpp"
#include "school/quiz/cover.hpp"
#include "school/quiz/facts.hpp"
#include "school/quiz/slips.hpp"

namespace zraka {
namespace {

using Bytes = std::array<std::uint8_t, 3>;

/// A pixel with more lights has too many numbers for one question.
constexpr std::size_t kMostLights = 4;
/// Pixels that are tried for a question with all its wrong choices.
constexpr int kTries = 40;
/// Choices are at least this far apart in some channel, of 255.
constexpr int kApart = 10;

/// Mistakes that whoever sums up this pixel can make; others show another place, or another ray.
constexpr Mistake kInTheSum[] = {Mistake::ambient_unscaled,
                                 Mistake::ambient_per_light,
                                 Mistake::facing_unchecked,
                                 Mistake::facing_magnitude,
                                 Mistake::light_reversed,
                                 Mistake::light_not_unit,
                                 Mistake::diffuse_sine,
                                 Mistake::mirror_reversed,
                                 Mistake::half_vector,
                                 Mistake::highlight_unchecked,
                                 Mistake::no_power,
                                 Mistake::specular_is_diffuse,
                                 Mistake::shadow_takes_ambient,
                                 Mistake::shadow_leaves_specular,
                                 Mistake::reflection_unweighted,
                                 Mistake::refraction_unweighted,
                                 Mistake::shares_swapped,
                                 Mistake::red_and_blue,
                                 Mistake::gamma_applied};

bool far_apart(const Bytes& a, const Bytes& b) {
  for (std::size_t c = 0; c < 3; ++c)
    if (std::abs(int{a[c]} - int{b[c]}) >= kApart) return true;
  return false;
}

using Pixel = std::pair<std::uint32_t, std::uint32_t>;  // column and row

/// A question that a pixel makes.
struct Draft {
  Explanation explanation;
  std::vector<QuizChoice> wrong;
};

class ColorAsker : public Asker {
 public:
  ColorAsker(Studio& studio, Language language, std::uint64_t seed)
      : studio_(studio), language_(language), random_(seed) {}

  Result<std::optional<QuizQuestion>> next(Quiz& quiz) override;

 private:
  template <class... Values>
  std::string say(Word word, const Values&... values) const {
    return zraka::say(language_, word, values...);
  }
  Result<void> prepare();
  Result<std::optional<Draft>> draft_from(const std::vector<Pixel>& pixels);
  Result<std::optional<Draft>> draft_of(std::uint32_t x, std::uint32_t y);
  std::vector<QuizChoice> slips_at(const Explanation& explanation);
  Result<std::vector<QuizChoice>> mistakes_at(const Explanation& explanation);
  Result<std::vector<QuizChoice>> wrong_choices(const Explanation& explanation);
  Result<QuizQuestion> question_of(Quiz& quiz, Draft draft);

  Studio& studio_;
  Language language_;
  Random random_;
  std::vector<std::vector<Pixel>> by_term_;  ///< pixels that a term changes
  bool prepared_ = false;
  std::size_t turn_ = 0;
  std::set<Pixel> asked_;
  std::optional<Explainer> explainer_, without_shadow_rays_;
};

/// Where a term changes what one sees, there is something to compute, and the terms in turn give
/// variety: highlights, shadows, mirrors, glass. Nothing is asked of the background.
Result<void> ColorAsker::prepare() {
  if (prepared_) return {};
  prepared_ = true;
  if (studio_.options().profile.average_corners) return {};  // four sums for one pixel
  if (studio_.scene().lights.size() > kMostLights) return {};
  // What is listed for a colour to be computed from is the lab's.
  if (is_beyond_the_lab(studio_.scene(), studio_.options())) return {};
  const Result<const std::vector<Variant>*> variants = studio_.without_terms();
  if (!variants) return tl::make_unexpected(variants.error());
  const PackedImage right(studio_.right());
  for (const Variant& variant : **variants) {
    std::vector<Pixel> found;
    for (std::uint32_t y = 0; y < studio_.right().height; ++y)
      for (std::uint32_t x = 0; x < studio_.right().width; ++x)
        if (far_apart(right.at(x, y), variant.picture.at(x, y))) found.emplace_back(x, y);
    by_term_.push_back(std::move(found));
  }
  random_.shuffle(by_term_);
  RenderOptions options = studio_.options();
  Result<Explainer> explainer = Explainer::create(studio_.scene(), options);
  if (!explainer) return tl::make_unexpected(explainer.error());
  explainer_ = std::move(*explainer);
  if (!options.terms.shadows) return {};
  options.terms.shadows = false;
  explainer = Explainer::create(studio_.scene(), options);
  if (!explainer) return tl::make_unexpected(explainer.error());
  without_shadow_rays_ = std::move(*explainer);
  return {};
}

std::vector<QuizChoice> ColorAsker::slips_at(const Explanation& e) {
  const std::vector<LightTerms>& lights = e.trees.front().rays.front().hit->lights;
  std::optional<Explanation> unshadowed;
  if (std::any_of(lights.begin(), lights.end(),
                  [](const LightTerms& at) { return at.reach == Reach::blocked; }))
    if (Result<Explanation> other = without_shadow_rays_->pixel(e.x, e.y)) unshadowed = *other;
  std::vector<QuizChoice> slips;
  for (const Slip& slip : slips_of(e, unshadowed))
    slips.push_back(
        {.text = color_text(slip.color), .reason = say(slip.what), .color = slip.color});
  random_.shuffle(slips);
  return slips;
}

/// What programs with a mistake of the catalogue make of the pixel.
Result<std::vector<QuizChoice>> ColorAsker::mistakes_at(const Explanation& e) {
  const Result<const std::vector<Variant>*> variants = studio_.with_mistakes();
  if (!variants) return tl::make_unexpected(variants.error());
  std::vector<QuizChoice> mistakes;
  for (const Variant& variant : **variants) {
    if (std::count(std::begin(kInTheSum), std::end(kInTheSum), variant.mistake) == 0) continue;
    const Bytes color = variant.picture.at(e.x, e.y);
    mistakes.push_back({.text = color_text(color),
                        .reason = say(Word::slip_program, text_of(language_, variant.mistake)),
                        .mistake = variant.mistake,
                        .color = color});
  }
  random_.shuffle(mistakes);
  return mistakes;
}

/// Two slips and a mistake where there are enough of both.
Result<std::vector<QuizChoice>> ColorAsker::wrong_choices(const Explanation& e) {
  const Bytes right = stored_color(e.color, e.profile.transfer);
  std::vector<QuizChoice> wrong;
  const auto take = [&](const std::vector<QuizChoice>& from, std::size_t most) {
    for (const QuizChoice& choice : from)
      if (wrong.size() < most && far_apart(choice.color, right) &&
          std::all_of(wrong.begin(), wrong.end(), [&](const QuizChoice& other) {
            return far_apart(choice.color, other.color);
          }))
        wrong.push_back(choice);
  };
  const std::vector<QuizChoice> slips = slips_at(e);
  const Result<std::vector<QuizChoice>> mistakes = mistakes_at(e);
  if (!mistakes) return mistakes;
  take(slips, kWrongChoices - 1);
  take(*mistakes, kWrongChoices);
  take(slips, kWrongChoices);
  return wrong;
}

Result<std::optional<Draft>> ColorAsker::draft_of(std::uint32_t x, std::uint32_t y) {
  Result<Explanation> explanation = explainer_->pixel(x, y);
  // Its ray tree may be too large to be explained.
  if (!explanation || !explanation->trees.front().rays.front().hit) return std::nullopt;
  Result<std::vector<QuizChoice>> wrong = wrong_choices(*explanation);
  if (!wrong) return tl::make_unexpected(wrong.error());
  if (wrong->empty()) return std::nullopt;
  return Draft{std::move(*explanation), std::move(*wrong)};
}

/// The first pixel with all its wrong choices, else the one with most.
Result<std::optional<Draft>> ColorAsker::draft_from(const std::vector<Pixel>& pixels) {
  std::optional<Draft> best;
  for (int i = 0; i < kTries && (!best || best->wrong.size() < kWrongChoices); ++i) {
    const auto& [x, y] = pixels[static_cast<std::size_t>(random_.below(pixels.size()))];
    if (asked_.contains({x, y})) continue;
    Result<std::optional<Draft>> draft = draft_of(x, y);
    if (!draft) return draft;
    if (*draft && (!best || (*draft)->wrong.size() > best->wrong.size())) best = std::move(*draft);
  }
  return best;
}

Result<QuizQuestion> ColorAsker::question_of(Quiz& quiz, Draft draft) {
  const Explanation& e = draft.explanation;
  QuizQuestion question{.kind = QuizKind::color,
                        .text = say(Word::quiz_color_asks, e.x, e.y),
                        .facts = facts_of(language_, e),
                        .x = e.x,
                        .y = e.y};
  const Result<std::size_t> place = add_picture(quiz, covered(studio_.right(), e.x, e.y));
  if (!place) return tl::make_unexpected(place.error());
  question.pictures = {{*place, say(Word::quiz_covered)}};
  const Bytes color = stored_color(e.color, e.profile.transfer);
  set_choices(question, {.text = color_text(color), .color = color}, std::move(draft.wrong),
              random_);
  question.reason.push_back(in_words(language_, e));
  question.sums = to_text(e, {.language = language_, .sums_only = true});
  return question;
}

Result<std::optional<QuizQuestion>> ColorAsker::next(Quiz& quiz) {
  const Result<void> ready = prepare();
  if (!ready) return tl::make_unexpected(ready.error());
  while (!by_term_.empty()) {
    const std::size_t at = turn_++ % by_term_.size();
    Result<std::optional<Draft>> draft = draft_from(by_term_[at]);
    if (!draft) return tl::make_unexpected(draft.error());
    if (*draft) {
      asked_.insert({(*draft)->explanation.x, (*draft)->explanation.y});
      return question_of(quiz, std::move(**draft));
    }
    by_term_.erase(by_term_.begin() + static_cast<std::ptrdiff_t>(at));
  }
  return std::nullopt;
}

}  // namespace

std::unique_ptr<Asker> make_color_asker(Studio& studio, Language language, std::uint64_t seed) {
  return std::make_unique<ColorAsker>(studio, language, seed);
}

}  // namespace zraka
