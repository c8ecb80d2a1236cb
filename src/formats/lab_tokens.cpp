// SPDX-License-Identifier: Apache-2.0
#include "formats/lab_tokens.hpp"

#include "core/text.hpp"

namespace zraka::lab {

bool Tokens::next(Token& token) {
  token = {};
  std::string collected;
  bool started = false;
  for (; at_ < text_.size(); ++at_) {
    const char c = text_[at_];
    if (c == '<') {
      // Up to the first '>', however many '<' come before it.
      const std::size_t end = text_.find('>', at_);
      if (end == std::string_view::npos) {
        strays.push_back({'<', at_});
        at_ = text_.size();
        break;
      }
      if (!started) token.labelled = true;
      at_ = end;
      continue;
    }
    if (c == '>') {
      if (strays.size() < kMostStrays) strays.push_back({'>', at_});
      continue;
    }
    if (c == ',' || c == ':') {
      token.text = trimmed(collected);
      if (!started) token.position = at_;
      ++at_;
      return true;
    }
    const bool space = c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
    if (!started && !space) started = true, token.position = at_;
    if (started) collected += c;
  }
  token.text = trimmed(collected);
  token.last = true;
  if (!started) token.position = at_;
  return started;
}

}  // namespace zraka::lab
