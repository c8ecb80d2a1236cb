// SPDX-License-Identifier: Apache-2.0
// zraka: reads the arguments, runs a command, ends with its exit code.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <new>
#include <string>
#include <variant>
#include <zraka/zraka.hpp>

#include "commands.hpp"
#include "core/new_file.hpp"
#include "tachyon_command.hpp"
#include "terminal.hpp"

namespace zraka::app {
namespace {

std::string version_text() {
  std::string isas;
  for (const Isa isa : available_isas()) isas += fmt::format(" {}", name_of(isa));
  return fmt::format("zraka {}\ninstruction sets built: {}\nthis machine has:{}\nin use: {}",
                     ZRAKA_VERSION, ZRAKA_ISAS_BUILT, isas, isa_in_use());
}

/// The exit code, once all that was printed is out.
int finished(const std::function<int()>& action) {
  int code = kFailed;
  try {
    code = action();
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

int run(int argc, char** argv) {
  if (is_called_tachyon(argc > 0 ? argv[0] : nullptr))
    return finished([&] { return run_tachyon(argc, argv); });
  Program program(
      "zraka",
      "A Whitted ray tracer: exact to the bit, and able to say why each pixel has its colour.",
      version_text);
  program.command().footer(
      "Examples:\n"
      "  zraka render scenes/lab/input.txt -o picture.png\n"
      "  zraka stages scenes/lab/input.txt -o pictures\n"
      "  zraka generate letter Č -o letter.txt\n"
      "  zraka compare mine.png picture.png\n"
      "Every command has a --help of its own. Exit codes: 0 done, 1 bad input or failed output,\n"
      "2 wrong usage, 128 + N ended by signal N (130: Ctrl-C); those of compare are diff's.");
  for (const AddCommand add : kCommands) add(program.command());
  const auto read = program.read(argc, argv);
  if (const int* code = std::get_if<int>(&read)) return *code;
  return finished(std::get<std::function<int()>>(read));
}

/// The last word where an exception cannot be caught, as that of oneTBB's where the system starts
/// no more threads.
[[noreturn]] void say_why_and_end() {
  Diagnostic problem;
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
    problem.message = "internal error: zraka ends";
  } catch (const std::exception& reason) {
    problem.message = reason.what();
    if (problem.message.find("pthread_create") != std::string::npos) {
      problem.message = "the system starts no more threads for this user";
      problem.hint = "with --threads 1 none is needed";
    }
  } catch (...) {
    problem.message = "internal error of unknown cause: zraka ends";
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
