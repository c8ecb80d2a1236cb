// SPDX-License-Identifier: Apache-2.0
// Who asks: one for each kind of question.
#pragma once

#include <memory>
#include <optional>
#include <zraka/school/quiz.hpp>

#include "core/random.hpp"
#include "core/words.hpp"
#include "school/quiz/studio.hpp"

namespace zraka {

/// Asks one kind of question until there is nothing left to ask.
class Asker {
 public:
  virtual ~Asker() = default;
  /// The next question; none if there is none. Pictures that it needs are added to the quiz's.
  virtual Result<std::optional<QuizQuestion>> next(Quiz& quiz) = 0;
};

/// What is missing, or what is wrong, in one of two pictures?
std::unique_ptr<Asker> make_variant_asker(Studio& studio, Language language, QuizKind kind,
                                          std::uint64_t seed);
/// What colour has this pixel?
std::unique_ptr<Asker> make_color_asker(Studio& studio, Language language, std::uint64_t seed);

/// At most this many choices are wrong.
inline constexpr std::size_t kWrongChoices = 3;

/// Puts the right choice among the wrong ones at a position that chance decides.
void set_choices(QuizQuestion& question, QuizChoice right, std::vector<QuizChoice> wrong,
                 Random& random);

/// Adds a picture of stored values; returns its index.
Result<std::size_t> add_picture(Quiz& quiz, const Image& stored);

/// "(12, 34, 56)".
std::string color_text(const std::array<std::uint8_t, 3>& color);

}  // namespace zraka
