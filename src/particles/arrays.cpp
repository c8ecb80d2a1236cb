// SPDX-License-Identifier: Apache-2.0
#include "particles/arrays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>

#include "core/in_parallel.hpp"
#include "particles/elements.hpp"
#include "particles/rows.hpp"

namespace zraka {
namespace {

template <class T>
double number_at(const char* at, bool swapped) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, at, sizeof(T));
  if (swapped) std::reverse(bytes, bytes + sizeof(T));
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return static_cast<double>(value);
}

double half_at(const char* at, bool swapped) {
  const auto bits = static_cast<unsigned>(number_at<std::uint16_t>(at, swapped));
  const int exponent = static_cast<int>(bits >> 10 & 31);
  const double fraction = bits & 1023;
  const double size = exponent == 31  ? (fraction == 0 ? HUGE_VAL : std::nan(""))
                      : exponent == 0 ? std::ldexp(fraction, -24)
                                      : std::ldexp(fraction + 1024, exponent - 25);
  return (bits & 0x8000) != 0 ? -size : size;
}

/// What NumPy's type of a character and a size is read by; nullptr for what is no number.
using NumberAt = double (*)(const char* at, bool swapped);
NumberAt reader_of(char type, std::size_t size) {
  if (type == 'f')
    return size == 4   ? number_at<float>
           : size == 8 ? number_at<double>
           : size == 2 ? half_at
                       : nullptr;
  const bool is_signed = type == 'i';
  if (!is_signed && type != 'u' && !(type == 'b' && size == 1)) return nullptr;
  switch (size) {
    case 1:
      return is_signed ? number_at<std::int8_t> : number_at<std::uint8_t>;
    case 2:
      return is_signed ? number_at<std::int16_t> : number_at<std::uint16_t>;
    case 4:
      return is_signed ? number_at<std::int32_t> : number_at<std::uint32_t>;
    case 8:
      return is_signed ? number_at<std::int64_t> : number_at<std::uint64_t>;
    default:
      return nullptr;
  }
}

/// Rows that are read at once: what is in no column stays as it is.
class ColumnReader {
 public:
  explicit ColumnReader(const ArrayColumn& column)
      : column_(column), read_(reader_of(column.type, column.size)) {}
  double operator()(std::size_t row) const {
    const char* const at = column_.data + row * column_.stride;
    if (column_.type == 'f' && column_.size == 4 && !column_.swapped) {
      float value;
      std::memcpy(&value, at, sizeof(value));
      return static_cast<double>(value);
    }
    return read_(at, column_.swapped);
  }

 private:
  const ArrayColumn& column_;
  NumberAt read_;
};

bool is_atomic_number(std::string_view name) {
  return name == "numbers" || name == "atomic_numbers" || name == "atnums";
}

/// Types as whole numbers become species.
class SpeciesReader {
 public:
  SpeciesReader(const ArrayColumn& column, std::size_t rows) : number_(column) {
    const bool atomic_numbers = is_atomic_number(column.name);
    for (std::size_t i = 0; i < rows && indices_.size() <= kMostSpecies; ++i) {
      const double number = number_(i);
      if (last_ == number && i > 0) continue;
      last_ = number;
      if (!indices_.try_emplace(number, static_cast<std::uint32_t>(indices_.size())).second)
        continue;
      const Element* const element = atomic_numbers && number >= 0 && number < 200
                                         ? element_of_number(static_cast<unsigned>(number))
                                         : nullptr;
      names.push_back(element != nullptr ? std::string(element->symbol)
                                         : fmt::format("type {}", number));
    }
  }
  std::uint32_t operator()(std::size_t row) const { return indices_.find(number_(row))->second; }
  std::vector<std::string> names;

 private:
  struct Less {  // NaN has its place, too
    bool operator()(double a, double b) const {
      return std::bit_cast<std::uint64_t>(a) < std::bit_cast<std::uint64_t>(b);
    }
  };
  ColumnReader number_;
  double last_ = 0;
  std::map<double, std::uint32_t, Less> indices_;
};

}  // namespace

