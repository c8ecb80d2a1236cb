// SPDX-License-Identifier: Apache-2.0
#include "manual.hpp"

#include <fmt/format.h>

#include <cctype>
#include <string_view>

namespace zraka::app {
namespace {

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// Text as it is: no command of troff, no hyphen where a minus is meant.
std::string plain(std::string_view text) {
  std::string result;
  bool first = true;
  for (const char c : text) {
    if (first && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
    first = c == '\n';
  }
  return result;
}

std::string bold(std::string_view text) {
  return fmt::format("\\fB{}\\fR", plain(text));
}

std::string italic(std::string_view text) {
  return fmt::format("\\fI{}\\fR", plain(text));
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string beginning(const std::string& name, std::string_view what, const std::string& version) {
  return fmt::format(
      ".TH {} 1 \"\" \"zraka {}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n",
      plain(upper(name)), plain(version), plain(name), plain(what));
}

std::string synopsis(const std::string& command, const CommandInfo& info) {
  std::string text = bold(command) + " [" + italic("OPTIONS") + "]";
  for (const OptionInfo& option : info.options) {
    if (!option.positional) {
      if (option.required)
        text += fmt::format(" {} {}", bold(option.names.back()), italic(option.value));
      continue;
    }
    const std::string name = italic(option.names.front()) + (option.repeated ? " ..." : "");
    text += option.required ? " " + name : " [" + name + "]";
  }
  if (!info.commands.empty()) text += " " + italic("COMMAND") + " ...";
  return text + "\n";
}

/// "Print this." of "print this".
std::string sentence(std::string text) {
  if (text.empty()) return text;
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text.ends_with('.') ? text : text + ".";
}

std::string option_entry(const OptionInfo& option) {
  std::string names;
  for (const std::string& name : option.names)
    names += (names.empty() ? "" : ", ") + (option.positional ? italic(name) : bold(name));
  if (!option.value.empty() && !option.positional) names += " " + italic(option.value);
  return fmt::format(".TP\n{}\n{}\n", names, plain(option.help));
}

std::string entries(const CommandInfo& info, bool positional, std::string_view heading) {
  std::string text;
  for (const OptionInfo& option : info.options)
    if (option.positional == positional) text += option_entry(option);
  return text.empty() ? text : fmt::format(".SH {}\n{}", heading, text);
}

/// What stands below the options: examples are what is indented below that word.
std::string footer_sections(std::string_view footer) {
  std::string examples, notes;
  for (const std::string_view line : lines_of(footer)) {
    if (line == "Examples:") continue;
    (line.starts_with("  ") ? examples : notes) +=
        plain(line.substr(line.starts_with("  ") ? 2 : 0)) + "\n";
  }
  std::string text;
  if (!notes.empty()) text += ".SH NOTES\n" + notes;
  if (!examples.empty()) text += ".SH EXAMPLES\n.nf\n" + examples + ".fi\n";
  return text;
}

void add_pages(const CommandInfo& info, const std::string& command, const std::string& version,
               std::vector<ManualPage>& pages) {
  std::string name = command;
  for (char& c : name) c = c == ' ' ? '-' : c;
  std::string text = beginning(name, info.what, version) + synopsis(command, info);
  text += ".SH DESCRIPTION\n" + plain(sentence(info.what)) + "\n";
  std::string below;
  for (const CommandInfo& other : info.commands) {
    text += fmt::format(".TP\n{}\n{}; see {}(1).\n", bold(other.name),
                        plain(sentence(other.what).substr(0, sentence(other.what).size() - 1)),
                        bold(fmt::format("{}-{}", name, other.name)));
    below += fmt::format("{}{}(1)", below.empty() ? "" : ",\n",
                         bold(fmt::format("{}-{}", name, other.name)));
  }
  text += entries(info, true, "ARGUMENTS") + entries(info, false, "OPTIONS");
  text += footer_sections(info.footer);
  const std::size_t up = name.rfind('-');
  text +=
      fmt::format(".SH SEE ALSO\n{}\n", below.empty() ? bold(name.substr(0, up)) + "(1)" : below);
  pages.push_back({name + ".1", std::move(text)});
  for (const CommandInfo& other : info.commands)
    add_pages(other, command + " " + other.name, version, pages);
}

}  // namespace

std::vector<ManualPage> manual_pages(const CommandInfo& program, const std::string& version) {
  std::vector<ManualPage> pages;
  add_pages(program, program.name, version, pages);
  return pages;
}

ManualPage manual_page_of_help(const std::string& help, const std::string& version) {
  const std::vector<std::string_view> lines = lines_of(help);
  const std::string_view usage = lines.front().substr(0, lines.front().find(": "));
  const std::string_view what = lines.front().substr(usage.size() + 2);
  const std::string name(usage.substr(0, usage.find(' ')));
  std::string text = beginning(name, what, version) + bold(name) + plain(usage.substr(name.size()));
  text += "\n.SH DESCRIPTION\n" + plain(sentence(std::string(what))) + "\n.SH OPTIONS\n";
  for (const std::string_view line : lines) {
    if (line.data() == lines.front().data()) continue;
    const std::size_t gap = line.find("  ", 2);  // between an option and what it does
    if (line.empty())
      text += ".PP\n";
    else if (line.starts_with("  -") || line.starts_with("  +"))
      text +=
          fmt::format(".TP\n{}\n{}\n", bold(line.substr(2, std::min(gap, line.size()) - 2)),
                      gap == line.npos ? "" : plain(line.substr(line.find_first_not_of(' ', gap))));
    else
      text += plain(line) + "\n";
  }
  return {name + ".1", text + ".SH SEE ALSO\n" + bold("zraka") + "(1)\n"};
}

}  // namespace zraka::app
