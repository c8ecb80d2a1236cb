// SPDX-License-Identifier: Apache-2.0
// How the program talks to people: problems, progress, interrupts.
#pragma once

#include <string>
#include <zraka/diagnostic.hpp>

namespace zraka::app {

/// May standard output have colours? It is a terminal that can, and NO_COLOR is not set.
bool output_in_color();

/// The name of a file for standard output: as it is for programs, and without what steers a
/// terminal where somebody reads it.
std::string for_output(const std::string& name);
/// The same on a line of its own.
void print_name(const std::string& name);

/// From here on Ctrl-C and a polite kill end the program at once with 128 and the signal's number,
/// as shells count, and no half file stays.
void catch_interrupts();

/// From here on problems are told in this language; English before.
void speak(Language language);

/// Diagnostics on standard error, errors and warnings in colour on a terminal.
void show(const Diagnostics& diagnostics);

/// What is said of a scene as a whole, said of its file; - is standard input.
Diagnostics about(const std::string& file, Diagnostics diagnostics);

/// Shows the problems and gives back the exit code for them.
int fail(const Diagnostics& diagnostics);

/// Name of the instruction set that a render would use now, or what is wrong with the one that is
/// asked for.
std::string isa_in_use();

}  // namespace zraka::app
