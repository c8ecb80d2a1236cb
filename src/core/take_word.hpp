// SPDX-License-Identifier: Apache-2.0
// A line's words, one after the other.
#pragma once

#include <string_view>

#include "core/text.hpp"

namespace zraka {

/// The first word, which the line has no more; "" where there is none.
inline std::string_view take_word(std::string_view& line) {
  line = trimmed(line);
  const std::string_view word = line.substr(0, line.find_first_of(" \t"));
  line.remove_prefix(word.size());
  return word;
}

}  // namespace zraka
