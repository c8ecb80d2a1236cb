// SPDX-License-Identifier: Apache-2.0
// A text of spheres, framed in the lab's window: the sheet's eighth picture.
#pragma once

#include <string>
#include <zraka/diagnostic.hpp>
#include <zraka/scene.hpp>

namespace zraka {

/// Where the spheres stand: in a chain along the middle of the strokes, or all over the glyphs.
enum class Packing { strokes, fill };

struct LetterOptions {
  Packing packing = Packing::strokes;
  int spheres = 0;  ///< about how many a letter; 0: as many as the strokes take
  std::uint32_t resolution = 400;
  std::string font{};      ///< a font file; "" asks the system
  std::uint32_t seed = 1;  ///< of the materials
};

/// Fails on an empty text, text that is no UTF-8, and characters that the font does not have.
Result<Scene> generate_letter(const std::string& text, const LetterOptions& options);

}  // namespace zraka
