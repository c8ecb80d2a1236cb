// SPDX-License-Identifier: Apache-2.0
// The commands of the program: one file each, and this list of them.
#pragma once

#include "command.hpp"

namespace zraka::app {

/// Adds its command to the program.
using AddCommand = void (*)(Command& program);

void add_render(Command& program);
void add_stages(Command& program);
void add_explain(Command& program);
void add_influence(Command& program);
void add_generate(Command& program);
void add_info(Command& program);
void add_check(Command& program);
void add_format(Command& program);
void add_convert(Command& program);
void add_schema(Command& program);
void add_compare(Command& program);
void add_report(Command& program);
void add_grade(Command& program);
void add_quiz(Command& program);
void add_help(Command& program);

inline constexpr AddCommand kCommands[] = {add_render,   add_stages, add_explain, add_influence,
                                           add_generate, add_info,   add_check,   add_format,
                                           add_convert,  add_schema, add_compare, add_report,
                                           add_grade,    add_quiz,   add_help};

}  // namespace zraka::app
