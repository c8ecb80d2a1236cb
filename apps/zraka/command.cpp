// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <map>
#include <type_traits>
#include <utility>

#include "core/nearest.hpp"
#include "core/text.hpp"

namespace zraka::app {
namespace {

/// CLI11 takes 010 for an octal number; people mean ten.
std::string without_leading_zeros(std::string value) {
  const std::size_t first = value.find_first_not_of("+-");
  const std::size_t digit = value.find_first_not_of('0', first);
  if (digit != std::string::npos &&
      value.find_first_not_of("0123456789", first) == std::string::npos)
    value.erase(first, digit - first);
  return value;
}

/// The innermost command that the arguments have named.
const CLI::App& innermost(const CLI::App& app) {
  const CLI::App* at = &app;
  while (!at->get_subcommands().empty()) at = at->get_subcommands().front();
  return *at;
}

/// "zraka generate letter".
std::string full_name(const CLI::App& app) {
  return app.get_parent() == nullptr ? app.get_name()
                                     : full_name(*app.get_parent()) + " " + app.get_name();
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  const std::optional<std::string> near = nearest_of(word, known);
  return near ? fmt::format(": did you mean {}?", *near) : "";
}

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands(std::function<bool(const CLI::App*)>()))
    names.push_back(command->get_name());
  return names;
}

std::string no_command(const CLI::App& app, const std::string& name,
                       const std::vector<std::string>& commands) {
  const std::string meant = did_you_mean(name, commands);
  const std::string wrong =
      fmt::format("'{}' is no command{}", shown(name),
                  app.get_parent() == nullptr ? "" : fmt::format(" of '{}'", full_name(app)));
  return meant.empty() ? fmt::format("{}: there are {}", wrong, fmt::join(commands, ", "))
                       : wrong + meant;
}

/// What is wrong with arguments that no option takes, if there are any.
std::string unexpected(const CLI::App& app) {
  for (const std::string& argument : app.remaining()) {
    if (argument.size() < 2 || argument[0] != '-') continue;
    const std::string name = argument.substr(0, argument.find('='));
    return fmt::format("'{}' has no option {}{}", full_name(app), shown(name),
                       did_you_mean(name, option_names(app)));
  }
  if (app.remaining().empty()) return "";
  if (const std::vector<std::string> commands = names_of_commands(app); !commands.empty())
    return no_command(app, app.remaining().front(), commands);
  return fmt::format("'{}' takes no further argument: what is '{}'?", full_name(app),
                     shown(app.remaining().front()));
}

OptionInfo info_of(const CLI::Option& option) {
  OptionInfo info;
  for (const std::string& name : option.get_snames()) info.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) info.names.push_back("--" + name);
  info.positional = info.names.empty();
  if (info.positional) info.names.push_back(option.get_name());
  info.help = option.get_description();
  info.required = option.get_required();
  info.repeated = option.get_items_expected_max() > 1;
  if (option.get_items_expected_min() > 0 || info.positional) info.value = option.get_type_name();
  return info;
}

/// Standard output was written; the exit code.
int flushed() {
  std::cout.flush();
  if (std::cout.good() && std::fflush(stdout) == 0) return kDone;
  fmt::print(stderr, "standard output: error: cannot be written\n");
  return kFailed;
}

int wrong_usage(const std::string& problem, const CLI::App& app) {
  fmt::print(stderr, "{}\nRun '{} --help' for more information.\n", shown_text(problem),
             full_name(app));
  return kWrongUsage;
}

}  // namespace

/// What the arguments have chosen.
struct Command::Chosen {
  std::map<const CLI::App*, std::function<int()>> actions;
  std::map<const CLI::App*, std::function<std::string()>> checks;
  Option::Proposals proposals;
};

Option& Option::required() {
  option_->required();
  return *this;
}

Option& Option::range(double least, double most) {
  option_->check(CLI::Validator(
      [least, most](std::string& value) {
        double number = 0;
        if (CLI::detail::lexical_cast(value, number) && number >= least && number <= most)
          return std::string();
        return fmt::format("'{}' is not a number from {} to {}", value, least, most);
      },
      ""));
  return *this;
}

Option& Option::propose(std::function<std::vector<std::string>()> values) {
  (*proposals_)[option_] = std::move(values);
  return *this;
}