Result<Particles> particles_of(const std::vector<ArrayColumn>& columns, std::size_t rows,
                               const std::string& file, const ParticleOptions& options) {
  if (rows == 0) return failure(file, "there are no particles in it");
  if (rows > kMostParticles)
    return failure(file, fmt::format("there are more than {} particles", kMostParticles));
  if (options.frame > 1) return failure(file, "an array has one frame only");
  RowLayout layout;
  for (const ArrayColumn& column : columns) {
    const bool numbers = is_atomic_number(column.name);
    layout.add(numbers && !layout.has(RowField::species) ? "species" : column.name, options);
    layout.columns.back().name = column.name;
  }
  if (const std::string problem = layout.problem(options); !problem.empty())
    return failure(file, problem);
  const auto column_of = [&](RowField field) -> const ArrayColumn* {
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (layout.columns[i].field == field) return &columns[i];
    return nullptr;
  };

  Particles particles;
  const ArrayColumn* const species = column_of(RowField::species);
  std::optional<SpeciesReader> species_of;
  if (species != nullptr) species_of.emplace(*species, rows);
  if (species_of && species_of->names.size() > kMostSpecies)
    return failure(file, fmt::format("there are more than {} kinds of particles in '{}'",
                                     kMostSpecies, species->name));
  particles.species = species_of ? species_of->names : std::vector<std::string>{""};

  const ColumnReader x(*column_of(RowField::x)), y(*column_of(RowField::y)),
      z(*column_of(RowField::z));
  const ArrayColumn* size = column_of(RowField::radius);
  double size_factor = 1;
  if (const ArrayColumn* const diameter = column_of(RowField::diameter);
      size == nullptr && diameter != nullptr) {
    size = diameter;
    size_factor = 0.5;
  }
  const ColumnReader radius_at(size != nullptr ? *size : *column_of(RowField::x));
  constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);
  std::atomic<std::size_t> wrong = kNowhere;  // the first particle that is
  const auto note_wrong = [&wrong](std::size_t i) {
    for (std::size_t first = wrong; i < first;)
      if (wrong.compare_exchange_weak(first, i)) break;
  };
  particles.spheres.resize(rows);
  in_parallel(rows, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i != end; ++i) {
      Object<Sphere>& object = particles.spheres[i];
      const Vec3 p{x(i), y(i), z(i)};
      const double radius = size != nullptr ? radius_at(i) * size_factor : 0;
      object = {{p, radius}, species_of ? (*species_of)(i) : 0};
      constexpr double kFarthest = 1e100;
      const bool good = std::fabs(p.x) <= kFarthest && std::fabs(p.y) <= kFarthest &&
                        std::fabs(p.z) <= kFarthest &&
                        (size == nullptr || (radius > 0 && radius <= kFarthest));
      if (!good) note_wrong(i);
    }
  });
  if (wrong != kNowhere) {
    const Sphere& sphere = particles.spheres[wrong].shape;
    return failure(
        file, fmt::format("particle {} is at ({}, {}, {}){}: expected finite numbers{}", wrong + 1,
                          sphere.center.x, sphere.center.y, sphere.center.z,
                          size != nullptr ? fmt::format(" with radius {}", sphere.radius) : "",
                          size != nullptr ? " and a radius greater than 0" : ""));
  }

  const ArrayColumn* const rgb[] = {column_of(RowField::red), column_of(RowField::green),
                                    column_of(RowField::blue)};
  if (rgb[0] != nullptr && rgb[1] != nullptr && rgb[2] != nullptr) {
    particles.colors.resize(rows);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const ColumnReader read(*rgb[channel]);
      in_parallel(rows, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i != end; ++i) {
          const double value = read(i);
          if (is_color(value))
            particles.colors[i][channel] = stored_color(value);
          else
            note_wrong(i);
        }
      });
    }
    if (wrong != kNowhere)
      return failure(file, fmt::format("particle {} has the colour ({}, {}, {}): expected 0 to 1, "
                                       "or 0 to 255",
                                       wrong + 1, ColumnReader(*rgb[0])(wrong),
                                       ColumnReader(*rgb[1])(wrong), ColumnReader(*rgb[2])(wrong)));
  }
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (!options.column.empty() && columns[i].name == options.column) {
      const ColumnReader read(columns[i]);
      particles.values.resize(rows);
      for (std::size_t row = 0; row < rows; ++row)
        particles.values[row] = static_cast<float>(read(row));
    }
  particles.in_angstrom = species != nullptr && is_atomic_number(species->name);
  return particles;
}

}  // namespace zraka
