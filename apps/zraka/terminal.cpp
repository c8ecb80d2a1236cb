// SPDX-License-Identifier: Apache-2.0
#include "terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <zraka/render.hpp>

#include "commands.hpp"
#include "core/new_file.hpp"
#include "core/phrase.hpp"
#include "core/text.hpp"
#include "progress.hpp"
#include "render/isa.hpp"

namespace zraka::app {
namespace {

/// Only what a signal handler may do: remove files, write a few bytes, leave.
void on_interrupt(int signal) {
  remove_incomplete_files();
  Progress::clear_line();
  ::_exit(kSignalled + signal);
}

Language language_of_problems = Language::english;  // of one process, whose user it is

bool in_colour(int descriptor) {
  const char* no_color = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return ::isatty(descriptor) == 1 && (no_color == nullptr || *no_color == '\0') &&
         terminal != nullptr && std::string_view(terminal) != "dumb";
}

}  // namespace

bool output_in_color() {
  return in_colour(STDOUT_FILENO);
}

std::string for_output(const std::string& name) {
  return ::isatty(STDOUT_FILENO) == 1 ? shown_line(name) : name;
}

void print_name(const std::string& name) {
  fmt::print("{}\n", for_output(name));
}

void catch_interrupts() {
  ::signal(SIGXFSZ, SIG_IGN);  // a limit on files' sizes is a failed write like any other
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  sigfillset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    struct sigaction old {};
    // Who started us by nohup wants us to outlive the terminal.
    if (signal == SIGHUP && ::sigaction(signal, nullptr, &old) == 0 && old.sa_handler == SIG_IGN)
      continue;
    ::sigaction(signal, &action, nullptr);
  }
}

void speak(Language language) {
  language_of_problems = language;
}

void show(const Diagnostics& diagnostics) {
  const bool colour = in_colour(STDERR_FILENO);
  for (const Diagnostic& d : diagnostics) {
    std::string text = to_string(d, language_of_problems);
    if (colour) {
      const std::string word = fmt::format("{}: ", text_of(language_of_problems, d.severity));
      const char* paint = d.severity == Severity::error ? "\x1b[1;31m" : "\x1b[1;33m";
      const std::size_t at = text.find(word);
      if (at != std::string::npos) text.insert(at + word.size(), "\x1b[0m").insert(at, paint);
    }
    std::fputs(text.c_str(), stderr);
  }
}

Diagnostics about(const std::string& file, Diagnostics diagnostics) {
  for (Diagnostic& d : diagnostics) d.file = file == "-" ? "standard input" : file;
  return diagnostics;
}

int fail(const Diagnostics& diagnostics) {
  show(diagnostics);
  return kFailed;
}

std::string isa_in_use() {
  const Result<Isa> isa = choose_isa(std::nullopt);
  return isa ? std::string(name_of(*isa)) : isa.error().front().message;
}

}  // namespace zraka::app
