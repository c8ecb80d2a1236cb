// SPDX-License-Identifier: Apache-2.0
// Textures where fields of materials name them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "language/section.hpp"

namespace zraka::language {

/// The texture that a field of `what` has in the place of a value: by its name, or as a table. None,
/// and the problem told, if it is neither.
std::optional<std::uint32_t> read_texture(const toml::Node& node, const Field& field,
                                          std::string_view what, Input& input);

}  // namespace zraka::language
