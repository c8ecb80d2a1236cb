// SPDX-License-Identifier: Apache-2.0
// Rows of text that are a particle each, read by all threads.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/text.hpp"
#include "particles/particles.hpp"

namespace zraka {

/// What a column of a row says.
enum class RowField : std::uint8_t {
  skip,
  x,
  y,
  z,
  radius,
  diameter,
  species,
  red,
  green,
  blue,
  value,
  shape_x,  ///< diameters of an ellipsoid
  shape_y,
  shape_z,
  turn_w,
  turn_x,
  turn_y,
  turn_z
};

struct RowColumn {
  RowField field = RowField::skip;
  std::string name;  ///< as people know it: "x", "c_pe"
};

struct RowLayout {
  std::vector<RowColumn> columns;        ///< what stands behind them in a row does not matter
  char separator = ' ';                  ///< ' ': any spaces and tabs
  std::string species_prefix;            ///< before a species that is a number: "type "
  RowField value_from = RowField::skip;  ///< the numbers asked for, if they are of another field

  bool has(RowField field) const;
  /// Appends a column of numbers or words by its name in the file, which tells its field.
  void add(std::string_view name, const ParticleOptions& options);
  /// "" if rows have positions, all of a colour, and the numbers asked for; else what is missing.
  std::string problem(const ParticleOptions& options) const;
};

/// Problems of a text with their places, as many as anybody reads.
class TextProblems {
 public:
  TextProblems(std::string_view text, const std::string& name) : text_(text), name_(name) {}
  /// `at` is in the text.
  void add(const char* at, std::string message, std::string hint = {});
  bool any() const { return !problems_.empty(); }
  bool enough() const { return problems_.size() >= kEnough; }
  tl::unexpected<Diagnostics> failure() { return tl::make_unexpected(std::move(problems_)); }
  static constexpr std::size_t kEnough = 20;

 private:
  std::string_view text_;
  const std::string& name_;
  TextPositions places_{text_};
  Diagnostics problems_;
};

/// Reads `count` lines from `begin` on, each a particle. Where they are read or something is wrong,
/// returns the begin of the line behind them; the problems are told.
const char* read_rows(const char* begin, const char* end, std::uint64_t count,
                      const RowLayout& layout, Particles& particles, TextProblems& problems);

/// The begin of the line after so many, or nullptr if the text ends before.
const char* after_lines(const char* begin, const char* end, std::uint64_t count);
/// How many lines there are; the last one need not end.
std::uint64_t count_lines(const char* begin, const char* end);

/// Words of a line, one after the other.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}
  /// "" where there are no more.
  std::string_view next();
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

/// The line that begins there, without its end.
std::string_view line_at(const char* begin, const char* end);
/// The begin of the next line.
inline const char* behind_line(std::string_view line, const char* end) {
  const char* at = line.data() + line.size();
  while (at != end && *at != '\n') ++at;
  return at == end ? end : at + 1;
}

}  // namespace zraka
