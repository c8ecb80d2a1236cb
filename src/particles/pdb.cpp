// SPDX-License-Identifier: Apache-2.0
// Reader of PDB files, by the columns of "Atomic Coordinate Entry Format Description", version 3.3.
#include <fmt/format.h>

#include <cmath>
#include <unordered_map>

#include "particles/atoms.hpp"
#include "particles/rows.hpp"

namespace zraka {

std::optional<ParticleCell> cell_of(const std::array<double, 6>& numbers) {
  const auto [a, b, c, alpha, beta, gamma] = numbers;
  constexpr double kDegree = 3.14159265358979323846 / 180;
  const double ca = std::cos(alpha * kDegree), cb = std::cos(beta * kDegree),
               cg = std::cos(gamma * kDegree), sg = std::sin(gamma * kDegree);
  const double y = (ca - cb * cg) / sg, square = 1 - cb * cb - y * y;
  if (!(a > 0 && b > 0 && c > 0 && square > 0)) return std::nullopt;
  // Of entries without a crystal, which have a cell of 1 all the same.
  if (a <= 1 && b <= 1 && c <= 1) return std::nullopt;
  return ParticleCell{{}, {a, 0, 0}, {b * cg, b * sg, 0}, {c * cb, c * y, c * std::sqrt(square)}};
}

namespace {

constexpr std::string_view kColumns[] = {"b_factor", "occupancy", "residue", "chain",
                                         "x",        "y",         "z"};

class PdbReader {
 public:
  PdbReader(std::string_view text, const std::string& name, const ParticleOptions& options)
      : text_(text), options_(options), problems_(text, name), list_(particles_) {}

  Result<Particles> read() {
    const char *at = text_.data(), *const end = at + text_.size();
    if (!options_.column.empty() &&
        std::find(std::begin(kColumns), std::end(kColumns), options_.column) == std::end(kColumns))
      problems_.add(at, fmt::format("has no column '{}': there are {}", shown(options_.column),
                                    fmt::join(kColumns, ", ")));
    while (at != end && !problems_.enough()) {
      line_ = line_at(at, end);
      read_line();
      at = behind_line(line_, end);
    }
    if (problems_.any()) return problems_.failure();
    if (particles_.spheres.empty()) {
      if (options_.frame > 1)
        problems_.add(text_.data(), fmt::format("there is no model {}: there are {}",
                                                options_.frame, std::max(model_, 1)));
      else
        problems_.add(text_.data(), "has no atoms: no line begins with ATOM or HETATM");
      return problems_.failure();
    }
    particles_.in_angstrom = true;
    return std::move(particles_);
  }

 private:
  bool begins_with(std::string_view record) const { return line_.starts_with(record); }
  /// Columns count from 1, the last one included.
  std::string_view columns(std::size_t first, std::size_t last) const {
    if (line_.size() < first) return {};
    return trimmed(line_.substr(first - 1, last - first + 1));
  }

  bool fail(std::size_t column, std::string message) {
    problems_.add(line_.data() + std::min(column - 1, line_.size()), std::move(message));
    return false;
  }

  bool number(std::size_t first, std::size_t last, const char* what, double& value) {
    const std::string_view text = columns(first, last);
    const std::optional<double> read = parse_number(text);
    value = read.value_or(0);
    if (read && std::fabs(value) <= 1e100) return true;
    return fail(first, fmt::format("columns {} to {} are '{}': expected {}", first, last,
                                   shown(text), what));
  }

  void read_line() {
    if (begins_with("MODEL ")) {
      ++model_;
      if (model_ > options_.frame) particles_.has_more = true;
    } else if (begins_with("ATOM  ") || begins_with("HETATM")) {
      // What stands before the first MODEL is the first.
      if (std::max(model_, 1) == options_.frame) read_atom();
    } else if (begins_with("CONECT")) {
      read_bonds();
    } else if (begins_with("CRYST1")) {
      read_cell();
    }
  }

