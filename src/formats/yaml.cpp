// SPDX-License-Identifier: Apache-2.0
#include "formats/yaml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"

namespace zraka::yaml {
namespace {

constexpr int kDeepest = 64;

struct Line {
  std::size_t number = 0, indent = 0;
  std::string_view text;  ///< without its indentation, comment and end
};

/// Up to a # that begins a word, but in quotes.
std::string_view without_comment(std::string_view line) {
  char quote = '\0';
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '#' && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t')) {
      return line.substr(0, i);
    }
  }
  return line;
}

class Parser {
 public:
  Parser(std::string_view text, const std::string& file) : file_(file) {
    std::size_t number = 0;
    while (!text.empty()) {
      const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
      std::string_view line = without_comment(text.substr(0, end));
      const bool is_pair = text.substr(end, 2) == "\r\n";
      text.remove_prefix(std::min(end + (is_pair ? 2 : 1), text.size()));
      ++number;
      const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
      line = trimmed(line);
      if (!line.empty() && line != "---" && line != "...") lines_.push_back({number, indent, line});
    }
  }

  Result<Node> parse() {
    Node root;
    if (!lines_.empty()) root = block(lines_[0].indent, 0);
    if (problems_.empty() && at_ < lines_.size())
      fail(lines_[at_].number, "this line does not belong to what stands above it");
    if (!problems_.empty()) return tl::make_unexpected(std::move(problems_));
    return root;
  }

 private:
  bool good() const { return problems_.empty(); }
  void fail(std::size_t line, std::string message) {
    if (good()) problems_.push_back({.file = file_, .line = line, .message = std::move(message)});
  }

  static bool is_item(std::string_view text) { return text == "-" || text.starts_with("- "); }

