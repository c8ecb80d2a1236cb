// SPDX-License-Identifier: Apache-2.0
// Reader of XYZ and extended XYZ: a count, a line for people or of keys, then a line for each atom.
#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "particles/elements.hpp"
#include "particles/rows.hpp"

namespace zraka {
namespace {

/// The value of a key in the second line of extended XYZ: a word, or what is in quotes or braces.
std::optional<std::string_view> attribute_of(std::string_view line, std::string_view key) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  const auto is_key = [&](std::size_t at) {
    if (at > 0 && line[at - 1] != ' ' && line[at - 1] != '\t') return false;
    for (std::size_t i = 0; i < key.size(); ++i)
      if (lower(line[at + i]) != key[i]) return false;
    return line[at + key.size()] == '=';
  };
  for (std::size_t at = 0; at + key.size() < line.size(); ++at) {
    if (!is_key(at)) continue;
    std::string_view value = line.substr(at + key.size() + 1);
    constexpr std::string_view kOpening = "\"'{[", kClosing = "\"'}]";
    const std::size_t bracket = value.empty() ? kOpening.npos : kOpening.find(value.front());
    if (bracket == kOpening.npos) return value.substr(0, value.find_first_of(" \t"));
    value.remove_prefix(1);
    return value.substr(0, value.find(kClosing[bracket]));
  }
  return std::nullopt;
}

class XyzReader {
 public:
  XyzReader(std::string_view text, const std::string& name, const ParticleOptions& options)
      : at_(text.data()), end_(at_ + text.size()), options_(options), problems_(text, name) {}

  Result<Particles> read() {
    if (!skip_frames() || !read_frame()) return problems_.failure();
    while (at_ != end_ && trimmed(line_at(at_, end_)).empty()) at_ = after_lines(at_, end_, 1);
    particles_.has_more = at_ != end_;
    name_elements();
    return std::move(particles_);
  }

 private:
  bool fail(const char* at, std::string message, std::string hint = {}) {
    problems_.add(at, std::move(message), std::move(hint));
    return false;
  }

