// SPDX-License-Identifier: Apache-2.0
#include "completions.hpp"

#include <fmt/format.h>

#include <functional>

namespace zraka::app {
namespace {

/// Calls `visit` with every command and its words, as "zraka generate letter".
void walk(const CommandInfo& info, const std::string& path,
          const std::function<void(const CommandInfo&, const std::string&)>& visit) {
  visit(info, path);
  for (const CommandInfo& command : info.commands) walk(command, path + " " + command.name, visit);
}

/// Values of any kind can be files; numbers cannot.
bool may_be_file(const OptionInfo& option) {
  return option.proposed.empty() && option.value.starts_with("TEXT");
}

std::string replaced(std::string text, std::string_view characters, std::string_view before) {
  std::string result;
  for (const char c : text) {
    if (characters.find(c) != characters.npos) result += before;
    result += c;
  }
  return result;
}

/// On one line, and no longer than a terminal's.
std::string short_help(const std::string& help) {
  std::string line = help.substr(0, help.find(';'));
  for (char& c : line) c = c == '\n' ? ' ' : c;
  return line;
}

/// Within the apostrophes of bash and zsh.
std::string in_apostrophes(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + "'";
}

std::string command_names(const CommandInfo& info) {
  std::string names;
  for (const CommandInfo& command : info.commands)
    names += (names.empty() ? "" : " ") + command.name;
  return names;
}

/// The flag as it can be typed: with each of its values, too.
std::vector<std::string> typed_names(const OptionInfo& option) {
  std::vector<std::string> names = option.names;
  if (option.value.empty())
    for (const std::string& value : option.proposed)
      names.push_back(option.names.back() + "=" + value);
  return names;
}

std::string bash_case(const CommandInfo& info, const std::string& path) {
  std::string options, values, words = command_names(info);
  for (const OptionInfo& option : info.options) {
    if (option.positional) {
      words += fmt::format(" {}", fmt::join(option.proposed, " "));
      continue;
    }
    options += fmt::format("{}{}", options.empty() ? "" : " ", fmt::join(typed_names(option), " "));
    if (option.value.empty()) continue;
    values += fmt::format("        {}) ", fmt::join(option.names, " | "));
    values += !option.proposed.empty()
                  ? fmt::format("words='{}'; list=yes ;;\n", fmt::join(option.proposed, " "))
              : may_be_file(option) ? "return ;;\n"
                                    : "compopt +o default +o bashdefault; return ;;\n";
  }
  std::string text =
      fmt::format("    {})\n      options='{}' words='{}'\n", in_apostrophes(path), options, words);
  if (!values.empty()) text += "      case $before in\n" + values + "      esac\n";
  return text + "      ;;\n";
}

std::string bash(const CommandInfo& program) {
  std::string cases, paths;
  walk(program, program.name, [&](const CommandInfo& info, const std::string& path) {
    cases += bash_case(info, path);
    paths += fmt::format("{}{}", paths.empty() ? "" : " | ", in_apostrophes(path));
  });
  return fmt::format(R"(# bash completion of {0}; made by: {0} help --completions bash
# Without a word of ours, names of files are proposed.
_{0}() {{
  local path={0} now=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}}
  local options='' words='' list='' word
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case "$path $word" in {1}) path+=" $word" ;; esac
  done
  case $path in
{2}  esac
  if [[ -z $list && $now == -* ]]; then words=$options; fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$now")
}}
complete -o bashdefault -o default -F _{0} {0}
)",
                     program.name, paths, cases);
}

/// In the brackets and between the colons of _arguments.
std::string zsh_text(const std::string& text) {
  return replaced(text, "[]:\\", "\\");
}

std::string zsh_values(const OptionInfo& option) {
  if (!option.proposed.empty()) return fmt::format("({})", fmt::join(option.proposed, " "));
  return may_be_file(option) ? "_files" : " ";
}

