// SPDX-License-Identifier: Apache-2.0
// Text as pictures of its glyphs, through FreeType.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>
#include <zraka/diagnostic.hpp>

namespace zraka {

/// Coverage, 0…255, row by row from the top.
struct Coverage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> values;
  std::uint8_t at(int x, int y) const {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

class Font {
 public:
  /// A font file; "" asks the system for a bold sans-serif that has Croatian letters.
  static Result<Font> open(const std::string& path);

  /// One line of UTF-8 text, its letters `pixels` high, cut to its ink. Fails on a character that
  /// the font does not have, text that is no UTF-8, and more than kLongestText characters.
  Result<Coverage> draw(std::string_view text, int pixels) const;

  static constexpr std::size_t kLongestText = 64;

 private:
  struct Face;
  explicit Font(std::shared_ptr<Face> face) : face_(std::move(face)) {}
  std::shared_ptr<Face> face_;
};

}  // namespace zraka
