// SPDX-License-Identifier: Apache-2.0
#include "language/toml_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "core/text.hpp"

namespace zraka::toml {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_hexadecimal(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

bool is_octal(char c) {
  return c >= '0' && c <= '7';
}

bool is_binary(char c) {
  return c == '0' || c == '1';
}

/// Digits, and between two of them an underscore.
bool are_digits(std::string_view word, bool (*accepts)(char)) {
  if (word.empty() || word.front() == '_' || word.back() == '_') return false;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (word[i] == '_' ? word[i + 1] == '_' : !accepts(word[i])) return false;
  return true;
}

std::string without_underscores(std::string_view word) {
  std::string plain(word);
  plain.erase(std::remove(plain.begin(), plain.end(), '_'), plain.end());
  return plain;
}

bool is_date(std::string_view word) {
  return (word.size() >= 10 && is_digit(word[0]) && word[4] == '-' && word[7] == '-') ||
         (word.size() >= 8 && is_digit(word[0]) && word[2] == ':' && word[5] == ':');
}

/// 0x1F, 0o17, 0b11: whether it is one.
bool read_based(std::string_view word, Node& node, Problem& problem) {
  if (word.size() < 3 || word[0] != '0') return false;
  const char kind = word[1];
  if (kind != 'x' && kind != 'o' && kind != 'b') return false;
  const auto accepts = kind == 'x' ? is_hexadecimal : kind == 'o' ? is_octal : is_binary;
  if (!are_digits(word.substr(2), accepts)) return false;
  const std::string digits = without_underscores(word.substr(2));
  const int base = kind == 'x' ? 16 : kind == 'o' ? 8 : 2;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), node.integer, base);
  if (error != std::errc()) problem.message = fmt::format("'{}' is too large", shown(word));
  node.kind = Node::Kind::integer;
  node.number = static_cast<double>(node.integer);
  return true;
}

/// Digits without a needless 0 before them, a point with digits behind it, an exponent.
bool is_decimal(std::string_view word, bool& whole) {
  std::size_t end = word.find_first_of(".eE");
  whole = end == std::string_view::npos;
  const std::string_view before = word.substr(0, end);
  if (!are_digits(before, is_digit) || (before.size() > 1 && before[0] == '0')) return false;
  if (whole) return true;
  if (word[end] == '.') {
    const std::size_t exponent = word.find_first_of("eE", end);
    const std::size_t last = std::min(exponent, word.size());
    if (!are_digits(word.substr(end + 1, last - end - 1), is_digit)) return false;
    if (exponent == std::string_view::npos) return true;
    end = exponent;
  }
  std::string_view power = word.substr(end + 1);
  if (!power.empty() && (power[0] == '+' || power[0] == '-')) power.remove_prefix(1);
  return are_digits(power, is_digit);
}

void append_utf8(std::string& out, std::uint32_t c) {
  const auto put = [&](std::uint32_t byte) { out += static_cast<char>(byte); };
  if (c < 0x80) return put(c);
  if (c < 0x800) {
    put(0xC0 | c >> 6);
  } else {
    if (c < 0x10000) {
      put(0xE0 | c >> 12);
    } else {
      put(0xF0 | c >> 18);
      put(0x80 | (c >> 12 & 0x3F));
    }
    put(0x80 | (c >> 6 & 0x3F));
  }
  put(0x80 | (c & 0x3F));
}

/// What a backslash begins, from the character behind it on: the position behind it, or 0.
std::size_t read_escape(std::string_view text, std::size_t at, bool lines, std::string& out) {
  constexpr std::string_view kLetters = "btnfr\"\\e", kMeanings = "\b\t\n\f\r\"\\\x1B";
  if (at >= text.size()) return 0;
  if (const std::size_t which = kLetters.find(text[at]); which != std::string_view::npos) {
    out += kMeanings[which];
    return at + 1;
  }
  if (text[at] == 'u' || text[at] == 'U') {
    const std::size_t digits = text[at] == 'u' ? 4 : 8;
    const std::string_view code = text.substr(at + 1, digits);
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), value, 16);
    if (error != std::errc() || code.size() < digits || end != code.data() + digits ||
        value > 0x10FFFF || (value >= 0xD800 && value < 0xE000))
      return 0;
    append_utf8(out, value);
    return at + 1 + digits;
  }
  // At a line's end it joins the lines.
  const std::size_t end = text.find_first_not_of(" \t", at);
  if (!lines || end == std::string_view::npos || (text[end] != '\n' && text[end] != '\r')) return 0;
  return std::min(text.find_first_not_of(" \t\r\n", end), text.size());
}

}  // namespace

