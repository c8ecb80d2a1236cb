// SPDX-License-Identifier: Apache-2.0
// Colours as the web writes them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <zraka/values.hpp>

namespace zraka::language {

/// "#rrggbb" in sRGB, as a linear colour.
std::optional<Color> color_of_hex(std::string_view text);

/// What to write instead of a colour's name; "" of what is none that is known.
std::string hint_at_color(std::string_view name);

}  // namespace zraka::language
