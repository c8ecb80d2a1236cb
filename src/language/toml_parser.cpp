// SPDX-License-Identifier: Apache-2.0
// Reads TOML line by line; what is wrong with one is said, and the reading goes on where a line
// begins something new.
#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"
#include "language/toml.hpp"
#include "language/toml_values.hpp"

namespace zraka::toml {
namespace {

using NodeKind = Node::Kind;
using Made = Node::Made;

bool is_key_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-';
}

bool is_space(char c) {
  return c == ' ' || c == '\t';
}

struct Key {
  std::string_view name;
  std::size_t position = 0;
};

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Document parse();

 private:
  bool fail(std::size_t position, std::string message, std::string hint = {}) {
    document_.problems.push_back({position, std::move(message), std::move(hint)});
    return false;
  }
  bool fail(Problem&& problem) {
    document_.problems.push_back(std::move(problem));
    return false;
  }
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool at_line_end() const {
    return at_ >= text_.size() || text_[at_] == '\n' || text_.substr(at_, 2) == "\r\n";
  }
  std::string found() const;
  void skip_space();
  void skip_comment();
  void skip_lines();
  void recover();
  bool end_line();
  bool read_text(bool key, std::string_view& value);
  bool read_key(Key& key);
  bool read_path(std::vector<Key>& path);
  bool read_statement();
  bool read_header();
  bool read_pair(Node& table, int depth);
  bool read_value(Node& node, int depth);
  bool read_array(Node& node, int depth);
  bool read_inline_table(Node& node, int depth);
  bool redefined(const Key& key, const Node& before);

  std::string_view text_;
  std::size_t at_ = 0;
  Document document_;
  Node lost_;              ///< takes the pairs below a broken header
  Node* table_ = nullptr;  ///< that pairs belong to
  int depth_ = 1;          ///< of table_
};

/// What stands here, for messages.
std::string Parser::found() const {
  if (at_ >= text_.size()) return "the file ends";
  if (at_line_end()) return "the line ends";
  std::size_t end = at_;
  while (end < text_.size() && is_key_letter(text_[end])) ++end;
  if (end == at_)
    while (++end < text_.size() && (text_[end] & 0xC0) == 0x80) {
    }
  return fmt::format("'{}' stands here", shown(text_.substr(at_, end - at_)));
}

void Parser::skip_space() {
  while (at_ < text_.size() && is_space(text_[at_])) ++at_;
}

void Parser::skip_comment() {
  skip_space();
  if (peek() == '#') at_ = std::min(text_.find('\n', at_), text_.size());
}

/// Space, comments and ends of lines.
void Parser::skip_lines() {
  for (;;) {
    skip_comment();
    if (at_ >= text_.size() || !at_line_end()) return;
    at_ += text_[at_] == '\n' ? 1 : 2;
  }
}

/// On to a line that looks like the beginning of something: a header, or a key and '='.
void Parser::recover() {
  while (at_ < text_.size()) {
    at_ = std::min(text_.find('\n', at_), text_.size());
    if (at_ < text_.size()) ++at_;
    std::size_t i = at_;
    while (i < text_.size() && (is_space(text_[i]) || text_[i] == '[')) ++i;
    const bool header = i > at_ && text_[i - 1] == '[';
    const std::size_t word = i;
    while (i < text_.size() && is_key_letter(text_[i])) ++i;
    const bool named = i > word && (text_[word] < '0' || text_[word] > '9');
    while (i < text_.size() && is_space(text_[i])) ++i;
    if (named && (header || (i < text_.size() && text_[i] == '='))) return;
  }
}

bool Parser::end_line() {
  skip_comment();
  if (at_line_end()) return true;
  const bool comma = peek() == ',';
  return fail(
      at_, fmt::format("{}: expected the end of the line", found()),
      comma ? "numbers have a decimal point, and several stand in brackets: [1, 2, 3]" : "");
}

