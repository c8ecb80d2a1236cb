// SPDX-License-Identifier: Apache-2.0
// Questions about a scene's picture, with answers and reasons from the engine that draws it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>
#include <zraka/school/mistakes.hpp>

namespace zraka {

enum class QuizKind {
  stage,    ///< a picture without one term of light: which one is missing?
  mistake,  ///< a picture with one mistake of the catalogue: which one is it?
  color     ///< a pixel with all that its colour is made of: what is it?
};
inline constexpr std::array<QuizKind, 3> kQuizKinds = {QuizKind::stage, QuizKind::mistake,
                                                       QuizKind::color};
std::string_view name_of(QuizKind kind);
std::optional<QuizKind> quiz_kind_named(std::string_view name);

inline constexpr int kMaxQuestions = 100;
/// A quiz renders every mistake's picture and keeps them all.
inline constexpr std::uint64_t kMaxQuizPixels = kMaxPixels / 32;

struct QuizOptions {
  std::uint64_t seed = 1;
  int questions = 10;  ///< wanted: 1…kMaxQuestions
  std::set<QuizKind> kinds{kQuizKinds.begin(), kQuizKinds.end()};
  std::string language = "en";  ///< of all texts: "en" or "hr"
};

/// A PNG of at most 800×800 pixels; larger pictures are reduced.
struct QuizPicture {
  std::uint32_t width = 0, height = 0;
  std::string png;
};

struct QuizChoice {
  std::string text;
  /// What makes somebody choose it: the slip that gives a colour. "" for stages and mistakes.
  std::string reason{};
  Terms terms{};                        ///< of a stage's choice: those that its picture has
  Mistake mistake = Mistake::none;      ///< of a mistake's choice
  std::array<std::uint8_t, 3> color{};  ///< of a colour's choice, as an 8 bit file stores it
};

struct QuizQuestion {
  struct Shown {
    std::size_t picture = 0;  ///< index in Quiz::pictures
    std::string caption;
  };
  QuizKind kind = QuizKind::stage;
  std::string text;
  std::vector<Shown> pictures{};
  std::vector<std::string> facts{};   ///< line by line, what a colour is to be computed from
  std::vector<QuizChoice> choices{};  ///< 2 to 4
  std::size_t answer = 0;             ///< index of the right one in `choices`
  std::vector<std::string> reason{};  ///< why, in paragraphs
  std::string sums{};                 ///< of a colour: the tree's terms, line by line
  /// The pixel that is asked for, or which the reason speaks of: column and row from the upper left
  /// corner of the picture in full size.
  std::uint32_t x = 0, y = 0;
};

struct Quiz {
  std::vector<QuizPicture> pictures;  ///< the right one first
  std::vector<QuizQuestion> questions;
};

/// Asks about the picture that `options` render: as many questions as are wanted or as the scene
/// gives, no two alike. Scene, options and seed decide every word and every pixel, on any machine.
/// What a scene cannot show is not asked of it. Fails as render() does, for options out of range,
/// for pictures of more than kMaxQuizPixels, for a mistake in `options`, and where nothing can be
/// asked.
Result<Quiz> make_quiz(const Scene& scene, const RenderOptions& options,
                       const QuizOptions& quiz = {});

}  // namespace zraka
