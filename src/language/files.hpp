// SPDX-License-Identifier: Apache-2.0
// Files that a scene names.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <zraka/image.hpp>

#include "language/section.hpp"

namespace zraka::language {

/// The path of the file that a node of `what` names; none, and the problem told, where it leaves
/// the scene's folder and must not, or there is no folder.
std::optional<std::string> path_of(const toml::Node& node, std::string_view what, Input& input);

/// The picture that a node names, in linear light; nullptr, and the problem told, if it cannot be
/// read.
std::shared_ptr<const Image> read_picture(const toml::Node& node, std::string_view what,
                                          Transfer transfer, Input& input);

/// Tells the problems of reading a file at the node that names it.
void tell(const Diagnostics& problems, const toml::Node& node, std::string_view what, Input& input);

}  // namespace zraka::language
