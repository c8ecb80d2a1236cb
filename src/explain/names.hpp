// SPDX-License-Identifier: Apache-2.0
// What shapes, textures, stages and mistakes are called.
#pragma once

#include <string>
#include <zraka/explain.hpp>

#include "core/words.hpp"

namespace zraka {

/// "sphere 3": as diagnostics call it, counted from 1.
std::string plain_name(const ShapeId& id);

/// What a sentence asks of a noun; English has one form for all.
enum class Case { nominative, accusative, genitive, locative };

/// The kind of shape alone: "sphere", "kugla".
std::string_view noun_of(Language language, std::int32_t kind, Case form = Case::nominative);

/// "sphere 3 'green'", "kuglu 3 'green'".
std::string label_of(Language language, const NamedShape& shape, Case form = Case::nominative);
/// The same of what a ray hits; of a shape in groups "box 2 in instance 1 'left'".
std::string label_of(Language language, const ExplainedHit& hit, Case form = Case::nominative);
std::string label_of(Language language, const Blocker& blocker, Case form = Case::nominative);

/// A member's place in its expression: "2", or "1.2" for the second of the first.
std::string position_of(const ExplainedMember& member);

/// "checker", "šahovnica".
std::string_view noun_of(Language language, TextureKind kind);

/// "stage 5: shadows".
std::string_view text_of(Language language, Stage stage);

/// "profile of the lab".
Word word_of(ProfileName profile);

/// What a varied rule does, as a sentence without a full stop.
std::string_view text_of(Language language, const VariedRules& rules);

/// What becomes of the refracted share where there is total internal reflection.
Word after_total_reflection(const Explanation& explanation);

/// Lights are counted from 1.
inline std::size_t light_number(std::size_t index) {
  return index + 1;
}

}  // namespace zraka