Option& Option::one_of(const std::vector<std::string>& known) {
  propose([known] { return known; });
  std::string list;
  for (std::size_t i = 0; i < known.size(); ++i)
    list += (i == 0 ? "" : i + 1 == known.size() ? " or " : ", ") + known[i];
  return check(list, [known](const std::string& value) {
    return std::find(known.begin(), known.end(), value) != known.end();
  });
}

Option& Option::check(std::string what, std::function<bool(const std::string&)> accepts) {
  option_->check(CLI::Validator(
      [what = std::move(what), accepts = std::move(accepts)](std::string& value) {
        return accepts(value) ? std::string() : fmt::format("'{}' is not {}", shown(value), what);
      },
      ""));
  return *this;
}

Command Command::add_command(const std::string& name, const std::string& what) {
  return {app_->add_subcommand(name, what), chosen_};
}

Option Command::add(const std::string& names, OptionTarget target, const std::string& help) {
  return {std::visit(
              [&]<class Value>(Value* value) {
                if constexpr (std::is_same_v<Value, bool>) {
                  return app_->add_flag(names, *value, help);
                } else {
                  CLI::Option* option = app_->add_option(names, *value, help);
                  if constexpr (std::is_integral_v<Value>) option->transform(without_leading_zeros);
                  return option;
                }
              },
              target),
          &chosen_->proposals};
}

Option Command::add_flag(const std::string& name, const std::string& usual, std::string& target,
                         const std::string& help) {
  return {app_->add_flag(fmt::format("{}{{{}}}", name, usual), target, help), &chosen_->proposals};
}

void Command::footer(const std::string& text) {
  app_->footer(text);
}

void Command::require_command() {
  app_->require_subcommand(1);
}

void Command::check(std::function<std::string()> problem) {
  chosen_->checks[app_] = std::move(problem);
}

void Command::action(std::function<int()> run) {
  chosen_->actions[app_] = std::move(run);
}

std::optional<std::string> Command::help_of(const std::vector<std::string>& path) const {
  CLI::App* app = app_;
  for (const std::string& name : path) {
    const std::vector<CLI::App*> found =
        app->get_subcommands([&](const CLI::App* command) { return command->check_name(name); });
    if (found.empty()) return std::nullopt;
    app = found.front();
  }
  return app->help(app == app_ ? "" : full_name(*app->get_parent()));
}

std::vector<std::string> Command::commands() const {
  return names_of_commands(*app_);
}

CommandInfo Command::info() const {
  CommandInfo info{app_->get_name(), app_->get_description(), app_->get_footer(), {}, {}};
  for (const CLI::Option* option : app_->get_options()) {
    OptionInfo& added = info.options.emplace_back(info_of(*option));
    if (const auto found = chosen_->proposals.find(option); found != chosen_->proposals.end())
      added.proposed = found->second();
  }
  for (CLI::App* command : app_->get_subcommands(std::function<bool(CLI::App*)>()))
    info.commands.push_back(Command(command, chosen_).info());
  return info;
}

Program::Program(const std::string& name, const std::string& what,
                 std::function<std::string()> version)
    : app_(std::make_unique<CLI::App>(what, name)),
      chosen_(std::make_unique<Command::Chosen>()),
      command_(app_.get(), chosen_.get()) {
  app_->set_version_flag("--version", std::move(version));
  app_->require_subcommand(1);
}

Program::~Program() = default;

std::variant<std::function<int()>, int> Program::read(int argc, char** argv) {
  if (argc >= 2 && argv[1][0] != '-') {
    const std::vector<std::string> commands = names_of_commands(*app_);
    if (std::find(commands.begin(), commands.end(), argv[1]) == commands.end())
      return wrong_usage(no_command(*app_, argv[1], commands), *app_);
  }
  try {
    app_->parse(argc, argv);
  } catch (const CLI::Success& wanted) {  // --help and --version
    app_->exit(wanted);
    return flushed();
  } catch (const CLI::ParseError& wrong) {
    // An argument that nothing takes is often the reason why another one is missing.
    const CLI::App& app = innermost(*app_);
    const std::string extra = unexpected(app);
    return wrong_usage(extra.empty() ? wrong.what() : extra, app);
  }
  const CLI::App& app = innermost(*app_);
  if (const auto check = chosen_->checks.find(&app); check != chosen_->checks.end())
    if (const std::string problem = check->second(); !problem.empty())
      return wrong_usage(problem, app);
  return chosen_->actions.at(&app);
}

}  // namespace zraka::app