std::string zsh_option(const OptionInfo& option) {
  std::string text;
  const std::string help = zsh_text(short_help(option.help));
  if (option.positional)
    return fmt::format("    {} \\\n",
                       in_apostrophes(fmt::format("{}:{}:{}", option.repeated ? "*" : "",
                                                  option.names.front(), zsh_values(option))));
  for (const std::string& name : typed_names(option)) {
    const bool is_long = name.starts_with("--");
    std::string spec = fmt::format("{}{}[{}]", name,
                                   option.value.empty() ? ""
                                   : is_long            ? "="
                                                        : "+",
                                   help);
    if (!option.value.empty())
      spec += fmt::format(":{}:{}", zsh_text(option.value), zsh_values(option));
    text += fmt::format("    {} \\\n", in_apostrophes(spec));
  }
  return text;
}

std::string zsh_function(std::string path) {
  for (char& c : path) c = c == ' ' || c == '-' ? '_' : c;
  return "_" + path;
}

std::string zsh(const CommandInfo& program) {
  std::string functions;
  walk(program, program.name, [&](const CommandInfo& info, const std::string& path) {
    functions += fmt::format("{}() {{\n", zsh_function(path));
    if (!info.commands.empty())
      functions += "  local context state line curcontext=$curcontext\n  typeset -A opt_args\n";
    functions += fmt::format("  _arguments {}\\\n", info.commands.empty() ? "" : "-C ");
    for (const OptionInfo& option : info.options) functions += zsh_option(option);
    if (info.commands.empty()) {
      functions += "    && return\n}\n\n";
      return;
    }
    functions += "    '1:command:->command' '*::argument:->argument' && return\n";
    functions += "  case $state in\n    command)\n      local -a commands=(\n";
    for (const CommandInfo& command : info.commands)
      functions += fmt::format(
          "        {}\n", in_apostrophes(command.name + ":" + replaced(command.what, ":\\", "\\")));
    functions +=
        "      )\n      _describe command commands ;;\n    argument)\n      case $words[1] in\n";
    for (const CommandInfo& command : info.commands)
      functions +=
          fmt::format("        {}) {} ;;\n", command.name, zsh_function(path + " " + command.name));
    functions += "      esac ;;\n  esac\n}\n\n";
  });
  return fmt::format(
      "#compdef {0}\n# zsh completion of {0}; made by: {0} help --completions zsh\n\n{1}{2} "
      "\"$@\"\n",
      program.name, functions, zsh_function(program.name));
}

/// Within fish's apostrophes.
std::string fish_text(const std::string& text) {
  return "'" + replaced(text, "'\\", "\\") + "'";
}

std::string fish_option(const OptionInfo& option, const std::string& at) {
  const std::string values =
      option.proposed.empty()
          ? ""
          : " -a " + fish_text(fmt::format("{}", fmt::join(option.proposed, " ")));
  if (option.positional)
    return option.proposed.empty() ? "" : fmt::format("complete -c {}{}\n", at, values);
  std::string names;
  for (const std::string& name : option.names)
    names += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  return fmt::format("complete -c {}{}{}{} -d {}\n", at, names,
                     option.value.empty()  ? ""
                     : may_be_file(option) ? " -r -F"
                                           : " -x",
                     option.value.empty() ? "" : values, fish_text(short_help(option.help)));
}

std::string fish(const CommandInfo& program) {
  std::string lines, paths;
  walk(program, program.name, [&](const CommandInfo& info, const std::string& path) {
    paths += fmt::format(" {}", fish_text(path));
    const std::string at = fmt::format(
        "{0} -n {1}", program.name, fish_text(fmt::format("__{}_at \"{}\"", program.name, path)));
    for (const CommandInfo& command : info.commands)
      lines +=
          fmt::format("complete -c {} -f -a {} -d {}\n", at, command.name, fish_text(command.what));
    for (const OptionInfo& option : info.options) lines += fish_option(option, at);
  });
  return fmt::format(R"(# fish completion of {0}; made by: {0} help --completions fish
function __{0}_at
    set -l path {0}
    for word in (commandline -opc)[2..]
        contains -- "$path $word"{1}; and set path "$path $word"
    end
    test "$path" = "$argv"
end
{2})",
                     program.name, paths, lines);
}

}  // namespace

std::optional<std::string> completions(const CommandInfo& program, std::string_view shell) {
  if (shell == "bash") return bash(program);
  if (shell == "zsh") return zsh(program);
  if (shell == "fish") return fish(program);
  return std::nullopt;
}

}  // namespace zraka::app
