// SPDX-License-Identifier: Apache-2.0
// The words of the course's input.txt: values between ',' or ':', text in <…> left out.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace zraka::lab {

struct Token {
  std::string text;  ///< without brackets and outer space; "" where there is nothing
  std::size_t position =
      0;  ///< of its first character in the file, or of its separator if it is empty
  bool labelled = false;  ///< text in <…> stands before it
  bool last = false;      ///< no separator follows: the file's end does
};

/// A bracket that has no partner.
struct StrayBracket {
  char bracket;
  std::size_t position;
};

/// Reads one token after the other.
class Tokens {
 public:
  static constexpr std::size_t kMostStrays = 100;
  explicit Tokens(std::string_view text) : text_(text) {}
  /// False at the end of the file: after the last separator only space and labels are left.
  bool next(Token& token);
  std::size_t position() const { return at_; }
  void rewind(std::size_t position) { at_ = position; }
  /// Brackets without partners, as far as the file has been read, but no more than kMostStrays.
  std::vector<StrayBracket> strays;

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace zraka::lab
