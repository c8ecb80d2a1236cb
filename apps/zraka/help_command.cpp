// SPDX-License-Identifier: Apache-2.0
// zraka help: what --help of a command prints.
#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "core/text.hpp"

namespace zraka::app {

void add_help(Command& program) {
  auto path = std::make_shared<std::vector<std::string>>();
  Command help = program.add_command("help", "print the help of a command");
  help.add("COMMAND", path.get(), "the command, as in generate letter; none: the program itself");
  help.footer("Examples:\n  zraka help render\n  zraka help generate letter");
  help.check([program, path] {
    if (program.help_of(*path)) return std::string();
    return fmt::format("'{}' is no command", shown(fmt::format("{}", fmt::join(*path, " "))));
  });
  help.action([program, path] {
    fmt::print("{}", *program.help_of(*path));
    return +kDone;
  });
}

}  // namespace zraka::app
