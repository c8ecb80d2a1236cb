// SPDX-License-Identifier: Apache-2.0
#include "language/problems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "core/nearest.hpp"
#include "core/text.hpp"

namespace zraka::language {

void Problems::add(Severity severity, std::size_t position, std::string message, std::string hint) {
  errors_ += severity == Severity::error;
  if (found_.size() < toml::kEnoughProblems)
    found_.push_back({severity, position, std::move(message), std::move(hint)});
}

void Problems::error(std::size_t position, std::string message, std::string hint) {
  add(Severity::error, position, std::move(message), std::move(hint));
}

void Problems::warn(std::size_t position, std::string message, std::string hint) {
  add(Severity::warning, position, std::move(message), std::move(hint));
}

void Problems::missing(std::size_t position, std::string message, std::string hint) {
  if (!broken_) error(position, std::move(message), std::move(hint));
}

void Problems::unknown(std::size_t position, std::string message, std::string_view word,
                       std::span<const std::string_view> known, std::string_view plural) {
  constexpr std::size_t kMostNamed = 20;
  if (enough()) {  // to look for what was meant takes as long as all known words
    ++errors_;
    return;
  }
  std::string hint;
  if (const auto meant = nearest_of(word, {known.begin(), known.end()})) {
    hint = fmt::format("did you mean '{}'?", *meant);
  } else if (known.empty()) {
    hint = fmt::format("there are no {}", plural);
  } else {
    hint = fmt::format("{}: {}", plural,
                       fmt::join(known.first(std::min(known.size(), kMostNamed)), ", "));
    if (known.size() > kMostNamed) hint += ", …";
  }
  error(position, std::move(message), std::move(hint));
}

void Problems::take(std::vector<toml::Problem>&& broken) {
  broken_ = broken_ || !broken.empty();
  for (toml::Problem& problem : broken)
    error(problem.position, std::move(problem.message), std::move(problem.hint));
}

Diagnostics Problems::finish() {
  // In the order of the file, and of finding at one place of it.
  std::vector<std::pair<std::size_t, std::size_t>> order;
  for (std::size_t i = 0; i < found_.size(); ++i) order.emplace_back(found_[i].position, i);
  std::sort(order.begin(), order.end());
  Diagnostics all;
  TextPositions positions(text_);
  for (const auto& [position, index] : order) {
    Found& found = found_[index];
    const TextPosition at = positions.at(found.position);
    all.push_back({found.severity, name_, at.line, at.column, std::move(found.message),
                   std::move(found.hint), positions.excerpt(found.position)});
  }
  if (enough())
    all.push_back({.file = name_, .message = "too many problems; no more of them are shown"});
  return all;
}

}  // namespace zraka::language
