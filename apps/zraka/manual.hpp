// SPDX-License-Identifier: Apache-2.0
// Manual pages, from what commands say of themselves.
#pragma once

#include <string>
#include <vector>

#include "command.hpp"

namespace zraka::app {

struct ManualPage {
  std::string name;  ///< of the file, as "zraka-render.1"
  std::string text;  ///< for troff with the macros of man(7)
};

/// A page of the program, and one of each command below it.
std::vector<ManualPage> manual_pages(const CommandInfo& program, const std::string& version);

/// A page from a text for --help: "NAME ARGUMENTS: what it does", then a line of an option each,
/// "  -o FILE  what it does", and paragraphs.
ManualPage manual_page_of_help(const std::string& help, const std::string& version);

}  // namespace zraka::app
