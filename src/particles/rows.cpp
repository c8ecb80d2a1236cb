// SPDX-License-Identifier: Apache-2.0
#include "particles/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <unordered_map>

#include "core/in_parallel.hpp"
#include "core/text.hpp"

namespace zraka {
namespace {

constexpr std::size_t kRowsOfBlock = 8192;

/// The numbers of a row by their fields.
using Numbers = std::array<double, static_cast<std::size_t>(RowField::turn_z) + 1>;
double& at(Numbers& numbers, RowField field) {
  return numbers[static_cast<std::size_t>(field)];
}

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

std::string too_many_species() {
  return fmt::format(
      "there are more than {} kinds of particles: is this column their element or "
      "type?",
      kMostSpecies);
}

struct RowProblem {
  const char* at;
  std::string message;
};

/// Rows that one thread reads.
class RowBlock {
 public:
  RowBlock(const RowLayout& layout, Particles& particles)
      : layout_(layout),
        to_(particles),
        has_diameter_(layout.has(RowField::diameter)),
        has_radius_(has_diameter_ || layout.has(RowField::radius)) {}

  void read(const char* begin, const char* end, std::size_t first, std::size_t count) {
    at_ = begin;
    for (std::size_t row = first; row != first + count && problems_.size() < TextProblems::kEnough;
         ++row) {
      line_ = at_;
      const void* const found = std::memchr(at_, '\n', static_cast<std::size_t>(end - at_));
      line_end_ = found != nullptr ? static_cast<const char*>(found) : end;
      if (read_row()) put(row);
      at_ = std::min(line_end_ + 1, end);
    }
  }

  const std::vector<std::string>& species() const { return species_; }
  std::vector<RowProblem>& problems() { return problems_; }

 private:
  bool fail(const char* at, std::string message) {
    problems_.push_back({at, std::move(message)});
    return false;
  }

  void skip_blanks() {
    while (at_ != line_end_ && is_blank(*at_) && !(*at_ == '\t' && layout_.separator == '\t'))
      ++at_;
  }

  /// The text of a column, without blanks and quotes around it; the end of the line may be one of
  /// columns that are separated.
  std::string_view take_text() {
    skip_blanks();
    if (layout_.separator == ' ') {
      const char* const begin = at_;
      while (at_ != line_end_ && !is_blank(*at_)) ++at_;
      return {begin, static_cast<std::size_t>(at_ - begin)};
    }
    if (at_ != line_end_ && *at_ == '"') {
      const char* const begin = ++at_;
      at_ = std::find(at_, line_end_, '"');
      const std::string_view text(begin, static_cast<std::size_t>(at_ - begin));
      at_ = std::find(at_, line_end_, layout_.separator);
      return text;
    }
    const char* const begin = at_;
    at_ = std::find(at_, line_end_, layout_.separator);
    return trimmed({begin, static_cast<std::size_t>(at_ - begin)});
  }

  bool read_number_of(const RowColumn& column) {
    const char* const begin = at_;
    double& value = at(numbers_, column.field);
    const char* const stop = read_number(at_, line_end_, value);
    if (stop != nullptr && std::isfinite(value) &&
        (stop == line_end_ || is_blank(*stop) || *stop == layout_.separator)) {
      at_ = stop;
      return true;
    }
    const std::string_view text = take_text();
    const std::optional<double> number = parse_number(text);
    if (number && std::isfinite(*number)) {
      value = *number;
      return true;
    }
    if (text.empty()) return fail(begin, fmt::format("has nothing for {}", column.name));
    return fail(text.data(),
                fmt::format("'{}' is not a finite number: expected {}", shown(text), column.name));
  }

  bool read_row() {
    for (std::size_t i = 0; i < layout_.columns.size(); ++i) {
      const RowColumn& column = layout_.columns[i];
      skip_blanks();
      if (i > 0 && layout_.separator != ' ' && at_ != line_end_) {
        ++at_;  // a separator, for whatever was before it ended there
        skip_blanks();
      } else if (at_ == line_end_) {
        return fail(at_, i == 0 ? "the line is empty: expected a particle"
                                : fmt::format("the line ends: expected {}", column.name));
      }
      if (column.field == RowField::skip) {
        take_text();
      } else if (column.field == RowField::species) {
        const std::string_view text = take_text();
        if (text.empty()) return fail(at_, fmt::format("has nothing for {}", column.name));
        if (!find_species(text)) return false;
      } else if (!read_number_of(column)) {
        return false;
      }
      skip_blanks();
      if (layout_.separator != ' ' && at_ != line_end_ && *at_ != layout_.separator)
        return fail(
            at_, fmt::format("'{}' does not belong behind {}",
                             shown({at_, static_cast<std::size_t>(line_end_ - at_)}), column.name));
    }
    return true;
  }