bool Parser::read_text(bool key, std::string_view& value) {
  String read = read_string(text_, at_, key);
  if (!read.problem.message.empty()) return fail(std::move(read.problem));
  at_ = read.end;
  value = read.is_plain ? read.plain : document_.texts.emplace_back(std::move(read.decoded));
  return true;
}

bool Parser::read_key(Key& key) {
  skip_space();
  key.position = at_;
  if (peek() == '"' || peek() == '\'') return read_text(true, key.name);
  std::size_t end = at_;
  while (end < text_.size() && is_key_letter(text_[end])) ++end;
  if (end == at_) return fail(at_, fmt::format("{}: expected a key", found()));
  key.name = text_.substr(at_, end - at_);
  at_ = end;
  return true;
}

/// Keys between dots.
bool Parser::read_path(std::vector<Key>& path) {
  for (;;) {
    if (!read_key(path.emplace_back())) return false;
    if (path.size() > static_cast<std::size_t>(kDeepest))
      return fail(path.front().position, "this key has too many parts");
    skip_space();
    if (peek() != '.') return true;
    ++at_;
  }
}

bool Parser::redefined(const Key& key, const Node& before) {
  const TextPosition first = TextPositions(text_).at(before.key_begin);
  return fail(key.position, fmt::format("'{}' stands here for the second time", shown(key.name)),
              fmt::format("the first time was in line {}", first.line));
}

/// [a.b] or [[a.b]].
bool Parser::read_header() {
  table_ = &lost_;
  lost_ = {};
  depth_ = 1;
  const std::size_t begin = at_;
  const bool list = text_.substr(at_, 2) == "[[";
  at_ += list ? 2 : 1;
  std::vector<Key> path;
  if (!read_path(path)) return false;
  const std::string_view close = list ? "]]" : "]";
  if (!text_.substr(at_).starts_with(close))
    return fail(at_, fmt::format("{}: expected '{}'", found(), close));
  at_ += close.size();
  const std::size_t end = at_;
  if (!end_line()) return false;

  Node* table = &document_.root;
  const auto begins_here = [&](Node& node, const Key& key, Made made) {
    node.made = made;
    node.key_begin = static_cast<std::uint32_t>(key.position);
    node.begin = static_cast<std::uint32_t>(begin);
    node.end = static_cast<std::uint32_t>(end);
  };
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool last = i + 1 == path.size();
    Node* child = table->find(path[i].name);
    if (child == nullptr) {
      child = &table->add(path[i].name);
      child->kind = last && list ? NodeKind::array : NodeKind::table;
      begins_here(*child, path[i],
                  !last  ? Made::in_passing
                  : list ? Made::by_headers
                         : Made::by_header);
    } else if (last && !list) {
      if (child->kind != NodeKind::table || child->made != Made::in_passing)
        return redefined(path[i], *child);
      begins_here(*child, path[i], Made::by_header);
    } else if (child->made == Made::by_value || child->kind > NodeKind::array ||
               (last && child->made != Made::by_headers)) {
      return redefined(path[i], *child);
    }
    if (child->kind == NodeKind::array) {  // of headers: the table that was begun last
      if (last) begins_here(child->children.emplace_back(), path[i], Made::by_header);
      child = &child->children.back();
    }
    table = child;
  }
  table_ = table;
  depth_ = 1 + static_cast<int>(path.size());
  return true;
}

