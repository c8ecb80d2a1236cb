// SPDX-License-Identifier: Apache-2.0
// Colours as the web writes them.
#pragma once

#include <optional>
#include <string_view>
#include <zraka/values.hpp>

namespace zraka::language {

/// "#rrggbb" in sRGB, as a linear colour.
std::optional<Color> color_of_hex(std::string_view text);

}  // namespace zraka::language