  bool read_count(std::uint64_t& count) {
    while (at_ != end_ && trimmed(line_at(at_, end_)).empty()) at_ = after_lines(at_, end_, 1);
    const std::string_view line = line_at(at_, end_), word = trimmed(line);
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), count);
    if (error != std::errc() || stop != word.data() + word.size() || count > kMostParticles)
      return fail(word.empty() ? at_ : word.data(),
                  fmt::format("'{}' is no number of atoms: expected a whole number up to {}",
                              shown(word), kMostParticles),
                  "XYZ begins with the number of atoms, alone on its line");
    // A line of an atom has an end and at least seven characters more.
    if (count > 1 && count > static_cast<std::uint64_t>(end_ - at_) / 4)
      return fail(word.data(), fmt::format("there cannot be {} atoms in the {} bytes that follow",
                                           count, end_ - behind_line(line, end_)));
    at_ = behind_line(line, end_);
    return true;
  }

  bool skip_frames() {
    for (std::int64_t frame = 1; frame < options_.frame; ++frame) {
      std::uint64_t count = 0;
      if (!read_count(count)) return false;
      const char* const next = after_lines(at_, end_, count + 1);
      const bool last =
          next == nullptr || trimmed({next, static_cast<std::size_t>(end_ - next)}).empty();
      if (last)
        return fail(at_,
                    fmt::format("there is no frame {}: the last one is {}", options_.frame, frame));
      at_ = next;
    }
    return true;
  }

  bool read_frame() {
    std::uint64_t count = 0;
    const char* const counted = at_;
    if (!read_count(count)) return false;
    if (count == 0) return fail(counted, "there are no atoms");
    if (at_ == end_) return fail(end_, "the file ends before its second line, which is a comment");
    const std::string_view comment = line_at(at_, end_);
    at_ = behind_line(comment, end_);
    if (!read_lattice(comment) || !lay_out(comment)) return false;
    at_ = read_rows(at_, end_, count, layout_, particles_, problems_);
    return !problems_.any();
  }

  bool read_lattice(std::string_view comment) {
    const std::optional<std::string_view> text = attribute_of(comment, "lattice");
    if (!text) return true;
    double numbers[9];
    Words words(*text);
    for (double& number : numbers) {
      std::string_view word = words.next();
      if (!word.empty() && word.back() == ',') word.remove_suffix(1);
      const std::optional<double> value = parse_number(word);
      if (!value || !std::isfinite(*value))
        return fail(text->data(),
                    fmt::format("Lattice is '{}': expected nine numbers", shown(*text)));
      number = *value;
    }
    particles_.cell = ParticleCell{{},
                                   {numbers[0], numbers[1], numbers[2]},
                                   {numbers[3], numbers[4], numbers[5]},
                                   {numbers[6], numbers[7], numbers[8]}};
    return true;
  }

  bool lay_out(std::string_view comment) {
    const std::optional<std::string_view> properties = attribute_of(comment, "properties");
    if (properties) {
      if (!lay_out_properties(*properties)) return false;
    } else {
      layout_.columns = {{RowField::species, "element"},
                         {RowField::x, "x"},
                         {RowField::y, "y"},
                         {RowField::z, "z"}};
      Words words(line_at(at_, end_));
      for (int i = 0; i < 4; ++i) words.next();
      for (int i = 5; !words.next().empty() && i < 100; ++i)
        if (fmt::format("column_{}", i) == options_.column) {
          layout_.columns.resize(static_cast<std::size_t>(i), {RowField::skip, ""});
          layout_.columns.back() = {RowField::value, options_.column};
        }
      for (const RowColumn& column : layout_.columns)
        if (column.name == options_.column && column.field != RowField::species)
          layout_.value_from = column.field;
    }
    if (const std::string problem = layout_.problem(options_); !problem.empty())
      return fail(comment.data(), "the frame " + problem);
    while (layout_.columns.back().field == RowField::skip) layout_.columns.pop_back();
    return true;
  }

  /// name:type:count, again and again.
  bool lay_out_properties(std::string_view text) {
    constexpr std::string_view kAxes[] = {"_x", "_y", "_z"};
    const char* const begin = text.data();
    const auto next = [&] {
      const std::size_t end = std::min(text.find(':'), text.size());
      const std::string_view part = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      return part;
    };
    while (!text.empty()) {
      const std::string_view name = next(), type = next(), digits = next();
      unsigned count = 0;
      const auto [stop, error] =
          std::from_chars(digits.data(), digits.data() + digits.size(), count);
      if (type.size() != 1 || error != std::errc() || stop != digits.data() + digits.size() ||
          count < 1 || count > 1000 || layout_.columns.size() > 10000)
        return fail(begin, fmt::format("Properties has '{}:{}:{}': expected name:type:count, the "
                                       "type S, R, I or L",
                                       shown(name), shown(type), shown(digits)));
      const bool position =
          name == "pos" || name == "Pos" || name == "position" || name == "positions";
      for (unsigned i = 0; i < count; ++i) {
        std::string column(name);
        if (count == 3)
          column = (position ? "" : column) + std::string(kAxes[i]).substr(position ? 1 : 0);
        else if (count > 1)
          column += fmt::format("_{}", i + 1);
        layout_.add(column, options_);
        RowColumn& added = layout_.columns.back();
        if ((type == "S" || type == "L") != (added.field == RowField::species) && type != "I")
          added.field = RowField::skip;
      }
    }
    return true;
  }

  /// In the place of an element some write its atomic number.
  void name_elements() {
    for (std::string& species : particles_.species)
      if (const auto number = parse_number(species))
        if (const Element* const element = *number >= 0 && *number < 200
                                               ? element_of_number(static_cast<unsigned>(*number))
                                               : nullptr)
          species = element->symbol;
    particles_.in_angstrom = true;
  }

  const char *at_, *end_;
  const ParticleOptions& options_;
  TextProblems problems_;
  RowLayout layout_;
  Particles particles_;
};

}  // namespace

Result<Particles> parse_xyz(std::string_view text, const std::string& name,
                            const ParticleOptions& options) {
  return XyzReader(text, name, options).read();
}

bool is_xyz(std::string_view text) {
  const std::string_view count = trimmed(text.substr(0, text.find('\n')));
  if (count.empty() || count.size() > 20 ||
      count.find_first_not_of("0123456789") != std::string_view::npos)
    return false;
  const char* const end = text.data() + text.size();
  const char* const third = after_lines(text.data(), end, 2);
  if (third == nullptr) return false;
  const char* const second = after_lines(text.data(), end, 1);
  if (attribute_of(line_at(second, end), "properties")) return true;
  Words words(line_at(third, end));
  const std::string_view label = words.next();
  if (label.empty() || label.size() > 12) return false;
  if (element_of_symbol(label) != nullptr) return true;
  for (int i = 0; i < 3; ++i)
    if (!parse_number(words.next())) return false;
  return true;
}

}  // namespace zraka
