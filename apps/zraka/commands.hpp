// SPDX-License-Identifier: Apache-2.0
// The commands of the program: one file each, and this list of them.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace zraka::app {

/// What the program ends with; compare has codes of its own.
enum ExitCode { kDone = 0, kFailed = 1, kWrongUsage = 2, kInterrupted = 130 };

/// Adds its subcommand to the program, and gives back what it does once the words are read.
using Command = std::function<int()>;
using AddCommand = CLI::App* (*)(CLI::App& program, Command& command);

CLI::App* add_render(CLI::App& program, Command& command);
CLI::App* add_stages(CLI::App& program, Command& command);
CLI::App* add_explain(CLI::App& program, Command& command);
CLI::App* add_influence(CLI::App& program, Command& command);
CLI::App* add_generate(CLI::App& program, Command& command);
CLI::App* add_info(CLI::App& program, Command& command);
CLI::App* add_compare(CLI::App& program, Command& command);
CLI::App* add_grade(CLI::App& program, Command& command);
CLI::App* add_quiz(CLI::App& program, Command& command);
CLI::App* add_report(CLI::App& program, Command& command);

inline constexpr AddCommand kCommands[] = {add_render,   add_stages, add_explain, add_influence,
                                           add_generate, add_info,   add_compare, add_report,
                                           add_grade,    add_quiz};

}  // namespace zraka::app
