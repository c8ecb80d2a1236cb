// SPDX-License-Identifier: Apache-2.0
#include "formats/tachyon_text.hpp"

#include <algorithm>
#include <cmath>

namespace zraka {
namespace {

bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}

char capital(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
}

}  // namespace

bool is_keyword(std::string_view word, std::string_view keyword) {
  return word.size() == keyword.size() &&
         std::equal(word.begin(), word.end(), keyword.begin(),
                    [](char a, char b) { return capital(a) == b; });
}

const char* TachyonText::place() {
  while (at_ != end_ && is_space(*at_)) ++at_;
  return at_;
}

std::string_view TachyonText::peek() {
  const char* const from = place();
  return {from, static_cast<std::size_t>(std::find_if(from, end_, is_space) - from)};
}

std::string_view TachyonText::take() {
  const std::string_view word = peek();
  at_ += word.size();
  return word;
}

bool TachyonText::take_keyword(std::string_view keyword) {
  const char* const from = place();
  const auto rest = static_cast<std::size_t>(end_ - from);
  if (rest < keyword.size() || !is_keyword({from, keyword.size()}, keyword)) return false;
  if (rest > keyword.size() && !is_space(from[keyword.size()])) return false;
  at_ = from + keyword.size();
  return true;
}

bool TachyonText::take_number(double& value) {
  const char* const from = place();
  double read = 0;
  const char* stop = read_number(from, end_, read);
  if (stop == nullptr || (stop != end_ && !is_space(*stop))) {
    const std::string_view word = peek();  // +1, or what is too small for a double
    const std::optional<double> number = parse_number(word);
    if (!number) return false;
    read = *number;
    stop = from + word.size();
  }
  if (!std::isfinite(read)) return false;
  value = read;
  at_ = stop;
  return true;
}

void TachyonText::skip_line() {
  at_ = std::find_if(at_, end_, is_line_end);
}

Diagnostic TachyonText::diagnostic(Severity severity, const char* at, std::string message,
                                   std::string hint) {
  const auto position = static_cast<std::size_t>(at - begin_);
  const TextPosition found = places_.at(position);
  return {severity,
          name_,
          found.line,
          found.column,
          std::move(message),
          std::move(hint),
          places_.excerpt(position)};
}

}  // namespace zraka
