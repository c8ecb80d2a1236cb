// SPDX-License-Identifier: Apache-2.0
// Reader of the text dumps of LAMMPS: sections that begin with ITEM, a time step after the other.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/in_parallel.hpp"
#include "particles/rows.hpp"

namespace zraka {
namespace {

class LammpsReader {
 public:
  LammpsReader(std::string_view text, const std::string& name, const ParticleOptions& options)
      : begin_(text.data()),
        at_(begin_),
        end_(at_ + text.size()),
        options_(options),
        problems_(text, name) {}

  Result<Particles> read() {
    std::int64_t frames = 0;
    while (at_ != end_ && !problems_.any()) {
      const std::string_view line = line_at(at_, end_);
      if (line.starts_with("ITEM: NUMBER OF ATOMS")) {
        read_count(line);
      } else if (line.starts_with("ITEM: BOX BOUNDS")) {
        read_box(line);
      } else if (line.starts_with("ITEM: ATOMS") || line.starts_with("ITEM: ENTRIES")) {
        if (frames == options_.frame) {
          particles_.has_more = true;
          break;
        }
        ++frames;
        read_atoms(line, frames == options_.frame);
      } else {
        at_ = behind_line(line, end_);
      }
    }
    if (!problems_.any() && frames < options_.frame)
      fail(begin_, frames == 0 ? "has no atoms: there is no ITEM: ATOMS"
                               : fmt::format("there is no frame {}: the last one is {}",
                                             options_.frame, frames));
    if (problems_.any()) return problems_.failure();
    return std::move(particles_);
  }

 private:
  bool fail(const char* at, std::string message) {
    problems_.add(at, std::move(message));
    return false;
  }

  bool read_count(std::string_view header) {
    at_ = behind_line(header, end_);
    const std::string_view line = line_at(at_, end_), word = trimmed(line);
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), count_);
    if (error != std::errc() || stop != word.data() + word.size() || count_ > kMostParticles)
      return fail(at_, fmt::format("'{}' is no number of atoms: expected a whole number up to {}",
                                   shown(word), kMostParticles));
    at_ = behind_line(line, end_);
    if (count_ > static_cast<std::uint64_t>(end_ - at_))
      return fail(line.data(), fmt::format("there cannot be {} atoms in the {} bytes that follow",
                                           count_, end_ - at_));
    return true;
  }

  /// Three lines of numbers: where the box begins and ends, and how it leans; or, of the general
  /// kind, its edges and its corner.
  bool read_box(std::string_view header) {
    const bool general = header.find("abc") != std::string_view::npos;
    const bool leans = header.find("xy") != std::string_view::npos;
    double rows[3][4] = {};
    at_ = behind_line(header, end_);
    for (auto& row : rows) {
      const std::string_view line = line_at(at_, end_);
      Words words(line);
      for (int i = 0; i < (general ? 4 : leans ? 3 : 2); ++i) {
        const std::string_view word = words.next();
        const std::optional<double> number = parse_number(word);
        if (!number || !(std::fabs(*number) <= 1e100))
          return fail(
              word.empty() ? line.data() : word.data(),
              fmt::format("'{}' is not a finite number: expected one of the box", shown(word)));
        row[i] = *number;
      }
      at_ = behind_line(line, end_);
    }
    if (general) {
      const auto edge = [](const double* row) { return Vec3{row[0], row[1], row[2]}; };
      particles_.cell = ParticleCell{
          {rows[0][3], rows[1][3], rows[2][3]}, edge(rows[0]), edge(rows[1]), edge(rows[2])};
      return true;
    }
    // The bounds are those of the box that leans, so that its own are inside of them.
    const double xy = rows[0][2], xz = rows[1][2], yz = rows[2][2];
    const Vec3 low{rows[0][0] - std::min({0.0, xy, xz, xy + xz}), rows[1][0] - std::min(0.0, yz),
                   rows[2][0]};
    const Vec3 high{rows[0][1] - std::max({0.0, xy, xz, xy + xz}), rows[1][1] - std::max(0.0, yz),
                    rows[2][1]};
    particles_.cell = ParticleCell{
        low, {high.x - low.x, 0, 0}, {xy, high.y - low.y, 0}, {xz, yz, high.z - low.z}};
    return true;
  }

