// SPDX-License-Identifier: Apache-2.0
// zraka help: what --help of a command prints, and what a keyword of the scene language means.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "completions.hpp"
#include "core/file.hpp"
#include "core/nearest.hpp"
#include "core/text.hpp"
#include "language/help.hpp"
#include "manual.hpp"
#include "tachyon_options.hpp"
#include "terminal.hpp"
#include "zraka/zraka.hpp"

namespace zraka::app {
namespace {

struct HelpArguments {
  std::vector<std::string> topic;
  std::string pages, manual, shell;
  std::string words() const { return fmt::format("{}", fmt::join(topic, " ")); }
};

int write_pages(const std::string& folder) {
  const Result<void> made = make_folder(folder);
  if (!made) return fail(made.error());
  for (const language::Page& page : language::pages()) {
    const std::string path = (std::filesystem::path(folder) / page.name).string();
    if (const Result<void> written = write_text_file(path, page.text); !written)
      return fail(written.error());
  }
  return kDone;
}

int write_manual(const Command& program, const std::string& folder) {
  const Result<void> made = make_folder(folder);
  if (!made) return fail(made.error());
  std::vector<ManualPage> pages = manual_pages(program.info(), ZRAKA_VERSION);
  pages.push_back(manual_page_of_help(kTachyonHelp, ZRAKA_VERSION));
  for (const ManualPage& page : pages) {
    const std::string path = (std::filesystem::path(folder) / page.name).string();
    if (const Result<void> written = write_text_file(path, page.text); !written)
      return fail(written.error());
  }
  return kDone;
}

/// Help of a command, else of a keyword of the scene language.
std::string help_of(const Command& program, const HelpArguments& arguments) {
  std::string text = program.help_of(arguments.topic).value_or("");
  if (arguments.topic.empty())
    return text + "\n" + language::keywords_in_lines("Keywords of the scene language: ");
  return text.empty() ? language::help_on(arguments.words()).value_or("") : text;
}

std::vector<std::string> topics(const Command& program) {
  std::vector<std::string> topics = program.commands();
  for (const std::string_view keyword : language::keywords()) topics.emplace_back(keyword);
  return topics;
}

std::string problem_of(const Command& program, const HelpArguments& arguments) {
  const std::string words = arguments.words();
  if (program.help_of(arguments.topic) || language::help_on(words)) return "";
  std::string problem =
      fmt::format("'{}' is no command and no keyword of the scene language", shown(words));
  std::vector<std::string> known;
  for (const std::string_view keyword : language::keywords()) known.emplace_back(keyword);
  if (const auto meant = nearest_of(words, known))
    problem += fmt::format("\nDid you mean '{}'?", *meant);
  return problem;
}

}  // namespace

void add_help(Command& program) {
  auto arguments = std::make_shared<HelpArguments>();
  Command help = program.add_command("help", "print the help of a command, or explain a keyword");
  help.add("TOPIC", &arguments->topic,
           "a command, as in generate letter, or a keyword of the scene language, as in sphere; "
           "none: the program itself")
      .propose([program] { return topics(program); });
  help.add("--pages", &arguments->pages,
           "write the scene language's pages of documentation into this folder instead");
  help.add("--manual", &arguments->manual, "write the manual pages into this folder instead");
  help.add("--completions", &arguments->shell,
           "print what lets this shell complete arguments instead: bash, zsh or fish")
      .one_of({"bash", "zsh", "fish"});
  help.footer(
      "A keyword that is a command, too, has section behind it.\n"
      "Examples:\n"
      "  zraka help render\n"
      "  zraka help generate letter\n"
      "  zraka help sphere\n"
      "  zraka help --completions bash > ~/.local/share/bash-completion/completions/zraka\n"
      "  zraka help render section");
  help.check([program, arguments] { return problem_of(program, *arguments); });
  help.action([program, arguments] {
    if (!arguments->pages.empty()) return write_pages(arguments->pages);
    if (!arguments->manual.empty()) return write_manual(program, arguments->manual);
    if (!arguments->shell.empty())
      fmt::print("{}", completions(program.info(), arguments->shell).value());
    else
      fmt::print("{}", help_of(program, *arguments));
    return +kDone;
  });
}

}  // namespace zraka::app
