// SPDX-License-Identifier: Apache-2.0
// What somebody meant who has misspelt a word.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zraka {

/// The known word with the fewest letters to insert, remove, replace or swap with a neighbour
/// (Damerau 1964, the restricted form), the first of equals; none if that are more than a third of
/// the letters.
std::optional<std::string> nearest_of(std::string_view word, const std::vector<std::string>& known);

}  // namespace zraka