  bool read_atoms(std::string_view header, bool wanted) {
    at_ = behind_line(header, end_);
    if (count_ == 0 && wanted)
      return fail(header.data(), "there are no atoms, or no ITEM: NUMBER OF ATOMS before them");
    if (!wanted) {
      const char* const next = after_lines(at_, end_, count_);
      if (next == nullptr) return fail(at_, fmt::format("the file ends before {} atoms", count_));
      at_ = next;
      return true;
    }
    if (!lay_out(header)) return false;
    at_ = read_rows(at_, end_, count_, layout_, particles_, problems_);
    if (problems_.any()) return false;
    if (in_box_) move_out_of_box();
    return true;
  }

  bool lay_out(std::string_view header) {
    std::vector<std::string_view> names;
    Words words(header);
    words.next();
    words.next();
    constexpr std::size_t kMostColumns = 10000;
    for (std::string_view name = words.next(); !name.empty(); name = words.next()) {
      if (names.size() == kMostColumns)
        return fail(name.data(), fmt::format("there are more than {} columns", kMostColumns));
      names.push_back(name);
    }
    const auto has = [&](std::string_view name) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    // Of old dumps, which do not say it.
    if (names.empty()) names = {"id", "type", "xs", "ys", "zs"};
    in_box_ = !has("x") && !has("xu") && (has("xs") || has("xsu"));
    if (in_box_ && !particles_.cell)
      return fail(header.data(),
                  "positions are parts of the box, and there is no ITEM: BOX BOUNDS");
    layout_ = {};
    layout_.species_prefix = "type ";
    particles_.in_angstrom = has("element");
    for (const std::string_view name : names) {
      std::string_view called = name;
      constexpr std::string_view kScaled[] = {"xs", "ys", "zs", "xsu", "ysu", "zsu"};
      constexpr std::string_view kPlain[] = {"x", "y", "z"};
      for (std::size_t i = 0; i < 6 && in_box_; ++i)
        if (name == kScaled[i]) called = kPlain[i % 3];
      if ((name == "type" || name == "name") && has("element"))
        layout_.columns.push_back(
            {name == options_.column ? RowField::value : RowField::skip, std::string(name)});
      else
        layout_.add(called, options_);
    }
    if (const std::string problem = layout_.problem(options_); !problem.empty())
      return fail(header.data(), "ITEM: ATOMS " + problem);
    if (!(layout_.has(RowField::shape_y) && layout_.has(RowField::shape_z)))
      for (RowColumn& column : layout_.columns)
        if (column.field == RowField::shape_x) column.field = RowField::skip;
    while (layout_.columns.back().field == RowField::skip) layout_.columns.pop_back();
    return true;
  }

  void move_out_of_box() {
    const auto& [origin, a, b, c] = *particles_.cell;
    in_parallel(particles_.spheres.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i != end; ++i) {
        Vec3& p = particles_.spheres[i].shape.center;
        p = {origin.x + p.x * a.x + p.y * b.x + p.z * c.x,
             origin.y + p.x * a.y + p.y * b.y + p.z * c.y,
             origin.z + p.x * a.z + p.y * b.z + p.z * c.z};
      }
    });
  }

  const char *begin_, *at_, *end_;
  const ParticleOptions& options_;
  TextProblems problems_;
  RowLayout layout_;
  Particles particles_;
  std::uint64_t count_ = 0;
  bool in_box_ = false;
};

}  // namespace

bool is_lammps(std::string_view text) {
  return text.starts_with("ITEM: ");
}

Result<Particles> parse_lammps(std::string_view text, const std::string& name,
                               const ParticleOptions& options) {
  return LammpsReader(text, name, options).read();
}

}  // namespace zraka
