// SPDX-License-Identifier: Apache-2.0
// The words and numbers of Tachyon's scene files, between white space, with no copy made of any.
#pragma once

#include <string>
#include <string_view>
#include <zraka/diagnostic.hpp>

#include "core/text.hpp"

namespace zraka {

/// Whether a word is a keyword, which is given in capitals; Tachyon takes either case.
bool is_keyword(std::string_view word, std::string_view keyword);

/// One file, read from front to back.
class TachyonText {
 public:
  TachyonText(std::string_view text, std::string name)
      : begin_(text.data()),
        at_(begin_),
        end_(begin_ + text.size()),
        name_(std::move(name)),
        places_(text) {}

  const std::string& name() const { return name_; }
  /// Goes to the next word.
  const char* place();
  bool ended() { return place() == end_; }
  /// The next word, "" at the end; take() goes behind it.
  std::string_view peek();
  std::string_view take();
  /// Goes behind a keyword, if it is there.
  bool take_keyword(std::string_view keyword);
  /// Goes behind a finite number, if one is there.
  bool take_number(double& value);
  void skip_line();
  void stop() { at_ = end_; }
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }

  Diagnostic diagnostic(Severity severity, const char* at, std::string message,
                        std::string hint = {});

 private:
  const char *begin_, *at_, *end_;
  std::string name_;
  TextPositions places_;
};

}  // namespace zraka
