// SPDX-License-Identifier: Apache-2.0
// A formatted text at the end of another one.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

namespace zraka {

/// Appends what fmt::format() writes. fmt::format_to() would compile all of fmt's formatting into
/// each file that calls it, which takes longer than the rest of most files.
template <typename... Values>
void append(std::string& text, fmt::format_string<Values...> format, Values&&... values) {
  text += fmt::format(format, std::forward<Values>(values)...);
}

}  // namespace zraka
