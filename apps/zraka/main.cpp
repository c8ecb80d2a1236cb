// SPDX-License-Identifier: Apache-2.0
// zraka: reads the words, runs a command, ends with its exit code.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <zraka/zraka.hpp>

#include "commands.hpp"
#include "core/file.hpp"
#include "terminal.hpp"

namespace zraka::app {
namespace {

std::string version_text() {
  std::string isas;
  for (const Isa isa : available_isas()) isas += fmt::format(" {}", name_of(isa));
  return fmt::format("zraka {}\ninstruction sets built: {}\nthis machine has:{}\nin use: {}",
                     ZRAKA_VERSION, ZRAKA_ISAS_BUILT, isas, isa_in_use());
}

/// CLI11 takes 010 for an octal number; people mean ten.
void read_as_decimal(CLI::App& command) {
  const auto without_zeros = [](std::string word) {
    const std::size_t first = word.find_first_not_of("+-");
    const std::size_t digit = word.find_first_not_of('0', first);
    if (digit != std::string::npos &&
        word.find_first_not_of("0123456789", first) == std::string::npos)
      word.erase(first, digit - first);
    return word;
  };
  for (CLI::Option* option : command.get_options())
    if (option->get_type_name().find("INT") != std::string::npos) option->transform(without_zeros);
  for (CLI::App* under : command.get_subcommands({})) read_as_decimal(*under);
}

int run(int argc, char** argv) {
  CLI::App program(
      "A Whitted ray tracer: exact to the bit, and able to say why each pixel has its colour.",
      "zraka");
  program.set_version_flag("--version", version_text);
  program.require_subcommand(1);
  program.footer(
      "Examples:\n"
      "  zraka render scenes/lab/input.txt -o picture.png\n"
      "  zraka stages scenes/lab/input.txt -o pictures\n"
      "  zraka generate letter Č -o letter.txt\n"
      "  zraka compare mine.png picture.png\n"
      "Every command has a --help of its own. Exit codes: 0 done, 1 bad input or failed output,\n"
      "2 wrong usage, 130 interrupted; those of compare are diff's.");
  Command command;
  std::string names;
  bool known = argc < 2 || argv[1][0] == '-';
  for (const AddCommand add : kCommands) {
    CLI::App* const added = add(program, command);
    read_as_decimal(*added);
    const std::string name = added->get_name();
    names += (names.empty() ? "" : ", ") + name;
    known = known || name == argv[1];
  }
  if (!known) {
    fmt::print(stderr, "'{}' is no command: there are {}\nRun with --help for more information.\n",
               argv[1], names);
    return kWrongUsage;
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& wanted) {  // --help and --version
    return program.exit(wanted);
  } catch (const CLI::ParseError& wrong) {
    program.exit(wrong);
    return kWrongUsage;
  }
  int code = kFailed;
  try {
    code = command();
  } catch (const std::bad_alloc&) {
    Diagnostic problem;
    problem.message = "there is not enough memory for this";
    return fail({problem});
  }
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  Diagnostic problem;
  problem.file = "standard output";
  problem.message = "cannot be written";
  return std::max(code, fail({problem}));
}

/// The last word where an exception cannot be caught, as that of oneTBB's where the system starts
/// no more threads.
[[noreturn]] void say_why_and_end() {
  Diagnostic problem;
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
    problem.message = "zraka has met something impossible, and ends";
  } catch (const std::exception& reason) {
    problem.message = reason.what();
    if (problem.message.find("pthread_create") != std::string::npos) {
      problem.message = "the system starts no more threads for this user";
      problem.hint = "with --threads 1 none is needed";
    }
  } catch (...) {
    problem.message = "zraka has met something unknown, and ends";
  }
  remove_incomplete_files();
  std::_Exit(fail({problem}));
}

}  // namespace
}  // namespace zraka::app

int main(int argc, char** argv) {
  zraka::app::catch_interrupts();
  std::set_terminate(zraka::app::say_why_and_end);
  return zraka::app::run(argc, argv);
}
