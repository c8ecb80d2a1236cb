// SPDX-License-Identifier: Apache-2.0
// What shells complete, from what commands say of themselves.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "command.hpp"

namespace zraka::app {

/// The script that completes the program's arguments; none for a shell that is not known.
std::optional<std::string> completions(const CommandInfo& program, std::string_view shell);

}  // namespace zraka::app
