// SPDX-License-Identifier: Apache-2.0
// What commands take and do, without a header of the library that reads the command line: those
// cost seconds in every file that includes them, and command.cpp alone does.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace zraka::app {

/// What the program ends with; compare has codes of its own, and signals end it with 128 and
/// their number.
enum ExitCode { kDone = 0, kFailed = 1, kWrongUsage = 2, kSignalled = 128 };

/// Where the value of an option goes; a bool is a flag without a value.
using OptionTarget = std::variant<bool*, int*, std::uint32_t*, std::size_t*, double*, std::string*,
                                  std::vector<std::string>*>;

/// What a command is and takes: what manual pages and shells' completions are written from.
struct OptionInfo {
  std::vector<std::string> names;  ///< "-o", "--output"; of a positional argument its one name
  std::string help;
  std::string value;                  ///< what its value is, as UINT; "" for a flag
  std::vector<std::string> proposed;  ///< values that a shell can propose
  bool positional = false, required = false, repeated = false;
};
struct CommandInfo {
  std::string name, what, footer;
  std::vector<OptionInfo> options;
  std::vector<CommandInfo> commands;
};

/// An option or a positional argument of a command.
class Option {
 public:
  Option& required();
  /// A number from `least` to `most`.
  Option& range(double least, double most);
  Option& one_of(const std::vector<std::string>& values);
  /// `accepts(value)` has to hold; else the value "is not `what`".
  Option& check(std::string what, std::function<bool(const std::string&)> accepts);
  /// Values that a shell can propose, asked for when it does; others may be right, too.
  Option& propose(std::function<std::vector<std::string>()> values);

 private:
  friend class Command;
  using Proposals = std::map<const CLI::Option*, std::function<std::vector<std::string>()>>;
  Option(CLI::Option* option, Proposals* proposals) : option_(option), proposals_(proposals) {}
  CLI::Option* option_;
  Proposals* proposals_;
};

/// The program or one of its commands.
class Command {
 public:
  Command add_command(const std::string& name, const std::string& what);
  /// "-o,--output" names an option, "SCENE" a positional argument.
  Option add(const std::string& names, OptionTarget target, const std::string& help);
  /// A flag that may have a value, as in --stats=json; without one it gets `usual`.
  Option add_flag(const std::string& name, const std::string& usual, std::string& target,
                  const std::string& help);
  /// Text below the options: examples.
  void footer(const std::string& text);
  /// One of its commands has to be given.
  void require_command();
  /// What is wrong with arguments that are right one by one, or "".
  void check(std::function<std::string()> problem);
  /// What it does; returns the exit code.
  void action(std::function<int()> run);

  /// The text of --help of the command of this one that `path` leads to, if there is one.
  std::optional<std::string> help_of(const std::vector<std::string>& path) const;
  /// The names of those right below this one.
  std::vector<std::string> commands() const;
  /// This command and those below it.
  CommandInfo info() const;

 private:
  friend class Program;
  struct Chosen;
  Command(CLI::App* app, Chosen* chosen) : app_(app), chosen_(chosen) {}
  CLI::App* app_;
  Chosen* chosen_;
};

/// The outermost command.
class Program {
 public:
  /// `version` is asked for when it is printed.
  Program(const std::string& name, const std::string& what, std::function<std::string()> version);
  ~Program();
  Command& command() { return command_; }

  /// Reads the arguments. What is to be done then, or the exit code where there is nothing to do:
  /// help has been printed, or on standard error what is wrong.
  std::variant<std::function<int()>, int> read(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> app_;
  std::unique_ptr<Command::Chosen> chosen_;
  Command command_;
};

}  // namespace zraka::app