  bool read_atom() {
    Vec3 position;
    if (line_.size() < 54)
      return fail(line_.size() + 1, "the line ends: expected x, y and z in columns 31 to 54");
    if (!number(31, 38, "x, in ångström", position.x) ||
        !number(39, 46, "y, in ångström", position.y) ||
        !number(47, 54, "z, in ångström", position.z))
      return false;
    if (line_[16] != ' ' && !list_.is_first(line_.substr(17, 10), line_.substr(12, 4))) return true;
    serials_.emplace(columns(7, 11), static_cast<std::uint32_t>(particles_.spheres.size()));
    list_.add(element(), position);
    if (!options_.column.empty()) add_value(position);
    return true;
  }

  /// By columns 77 and 78; else by the atom's name, whose first column is the first letter of an
  /// element's symbol of two.
  std::string_view element() const {
    if (const Element* const named = element_of_symbol(columns(77, 78))) return named->symbol;
    const std::string_view name = line_.substr(12, 4);
    const bool is_hydrogen = name[0] == 'H' && name[3] != ' ';  // "HG21"
    if (name[0] != ' ' && !is_hydrogen)
      if (const Element* const two = element_of_symbol(name.substr(0, 2))) return two->symbol;
    const std::size_t letter =
        name.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz");
    if (letter == std::string_view::npos) return "?";
    const Element* const one = element_of_symbol(name.substr(letter, 1));
    return one != nullptr ? one->symbol : "?";
  }

  void add_value(const Vec3& position) {
    const std::string& column = options_.column;
    double value = 0;
    if (column == "b_factor") value = parse_number(columns(61, 66)).value_or(0);
    if (column == "occupancy") value = parse_number(columns(55, 60)).value_or(0);
    if (column == "x") value = position.x;
    if (column == "y") value = position.y;
    if (column == "z") value = position.z;
    if (column == "residue") value = parse_number(columns(23, 26)).value_or(0);
    if (column == "chain") value = static_cast<double>(list_.number_of(columns(22, 22)));
    particles_.values.push_back(static_cast<float>(value));
  }

  /// Serial numbers are words here: from 100 000 on they are written in base 36.
  void read_bonds() {
    const auto from = serials_.find(columns(7, 11));
    if (from == serials_.end()) return;
    for (std::size_t column = 12; column <= 27; column += 5) {
      const auto to = serials_.find(columns(column, column + 4));
      if (to != serials_.end() && from->second < to->second)
        particles_.bonds.push_back({from->second, to->second});
    }
  }

  void read_cell() {
    constexpr std::array<std::size_t, 7> kFirst = {7, 16, 25, 34, 41, 48, 55};
    std::array<double, 6> numbers;
    for (std::size_t i = 0; i < 6; ++i)
      numbers[i] = parse_number(columns(kFirst[i], kFirst[i + 1] - 1)).value_or(0);
    particles_.cell = cell_of(numbers);
  }

  std::string_view text_, line_;
  const ParticleOptions& options_;
  TextProblems problems_;
  Particles particles_;
  AtomList list_;
  int model_ = 0;
  std::unordered_map<std::string_view, std::uint32_t> serials_;
};

}  // namespace

bool is_pdb(std::string_view text) {
  constexpr std::string_view kRecords[] = {
      "HEADER    ", "TITLE     ", "COMPND    ", "REMARK ",    "CRYST1",     "ATOM  ",     "HETATM",
      "MODEL     ", "AUTHOR    ", "OBSLTE    ", "SPLIT     ", "CAVEAT    ", "EXPDTA    ", "JRNL  "};
  return std::any_of(std::begin(kRecords), std::end(kRecords),
                     [&](std::string_view record) { return text.starts_with(record); });
}

Result<Particles> parse_pdb(std::string_view text, const std::string& name,
                            const ParticleOptions& options) {
  return PdbReader(text, name, options).read();
}

}  // namespace zraka
