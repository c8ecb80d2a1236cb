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
  if (broken_)
    ++errors_;  // not said, but whoever has read the thing must not use it
  else
    error(position, std::move(message), std::move(hint));
}

namespace {

/// "'a' or 'b'" of those known words of which the word is a part: fov of fov_deg.
std::string words_with_part(std::string_view word, std::span<const std::string_view> known) {
  std::string all;
  for (const std::string_view each : known) {
    std::string_view rest = each;
    for (bool found = false; !rest.empty() && !found;) {
      const std::size_t end = std::min(rest.find('_'), rest.size());
      found = rest.substr(0, end) == word && end < each.size();
      if (found) all += fmt::format("{}'{}'", all.empty() ? "" : " or ", each);
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  return all;
}

/// The one known word that begins with the word and an underscore: fov_deg for fov, though fog is
/// but a letter away.
std::string_view word_beginning(std::string_view word, std::span<const std::string_view> known) {
  std::string_view found;
  for (const std::string_view each : known) {
    if (!each.starts_with(word) || each.size() == word.size() || each[word.size()] != '_') continue;
    if (!found.empty()) return {};
    found = each;
  }
  return found;
}

}  // namespace

std::string Problems::hint_at(std::string_view word, std::span<const std::string_view> known,
                              std::string_view plural) const {
  constexpr std::size_t kMostNamed = 20;
  if (enough()) return "";  // to look for what was meant takes as long as all known words
  if (const std::string_view meant = word_beginning(word, known); !meant.empty())
    return fmt::format("did you mean '{}'?", meant);
  if (const auto meant = nearest_of(word, {known.begin(), known.end()}))
    return fmt::format("did you mean '{}'?", *meant);
  if (const std::string meant = words_with_part(word, known); !meant.empty())
    return fmt::format("did you mean {}?", meant);
  if (known.empty()) return fmt::format("there are no {}", plural);
  return fmt::format("{}: {}{}", plural,
                     fmt::join(known.first(std::min(known.size(), kMostNamed)), ", "),
                     known.size() > kMostNamed ? ", …" : "");
}

void Problems::unknown(std::size_t position, std::string message, std::string_view word,
                       std::span<const std::string_view> known, std::string_view plural) {
  error(position, std::move(message), hint_at(word, known, plural));
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