  /// Where the colon behind a key is; npos where there is none.
  static std::size_t colon_of(std::string_view text) {
    if (text.empty() || text[0] == '[' || text[0] == '{') return std::string_view::npos;
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == ':' && (i + 1 == text.size() || text[i + 1] == ' ' || text[i + 1] == '\t'))
        return i;
    return std::string_view::npos;
  }

  /// All that stands at an indentation, from the current line on.
  Node block(std::size_t indent, int depth) {
    Node node;
    if (depth > kDeepest) {
      fail(lines_[at_].number,
           fmt::format("values are more than {} deep in each other", +kDeepest));
      return node;
    }
    node.line = lines_[at_].number;
    if (is_item(lines_[at_].text))
      read_list(indent, depth, node);
    else if (colon_of(lines_[at_].text) != std::string_view::npos)
      read_map(indent, depth, node);
    else
      node = inline_value(std::string(lines_[at_].text), depth);
    return node;
  }

  void read_list(std::size_t indent, int depth, Node& node) {
    node.kind = Node::Kind::list;
    while (good() && at_ < lines_.size() && lines_[at_].indent == indent &&
           is_item(lines_[at_].text)) {
      Line& line = lines_[at_];
      const std::string_view rest = trimmed(line.text.substr(1));
      if (rest.empty()) {
        node.items.push_back(nested(indent, line.number, depth));
      } else {
        // What follows the dash is a block of its own, indented as it stands.
        line.indent += static_cast<std::size_t>(rest.data() - line.text.data());
        line.text = rest;
        node.items.push_back(block(line.indent, depth + 1));
      }
    }
  }

  void read_map(std::size_t indent, int depth, Node& node) {
    node.kind = Node::Kind::map;
    while (good() && at_ < lines_.size() && lines_[at_].indent == indent &&
           !is_item(lines_[at_].text)) {
      const Line line = lines_[at_];
      const std::size_t colon = colon_of(line.text);
      if (colon == std::string_view::npos)
        return fail(line.number,
                    fmt::format("'{}' has no colon: expected key: value", shown(line.text)));
      const std::string key(trimmed(line.text.substr(0, colon)));
      const std::string_view rest = trimmed(line.text.substr(colon + 1));
      node.members.emplace_back(key, rest.empty() ? nested_in_map(indent, line.number, depth)
                                                  : inline_value(std::string(rest), depth));
    }
  }

  /// Below a line that ends with a dash: what is indented more.
  Node nested(std::size_t indent, std::size_t number, int depth) {
    ++at_;
    if (at_ < lines_.size() && lines_[at_].indent > indent)
      return block(lines_[at_].indent, depth + 1);
    Node none;
    none.line = number;
    return none;
  }

  /// Below a key: what is indented more, or a list at the same indentation.
  Node nested_in_map(std::size_t indent, std::size_t number, int depth) {
    if (at_ + 1 < lines_.size() && lines_[at_ + 1].indent == indent &&
        is_item(lines_[at_ + 1].text)) {
      ++at_;
      return block(indent, depth + 1);
    }
    return nested(indent, number, depth);
  }

  /// A value on a line; one in brackets may go on over more.
  Node inline_value(std::string text, int depth) {
    const std::size_t number = lines_[at_].number;
    ++at_;
    if (text[0] == '[' || text[0] == '{') {
      const auto open_in = [](std::string_view s) {
        std::ptrdiff_t open = 0;
        for (const char c : s) open += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
        return open;
      };
      constexpr std::size_t kLongest = 1 << 16;
      std::ptrdiff_t open = open_in(text);
      for (; open > 0 && at_ < lines_.size() && text.size() < kLongest; ++at_) {
        open += open_in(lines_[at_].text);
        text += ' ';
        text += lines_[at_].text;
      }
    }
    std::string_view rest = text;
    Node node = flow(rest, number, depth);
    if (good() && !trimmed(rest).empty())
      fail(number, fmt::format("'{}' stands behind the value's end", shown(trimmed(rest))));
    return node;
  }

  Node flow(std::string_view& text, std::size_t number, int depth) {
    Node node;
    node.line = number;
    text = trimmed(text);
    if (depth > kDeepest) {
      fail(number, fmt::format("values are more than {} deep in each other", +kDeepest));
    } else if (text.starts_with('[') || text.starts_with('{')) {
      flow_items(text, number, depth, node);
    } else if (text.starts_with('"') || text.starts_with('\'')) {
      const std::size_t end = text.find(text[0], 1);
      if (end == std::string_view::npos)
        fail(number, "a quote is not closed");
      else
        node.text = text.substr(1, end - 1), text.remove_prefix(end + 1);
    } else {
      const std::size_t end =
          is_in_brackets_ > 0 ? std::min(text.find_first_of(",]}"), text.size()) : text.size();
      node.text = trimmed(text.substr(0, end));
      text.remove_prefix(end);
    }
    return node;
  }

  void flow_items(std::string_view& text, std::size_t number, int depth, Node& node) {
    const bool is_map = text[0] == '{';
    const char close = is_map ? '}' : ']';
    node.kind = is_map ? Node::Kind::map : Node::Kind::list;
    text = trimmed(text.substr(1));
    ++is_in_brackets_;
    while (good() && !text.empty() && text[0] != close) {
      if (is_map) {
        const std::size_t colon = text.find(':');
        if (colon == std::string_view::npos) break;
        const std::string key(trimmed(text.substr(0, colon)));
        text.remove_prefix(colon + 1);
        node.members.emplace_back(key, flow(text, number, depth + 1));
      } else {
        node.items.push_back(flow(text, number, depth + 1));
      }
      text = trimmed(text);
      if (!text.starts_with(',')) break;
      text = trimmed(text.substr(1));
    }
    --is_in_brackets_;
    if (!good()) return;
    if (!text.starts_with(close))
      return fail(number, fmt::format("a bracket is not closed by {}", close));
    text.remove_prefix(1);
  }

  const std::string& file_;
  std::vector<Line> lines_;
  std::size_t at_ = 0;
  int is_in_brackets_ = 0;
  Diagnostics problems_;
};

}  // namespace

const Node* Node::find(std::string_view key) const {
  for (const auto& [name, value] : members)
    if (name == key) return &value;
  return nullptr;
}

std::optional<double> Node::number() const {
  const std::optional<double> value = kind == Kind::scalar ? parse_number(text) : std::nullopt;
  return value && std::isfinite(*value) ? value : std::nullopt;
}

Result<Node> parse(std::string_view text, const std::string& file) {
  return Parser(text, file).parse();
}

}  // namespace zraka::yaml