/// key = value, into a table or one of those that the key's dots go through.
bool Parser::read_pair(Node& into, int depth) {
  std::vector<Key> path;
  if (!read_path(path)) return false;
  if (peek() != '=') return fail(at_, fmt::format("{}: expected '=' behind the key", found()));
  ++at_;
  skip_space();
  Node* table = &into;
  for (std::size_t i = 0; i + 1 < path.size(); ++i, ++depth) {
    Node* child = table->find(path[i].name);
    if (child == nullptr) {
      child = &table->add(path[i].name);
      child->made = Made::by_dots;
      child->key_begin = child->begin = static_cast<std::uint32_t>(path[i].position);
      child->end = static_cast<std::uint32_t>(path[i].position + path[i].name.size());
    } else if (child->kind != NodeKind::table || child->made != Made::by_dots) {
      return redefined(path[i], *child);
    }
    table = child;
  }
  Node value;
  if (!read_value(value, depth)) return false;
  if (const Node* before = table->find(path.back().name)) {
    redefined(path.back(), *before);
    return true;  // the line is understood
  }
  Node& child = table->add(path.back().name);
  value.key = child.key;
  value.key_begin = static_cast<std::uint32_t>(path.back().position);
  child = std::move(value);
  return true;
}

bool Parser::read_value(Node& node, int depth) {
  node.made = Made::by_value;
  node.begin = static_cast<std::uint32_t>(at_);
  if (depth >= kDeepest)
    return fail(at_,
                fmt::format("tables and arrays are more than {} deep in each other", kDeepest));
  const char c = peek();
  bool good = false;
  if (c == '"' || c == '\'') {
    node.kind = NodeKind::text;
    good = read_text(false, node.text);
  } else if (c == '[') {
    good = read_array(node, depth);
  } else if (c == '{') {
    good = read_inline_table(node, depth);
  } else {
    std::size_t end = at_;
    while (end < text_.size() && (is_key_letter(text_[end]) || text_[end] == '+' ||
                                  text_[end] == '.' || text_[end] == ':'))
      ++end;
    if (end == at_) return fail(at_, fmt::format("{}: expected a value", found()));
    Problem problem = read_word(text_.substr(at_, end - at_), node);
    problem.position = at_;
    if (!problem.message.empty()) return fail(std::move(problem));
    at_ = end;
    good = true;
  }
  node.end = static_cast<std::uint32_t>(at_);
  return good;
}

bool Parser::read_array(Node& node, int depth) {
  node.kind = NodeKind::array;
  const std::size_t begin = at_++;
  for (;;) {
    skip_lines();
    if (peek() == ']') break;
    if (at_ >= text_.size()) return fail(begin, "this '[' is never closed");
    if (!read_value(node.children.emplace_back(), depth + 1)) return false;
    skip_lines();
    if (peek() == ']') break;
    if (peek() != ',')
      return at_ >= text_.size() ? fail(begin, "this '[' is never closed")
                                 : fail(at_, fmt::format("{}: expected ',' or ']'", found()));
    ++at_;
  }
  ++at_;
  return true;
}

bool Parser::read_inline_table(Node& node, int depth) {
  node.kind = NodeKind::table;
  const std::size_t begin = at_++;
  for (;;) {
    skip_lines();
    if (peek() == '}') break;
    if (at_ >= text_.size()) return fail(begin, "this '{' is never closed");
    if (!read_pair(node, depth + 1) || document_.problems.size() >= kEnoughProblems) return false;
    skip_lines();
    if (peek() == '}') break;
    if (peek() != ',')
      return at_ >= text_.size() ? fail(begin, "this '{' is never closed")
                                 : fail(at_, fmt::format("{}: expected ',' or '}}'", found()));
    ++at_;
  }
  ++at_;
  return true;
}

bool Parser::read_statement() {
  if (peek() == '[') return read_header();
  return read_pair(*table_, depth_) && end_line();
}

Document Parser::parse() {
  table_ = &document_.root;
  document_.root.made = Made::by_header;
  if (!is_utf8(text_)) {
    fail(0, "is no text in UTF-8");
    return std::move(document_);
  }
  for (;;) {
    skip_lines();
    if (at_ >= text_.size()) break;
    const bool understood = read_statement();
    if (document_.problems.size() >= kEnoughProblems) break;
    if (!understood) recover();
  }
  return std::move(document_);
}

}  // namespace

Document parse(std::string_view text) {
  return Parser(text).parse();
}

}  // namespace zraka::toml
