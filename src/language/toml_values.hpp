// SPDX-License-Identifier: Apache-2.0
// The words of TOML: its numbers and its strings.
#pragma once

#include <string>
#include <string_view>

#include "language/toml.hpp"

namespace zraka::toml {

/// Reads a bare word as a number or a truth value into `node`; says what is wrong with it, or
/// nothing.
Problem read_word(std::string_view word, Node& node);

/// A string: what it says, and the position behind it; or what is wrong with it.
struct String {
  std::string_view plain;  ///< where it stands in the file letter by letter
  std::string decoded{};   ///< where it does not
  bool is_plain = true;
  std::size_t end = 0;
  Problem problem{};  ///< with a message if it is broken
};
/// `begin` is at its first quote. A key may not go over several lines.
String read_string(std::string_view text, std::size_t begin, bool key);

}  // namespace zraka::toml
