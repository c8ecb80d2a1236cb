// SPDX-License-Identifier: Apache-2.0
// What there is to say of a hit besides its light, in lines: groups, CSG, the shape's own space,
// textures.
#pragma once

#include <string>
#include <vector>
#include <zraka/explain.hpp>

#include "core/words.hpp"

namespace zraka {

/// Whether it is a cap; the way to the shape, through the members of a CSG shape, and into its own
/// space; no lines for most hits.
std::vector<std::string> place_lines(Language language, const ExplainedHit& hit);

/// Whether a texture bends the normal; "" where none is asked.
std::string bent_line(Language language, const ExplainedHit& hit);

/// A texture, and the coefficients in a row that it gives: colours, or numbers, of one value.
struct TextureWords {
  std::string texture;               ///< "texture 'tiles' (checker)"
  std::vector<std::string> symbols;  ///< "ka", "kd"
  Coefficient coefficient{};         ///< one of these
  Float3 value{};
};
std::vector<TextureWords> texture_words(Language language, const ExplainedHit& hit);

/// "ka", "n"; of a colour or of a number.
std::string_view symbol_of(Coefficient coefficient);
bool is_color(Coefficient coefficient);

}  // namespace zraka
