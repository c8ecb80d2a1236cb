// SPDX-License-Identifier: Apache-2.0
// What went wrong, where, and what to do about it: the only error type of the public API.
#pragma once

#include <cstddef>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace zraka {

enum class Severity { note, warning, error };

/// One problem, in words for people. A file of "" means that no file is concerned; line and column
/// count from 1 (columns in characters, not bytes), and 0 means "the file as a whole".
struct Diagnostic {
  Severity severity = Severity::error;
  std::string file{};
  std::size_t line = 0;
  std::size_t column = 0;
  std::string message{};
  std::string hint{};  ///< what to do about it; may be empty
  std::string
      excerpt{};  ///< the line of the file that is concerned, and a caret below it; may be empty
};

using Diagnostics = std::vector<Diagnostic>;

/// A value, or all the problems that stood in its way.
template <class T>
using Result = tl::expected<T, Diagnostics>;

/// `file:line:column: error: message`, the excerpt and the hint on lines of their own. Safe on a
/// terminal, whatever the file's name and text hold: controls are replaced.
std::string to_string(const Diagnostic& diagnostic);

/// A failed result with one error about a file as a whole (or about none, if `file` is empty).
tl::unexpected<Diagnostics> failure(std::string file, std::string message, std::string hint = {});

}  // namespace zraka
