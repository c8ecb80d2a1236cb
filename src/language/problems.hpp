// SPDX-License-Identifier: Apache-2.0
// The problems of a scene file, with their places.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>
#include <zraka/diagnostic.hpp>

#include "language/toml.hpp"

namespace zraka::language {

class Problems {
 public:
  Problems(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  void error(std::size_t position, std::string message, std::string hint = {});
  void warn(std::size_t position, std::string message, std::string hint = {});
  /// Something that should be in the file is not: said only where all of the file could be read.
  void missing(std::size_t position, std::string message, std::string hint = {});
  /// `what` has no `word`: the hint names the nearest of those known, or all of them.
  void unknown(std::size_t position, std::string message, std::string_view word,
               std::span<const std::string_view> known, std::string_view plural);

  /// Such a hint.
  std::string hint_at(std::string_view word, std::span<const std::string_view> known,
                      std::string_view plural) const;

  void take(std::vector<toml::Problem>&& broken);
  std::size_t errors() const { return errors_; }
  bool enough() const { return found_.size() >= toml::kEnoughProblems; }
  /// What the file says, as it stands there.
  std::string_view source(const toml::Node& node) const {
    return text_.substr(node.begin, node.end - node.begin);
  }
  /// In the order of the file.
  Diagnostics finish();

 private:
  struct Found {
    Severity severity;
    std::size_t position;
    std::string message, hint;
  };
  void add(Severity severity, std::size_t position, std::string message, std::string hint);

  std::string_view text_;
  std::string name_;
  std::vector<Found> found_;
  std::size_t errors_ = 0;
  bool broken_ = false;
};

}  // namespace zraka::language