Problem read_word(std::string_view word, Node& node) {
  Problem problem;
  if (word == "true" || word == "false") {
    node.kind = Node::Kind::boolean;
    node.truth = word == "true";
    return problem;
  }
  if (read_based(word, node, problem)) return problem;
  std::string_view digits = word;
  const bool negative = digits.starts_with('-');
  if (digits.starts_with('+') || negative) digits.remove_prefix(1);
  bool whole = false;
  if (digits == "inf" || digits == "nan") {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    node.kind = Node::Kind::number;
    node.number = digits == "nan" ? std::numeric_limits<double>::quiet_NaN()
                  : negative      ? -kInfinity
                                  : kInfinity;
  } else if (is_decimal(digits, whole)) {
    const std::string plain = (negative ? "-" : "") + without_underscores(digits);
    const char *begin = plain.data(), *end = begin + plain.size();
    node.kind = Node::Kind::number;
    if (read_number(begin, end, node.number) == nullptr) node.number = *parse_number(plain);
    if (whole && std::from_chars(begin, end, node.integer).ec == std::errc())
      node.kind = Node::Kind::integer;
  } else if (is_date(word)) {
    problem.message = fmt::format("'{}' is a date: nothing of a scene is one", shown(word));
  } else if (!digits.empty() && (is_digit(digits[0]) || digits[0] == '.')) {
    problem.message = fmt::format("'{}' is not a number of TOML", shown(word));
    problem.hint = "digits stand on both sides of a point, and no 0 before other digits";
  } else {
    problem.message = fmt::format("'{}' is not a value", shown(word));
    problem.hint = "text stands in quotes: \"…\"";
  }
  return problem;
}

String read_string(std::string_view text, std::size_t begin, bool key) {
  const char quote = text[begin];
  const std::string three(3, quote);
  const bool lines = text.substr(begin, 3) == three && !key;
  const bool literal = quote == '\'';
  String read;
  std::size_t at = begin + (lines ? 3 : 1);
  if (lines && text.substr(at, 2) == "\r\n") ++at;
  if (lines && text.substr(at, 1) == "\n") ++at;
  const std::size_t first = at;
  for (; at < text.size();) {
    const char c = text[at];
    const auto code = static_cast<unsigned char>(c);
    if (c == quote && (!lines || text.substr(at, 3) == three)) {
      // Up to two quotes more belong to the text.
      std::size_t more = 0;
      while (lines && more < 2 && at + 3 + more < text.size() && text[at + 3 + more] == quote)
        ++more;
      at += more;
      if (read.is_plain)
        read.plain = text.substr(first, at - first);
      else
        read.decoded.append(more, quote);
      read.end = at + (lines ? 3 : 1);
      return read;
    }
    if (!lines && (c == '\n' || c == '\r')) break;
    if ((code < 0x20 && c != '\t' && !(lines && (c == '\n' || c == '\r'))) || code == 0x7F) {
      read.problem = {at, "a control character stands in a text"};
      return read;
    }
    if (literal || c != '\\') {
      if (!read.is_plain) read.decoded += c;
      ++at;
      continue;
    }
    if (read.is_plain) read.decoded = text.substr(first, at - first);
    read.is_plain = false;
    const std::size_t behind = read_escape(text, at + 1, lines, read.decoded);
    if (behind == 0) {
      read.problem = {at, "this backslash begins nothing that TOML knows",
                      "'…' takes backslashes as they are, in \"…\" they are written twice"};
      return read;
    }
    at = behind;
  }
  read.problem = {begin, "this text is never closed",
                  fmt::format("expected {} at its end", lines ? three : std::string(1, quote))};
  return read;
}

}  // namespace zraka::toml
