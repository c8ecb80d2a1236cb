// SPDX-License-Identifier: Apache-2.0
// What is missing, or what is wrong, in one of two pictures?
#include <algorithm>
#include <zraka/compare.hpp>

#include "core/counted.hpp"
#include "explain/names.hpp"
#include "explain/sentence.hpp"
#include "school/mistakes/names.hpp"
#include "school/quiz/ask.hpp"

namespace zraka {
namespace {

/// The wrong choices are taken from so many variants, those whose pictures are nearest to the
/// answer's.
constexpr std::size_t kPlausible = 6;

std::array<std::uint8_t, 3> bytes_of(const std::array<float, 3>& stored) {
  std::array<std::uint8_t, 3> bytes{};
  for (std::size_t c = 0; c < 3; ++c)
    bytes[c] = static_cast<std::uint8_t>(quantize(stored[c], Transfer::linear, 8));
  return bytes;
}

class VariantAsker : public Asker {
 public:
  VariantAsker(Studio& studio, Language language, QuizKind kind, std::uint64_t seed)
      : studio_(studio), language_(language), kind_(kind), random_(seed) {}

  Result<std::optional<QuizQuestion>> next(Quiz& quiz) override;

 private:
  template <class... Values>
  std::string say(Word word, const Values&... values) const {
    return zraka::say(language_, word, values...);
  }
  Result<void> prepare();
  bool was_asked(const Variant& variant) const;
  std::vector<QuizChoice> wrong_choices(std::size_t answer);
  std::string text_of_variant(const Variant& variant) const;
  QuizChoice choice_of(const Variant& variant) const;
  void give_reason(QuizQuestion& question, const Variant& variant, const Image& picture);

  Studio& studio_;
  Language language_;
  QuizKind kind_;
  Random random_;
  const std::vector<Variant>* variants_ = nullptr;
  std::vector<std::size_t> left_;  ///< not asked yet, the next one last
  std::vector<std::size_t> asked_;
};

Result<void> VariantAsker::prepare() {
  if (variants_ != nullptr) return {};
  const Result<const std::vector<Variant>*> variants =
      kind_ == QuizKind::stage ? studio_.without_terms() : studio_.with_mistakes();
  if (!variants) return tl::make_unexpected(variants.error());
  variants_ = *variants;
  for (std::size_t i = 0; i < variants_->size(); ++i) left_.push_back(i);
  random_.shuffle(left_);
  return {};
}

/// The same picture with another answer would be a riddle.
bool VariantAsker::was_asked(const Variant& variant) const {
  return std::any_of(asked_.begin(), asked_.end(), [&](std::size_t i) {
    return !told_apart((*variants_)[i].glance, variant.glance);
  });
}

std::string VariantAsker::text_of_variant(const Variant& variant) const {
  return std::string(kind_ == QuizKind::stage ? text_of(language_, variant.name)
                                              : text_of(language_, variant.mistake));
}

QuizChoice VariantAsker::choice_of(const Variant& variant) const {
  return {.text = text_of_variant(variant), .terms = variant.terms, .mistake = variant.mistake};
}

/// Only variants whose pictures can be told apart from the answer's, or two choices were right.
std::vector<QuizChoice> VariantAsker::wrong_choices(std::size_t answer) {
  const Image& picture = (*variants_)[answer].glance;
  std::vector<std::pair<double, std::size_t>> near;  // mean square, variant
  for (std::size_t i = 0; i < variants_->size(); ++i) {
    const Image& other = (*variants_)[i].glance;
    if (told_apart(other, picture))
      near.emplace_back(measure_errors(other, picture).mean_square, i);
  }
  std::sort(near.begin(), near.end());
  near.resize(std::min(near.size(), kPlausible));
  random_.shuffle(near);
  near.resize(std::min(near.size(), kWrongChoices));
  std::vector<QuizChoice> wrong;
  for (const auto& [distance, variant] : near) wrong.push_back(choice_of((*variants_)[variant]));
  return wrong;
}

/// How many pixels it changes, the one that it changes most, and why that has both its colours.
void VariantAsker::give_reason(QuizQuestion& question, const Variant& variant,
                               const Image& picture) {
  const bool stage = kind_ == QuizKind::stage;
  const std::uint64_t changed = measure_errors(picture, studio_.right(), 0.5 / 255).over;
  question.reason.push_back(say(stage ? Word::quiz_missing : Word::quiz_mistaken,
                                text_of_variant(variant),
                                counted(language_, Counted::pixel, changed),
                                percentage(language_, changed, studio_.pixels())));
  const PixelPair most = worst_pixels(studio_.right(), picture, 0, 1).front();
  question.x = most.x;
  question.y = most.y;
  question.reason.push_back(say(Word::quiz_most, most.x, most.y, color_text(bytes_of(most.a)),
                                color_text(bytes_of(most.b))));
  for (const bool wrong : {false, true}) {
    const RenderOptions options = wrong ? studio_.options_of(variant) : studio_.options();
    const Result<Explanation> explanation = explain(studio_.scene(), options, most.x, most.y);
    if (!explanation) continue;  // its ray tree is too large to be explained
    const Word word = !wrong  ? Word::grade_right_pixel
                      : stage ? Word::quiz_without
                              : Word::grade_wrong_pixel;
    question.reason.push_back(capitalized(say(word, in_words(language_, *explanation))));
  }
}

Result<std::optional<QuizQuestion>> VariantAsker::next(Quiz& quiz) {
  const Result<void> ready = prepare();
  if (!ready) return tl::make_unexpected(ready.error());
  const bool stage = kind_ == QuizKind::stage;
  while (!left_.empty()) {
    const std::size_t answer = left_.back();
    left_.pop_back();
    const Variant& variant = (*variants_)[answer];
    if (was_asked(variant)) continue;
    std::vector<QuizChoice> wrong = wrong_choices(answer);
    if (wrong.empty()) continue;
    asked_.push_back(answer);
    const Image picture = variant.picture.image();

    QuizQuestion question{.kind = kind_,
                          .text = say(stage ? Word::quiz_stage_asks : Word::quiz_mistake_asks)};
    const Result<std::size_t> place = add_picture(quiz, picture);
    if (!place) return tl::make_unexpected(place.error());
    question.pictures = {{0, say(Word::quiz_right_picture)},
                         {*place, say(Word::quiz_asked_picture)}};
    set_choices(question, choice_of(variant), std::move(wrong), random_);
    give_reason(question, variant, picture);
    return question;
  }
  return std::nullopt;
}

}  // namespace

std::unique_ptr<Asker> make_variant_asker(Studio& studio, Language language, QuizKind kind,
                                          std::uint64_t seed) {
  return std::make_unique<VariantAsker>(studio, language, kind, seed);
}

}  // namespace zraka