  bool find_species(std::string_view text) {
    if (species_index_ < species_.size() && species_[species_index_] == text) return true;
    if (text.size() > 64)
      return fail(text.data(), fmt::format("'{}' is no name of an element or a type: expected at "
                                           "most 64 characters",
                                           shown(text)));
    const auto found = indices_.find(std::string(text));
    if (found != indices_.end()) {
      species_index_ = found->second;
      return true;
    }
    if (species_.size() == kMostSpecies) return fail(text.data(), too_many_species());
    species_index_ = static_cast<std::uint32_t>(species_.size());
    species_.emplace_back(text);
    indices_.emplace(species_.back(), species_index_);
    return true;
  }

  void put(std::size_t row) {
    double radius = at(numbers_, RowField::radius);
    if (has_diameter_) radius = at(numbers_, RowField::diameter) / 2;
    const Vec3 center{at(numbers_, RowField::x), at(numbers_, RowField::y),
                      at(numbers_, RowField::z)};
    if (!within_reach(center, radius)) return;
    to_.spheres[row] = {{center, radius}, species_index_};
    if (!to_.values.empty()) {
      const bool elsewhere = layout_.value_from != RowField::skip;
      to_.values[row] =
          static_cast<float>(at(numbers_, elsewhere ? layout_.value_from : RowField::value));
    }
    if (!to_.colors.empty()) put_color(row);
    if (!to_.shapes.empty()) put_shape(row);
  }

  bool within_reach(const Vec3& center, double radius) {
    constexpr double kFarthest = 1e100;  // as scene/check_shape.hpp has it
    if (!(std::max({std::fabs(center.x), std::fabs(center.y), std::fabs(center.z), radius}) <=
          kFarthest))
      return fail(line_, fmt::format("the particle is farther than {} from the origin", kFarthest));
    if (has_radius_ && !(radius > 0))
      return fail(line_, fmt::format("the particle's radius is {}: expected more than 0", radius));
    return true;
  }

  void put_color(std::size_t row) {
    constexpr RowField kChannels[] = {RowField::red, RowField::green, RowField::blue};
    for (std::size_t i = 0; i < 3; ++i) {
      const double value = at(numbers_, kChannels[i]);
      if (!is_color(value)) {
        fail(line_, fmt::format("a colour is {}: expected 0 to 1, or 0 to 255", value));
        return;
      }
      to_.colors[row][i] = stored_color(value);
    }
  }

  void put_shape(std::size_t row) {
    const auto number = [&](RowField field) { return static_cast<float>(at(numbers_, field)); };
    to_.shapes[row] = {{number(RowField::shape_x) / 2, number(RowField::shape_y) / 2,
                        number(RowField::shape_z) / 2},
                       {number(RowField::turn_w), number(RowField::turn_x),
                        number(RowField::turn_y), number(RowField::turn_z)}};
  }

  const RowLayout& layout_;
  Particles& to_;
  bool has_diameter_, has_radius_;
  const char *at_ = nullptr, *line_ = nullptr, *line_end_ = nullptr;
  Numbers numbers_{};
  std::vector<std::string> species_;
  std::unordered_map<std::string, std::uint32_t> indices_;
  std::uint32_t species_index_ = 0;
  std::vector<RowProblem> problems_;
};

/// The species of all blocks in the order in which they come, and each block's own as indices in
/// these.
class SpeciesTable {
 public:
  explicit SpeciesTable(std::vector<std::string>& all) : all_(all) {}
  std::vector<std::uint32_t> add(const std::vector<std::string>& of_block) {
    std::vector<std::uint32_t> indices;
    for (const std::string& name : of_block) {
      const auto [entry, fresh] = known_.try_emplace(name, static_cast<std::uint32_t>(all_.size()));
      if (fresh) all_.push_back(name);
      indices.push_back(entry->second);
    }
    return indices;
  }

