// SPDX-License-Identifier: Apache-2.0
// An explanation for people at a terminal: the tree with every term, and what it comes to in words.
#pragma once

#include <string>
#include <zraka/explain.hpp>

#include "core/words.hpp"

namespace zraka {

struct TextOptions {
  Language language = Language::english;
  bool color = false;   ///< with a terminal's colour codes
  std::string scene{};  ///< its name
  std::optional<ProfileName> profile{};
  /// Only what the rays from the eye sum up: of rays below them what they bring back, no title,
  /// no sentence.
  bool sums_only = false;
};

std::string to_text(const Explanation& explanation, const TextOptions& options);

}  // namespace zraka
