// SPDX-License-Identifier: Apache-2.0
// Which known word somebody may have meant.
#pragma once

#include <span>
#include <string_view>

namespace zraka {

/// How many letters have to be put in, left out, changed or swapped with their neighbour to make
/// one word of the other (Damerau 1964), case apart.
std::size_t distance(std::string_view a, std::string_view b);

/// The nearest of the known words, "" where none is near enough to be meant.
std::string_view nearest(std::string_view word, std::span<const std::string_view> known);

}  // namespace zraka
