// SPDX-License-Identifier: Apache-2.0
// The pictures that questions are made of: the right one, and those that differ from it by one
// thing, rendered when they are first asked for.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>
#include <zraka/explain.hpp>
#include <zraka/school/mistakes.hpp>

#include "core/words.hpp"
#include "image/packed.hpp"

namespace zraka {

/// What a glance takes in of a picture of stored values: not the edges' pixels.
Image at_a_glance(const Image& stored);
/// Two such pictures are told apart where more than kSeenShare of their pixels differ by more than
/// kSeenSteps of 255.
inline constexpr double kSeenSteps = 12, kSeenShare = 0.005;
bool told_apart(const Image& a, const Image& b);

/// The right picture without one term, or with one mistake.
struct Variant {
  Terms terms;
  Mistake mistake = Mistake::none;
  Word name{};  ///< of the term that is missing
  PackedImage picture;
  Image glance{};  ///< at_a_glance()
};

class Studio {
 public:
  /// The scene must outlive it. Fails as make_quiz() does, but for the quiz's own options.
  static Result<Studio> create(const Scene& scene, const RenderOptions& options);

  const Scene& scene() const { return *scene_; }
  const RenderOptions& options() const { return options_; }
  /// The options that render a variant.
  RenderOptions options_of(const Variant& variant) const;
  /// As an 8 bit file has it.
  const Image& right() const { return right_; }
  std::uint64_t pixels() const { return std::uint64_t{right_.width} * right_.height; }

  /// Those that can be told apart from the right picture, in the order of Terms and of the
  /// catalogue.
  Result<const std::vector<Variant>*> without_terms();
  Result<const std::vector<Variant>*> with_mistakes();

 private:
  Studio(const Scene& scene, const RenderOptions& options) : scene_(&scene), options_(options) {}
  Result<void> add_if_seen(std::vector<Variant>& list, Variant variant) const;

  const Scene* scene_;
  RenderOptions options_;
  Image right_, glance_;
  std::optional<std::vector<Variant>> without_terms_, with_mistakes_;
};

}  // namespace zraka