 private:
  std::vector<std::string>& all_;
  std::unordered_map<std::string, std::uint32_t> known_;
};

}  // namespace

void TextProblems::add(const char* at, std::string message, std::string hint) {
  if (enough()) return;
  const auto position = static_cast<std::size_t>(at - text_.data());
  const TextPosition place = places_.at(position);
  problems_.push_back({Severity::error, name_, place.line, place.column, std::move(message),
                       std::move(hint), places_.excerpt(position)});
}

const char* read_rows(const char* begin, const char* end, std::uint64_t count,
                      const RowLayout& layout, Particles& particles, TextProblems& problems) {
  // Where each block begins: then rows go to their places, whichever thread reads them.
  std::vector<const char*> starts;
  const char* at = begin;
  for (std::uint64_t row = 0; row < count; ++row) {
    if (row % kRowsOfBlock == 0) starts.push_back(at);
    if (at == end) {
      problems.add(end, fmt::format("the file ends after {} of {} particles", row, count));
      return end;
    }
    const void* const found = std::memchr(at, '\n', static_cast<std::size_t>(end - at));
    at = found != nullptr ? static_cast<const char*>(found) + 1 : end;
  }
  const char* const behind = at;

  const auto rows = static_cast<std::size_t>(count);
  particles.spheres.resize(rows);
  if (layout.has(RowField::value) || layout.value_from != RowField::skip)
    particles.values.resize(rows);
  if (layout.has(RowField::red)) particles.colors.resize(rows);
  if (layout.has(RowField::shape_x)) particles.shapes.resize(rows);
  std::vector<RowBlock> blocks(starts.size(), RowBlock(layout, particles));
  const auto rows_of = [&](std::size_t block) {
    return std::min(kRowsOfBlock, rows - block * kRowsOfBlock);
  };
  in_parallel(
      blocks.size(),
      [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
          blocks[i].read(starts[i], behind, i * kRowsOfBlock, rows_of(i));
      },
      1);

  for (RowBlock& block : blocks)
    for (RowProblem& problem : block.problems())
      problems.add(problem.at, std::move(problem.message));
  if (problems.any()) return behind;

  if (!layout.has(RowField::species)) {
    particles.species = {""};
    return behind;
  }
  SpeciesTable table(particles.species);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const std::vector<std::uint32_t> indices = table.add(blocks[i].species());
    if (particles.species.size() > kMostSpecies) {
      problems.add(starts[i], too_many_species());
      return behind;
    }
    for (std::size_t row = i * kRowsOfBlock; row < i * kRowsOfBlock + rows_of(i); ++row)
      particles.spheres[row].material = indices[particles.spheres[row].material];
  }
  if (!layout.species_prefix.empty())
    for (std::string& species : particles.species)
      if (parse_number(species)) species = layout.species_prefix + species;
  return behind;
}

const char* after_lines(const char* begin, const char* end, std::uint64_t count) {
  for (; count > 0; --count) {
    if (begin == end) return nullptr;
    const void* const found = std::memchr(begin, '\n', static_cast<std::size_t>(end - begin));
    begin = found != nullptr ? static_cast<const char*>(found) + 1 : end;
  }
  return begin;
}

std::uint64_t count_lines(const char* begin, const char* end) {
  const auto ends = static_cast<std::uint64_t>(std::count(begin, end, '\n'));
  return begin != end && end[-1] != '\n' ? ends + 1 : ends;
}

std::string_view Words::next() {
  while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
  std::size_t size = 0;
  while (size < rest_.size() && !is_blank(rest_[size])) ++size;
  const std::string_view word = rest_.substr(0, size);
  rest_.remove_prefix(size);
  return word;
}

std::string_view line_at(const char* begin, const char* end) {
  const void* const found =
      begin == end ? nullptr : std::memchr(begin, '\n', static_cast<std::size_t>(end - begin));
  const char* stop = found != nullptr ? static_cast<const char*>(found) : end;
  if (stop != begin && stop[-1] == '\r') --stop;
  return {begin, static_cast<std::size_t>(stop - begin)};
}

}  // namespace zraka
