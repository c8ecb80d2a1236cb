// SPDX-License-Identifier: Apache-2.0
// Text as people wrote it: numbers, characters, lines and columns.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace zraka {

std::string_view trimmed(std::string_view text);
/// Whether a file's name has an ending, itself in small letters; false for that of "".
bool ends_with(std::string_view name, std::string_view ending);

/// A whole text as a number: digits with an optional sign, point and exponent. None for anything
/// else, words for infinity among it; infinite for what is out of range.
std::optional<double> parse_number(std::string_view text);

/// Reads a number as std::from_chars does, several times as fast where it has at most 15 digits and
/// a small exponent, as the numbers of large files have. Returns the end of what was read, or
/// nullptr if no number that fits is there.
const char* read_number(const char* begin, const char* end, double& value);

/// Is the text whole characters of UTF-8?
bool is_utf8(std::string_view text);

/// Line and column, from 1, of a byte of a text. Columns count characters, or bytes in a text that
/// is no UTF-8.
struct TextPosition {
  std::size_t line = 1, column = 1;
};

/// Finds lines and columns in a text; quick where the positions asked for grow.
class TextPositions {
 public:
  explicit TextPositions(std::string_view text) : text_(text) {}
  TextPosition at(std::size_t position);
  /// The line around a position, at most about 100 characters of it, as shown_line(); below it a
  /// caret.
  std::string excerpt(std::size_t position) const;

 private:
  std::string_view text_;
  std::optional<bool> utf8_;
  std::size_t position_ = 0;  ///< where the last one was
  TextPosition place_;
};

/// Text from outside as a terminal or a page may have it, on one line and cut after 60 characters:
/// line ends become ↵, and what is no UTF-8, controls a terminal or turns the direction of writing
/// around becomes U+FFFD.
std::string shown(std::string_view text);
/// The same at its full length, with its tabs.
std::string shown_line(std::string_view text);
/// The same in as many lines as it has.
std::string shown_text(std::string_view text);

/// A character that steers a terminal or turns the direction of writing around.
struct Control {
  unsigned code;
  std::size_t bytes;
};
/// The one that the text begins with, of those from U+007F on; none if another character is there.
std::optional<Control> control_at(std::string_view text);

/// Text as it stands in an HTML page, otherwise as shown_text().
std::string html_text(std::string_view text);

/// The same for prose: the groups of a number's digits stay on one line.
std::string html_prose(std::string_view text);

/// 1234567 as "1 234 567".
std::string grouped(unsigned long long number);

}  // namespace zraka
