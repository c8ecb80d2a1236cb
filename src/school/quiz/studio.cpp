// SPDX-License-Identifier: Apache-2.0
#include "school/quiz/studio.hpp"

#include <fmt/format.h>

#include <zraka/compare.hpp>
#include <zraka/school/quiz.hpp>

#include "core/phrase.hpp"
#include "image/alter.hpp"
#include "render/prepare.hpp"

namespace zraka {
namespace {

struct Term {
  bool Terms::*part;
  Word name;
};
constexpr Term kTerms[] = {
    {&Terms::ambient, Word::ambient},           {&Terms::diffuse, Word::diffuse},
    {&Terms::specular, Word::specular},         {&Terms::shadows, Word::quiz_shadows},
    {&Terms::reflection, Word::quiz_reflected}, {&Terms::refraction, Word::quiz_refracted}};

Result<Image> rendered(const Scene& scene, const RenderOptions& options, Mistake mistake) {
  Result<Rendering> rendering = render_mistaken(scene, options, mistake);
  if (!rendering) return tl::make_unexpected(rendering.error());
  return as_stored(rendering->image, options.profile.transfer, 8);
}

}  // namespace

Image at_a_glance(const Image& stored) {
  constexpr std::uint32_t kSide = 100;
  return reduced(stored, kSide);
}

bool told_apart(const Image& a, const Image& b) {
  return measure_errors(a, b, (kSeenSteps + 0.5) / 255).share() > kSeenShare;
}

Result<Studio> Studio::create(const Scene& scene, const RenderOptions& options) {
  const std::uint64_t pixels = std::uint64_t{scene.resolution.width} * scene.resolution.height;
  if (pixels > kMaxQuizPixels)
    return failure("", phrase(Word::quiz_pixels, pixels, +kMaxQuizPixels),
                   phrase(Word::quiz_smaller));
  Studio studio(scene, options);
  Result<Image> right = rendered(scene, options, Mistake::none);
  if (!right) return tl::make_unexpected(right.error());
  studio.right_ = std::move(*right);
  studio.glance_ = at_a_glance(studio.right_);
  return studio;
}

RenderOptions Studio::options_of(const Variant& variant) const {
  RenderOptions options = options_;
  options.terms = variant.terms;
  return options;
}

Result<void> Studio::add_if_seen(std::vector<Variant>& list, Variant variant) const {
  const Result<Image> picture = rendered(*scene_, options_of(variant), variant.mistake);
  if (!picture) return tl::make_unexpected(picture.error());
  variant.glance = at_a_glance(*picture);
  if (!told_apart(variant.glance, glance_)) return {};
  variant.picture = PackedImage(*picture);
  list.push_back(std::move(variant));
  return {};
}

Result<const std::vector<Variant>*> Studio::without_terms() {
  if (!without_terms_) {
    std::vector<Variant> list;
    for (const Term& term : kTerms) {
      if (options_.terms.silhouette || !(options_.terms.*term.part)) continue;
      Variant variant{options_.terms, Mistake::none, term.name, {}};
      variant.terms.*term.part = false;
      const Result<void> added = add_if_seen(list, std::move(variant));
      if (!added) return tl::make_unexpected(added.error());
    }
    without_terms_ = std::move(list);
  }
  return &*without_terms_;
}

Result<const std::vector<Variant>*> Studio::with_mistakes() {
  if (!with_mistakes_) {
    std::vector<Variant> list;
    // Mistakes are those of the lab's rules.
    const bool none = is_beyond_the_lab(*scene_, options_);
    for (const MistakeEntry& entry : lab_mistakes()) {
      if (none) break;
      // Half a pixel moves every edge, and nobody sees it.
      if (entry.mistake == Mistake::pixel_center) continue;
      const Result<void> added = add_if_seen(list, {options_.terms, entry.mistake, {}, {}});
      if (!added) return tl::make_unexpected(added.error());
    }
    with_mistakes_ = std::move(list);
  }
  return &*with_mistakes_;
}

}  // namespace zraka
