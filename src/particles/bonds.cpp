// SPDX-License-Identifier: Apache-2.0
#include "particles/bonds.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>

#include "core/in_parallel.hpp"

namespace zraka {
namespace {

constexpr double kTolerance = 0.45, kLeast = 0.4;
/// Of one cell: in a cube of 4 ångström matter has no more than thirty.
constexpr std::uint32_t kMostInCell = 500;

/// A cube of the grid. Cells are found by a hash, so that empty ones cost nothing.
struct CellIndex {
  std::int64_t x, y, z;
  friend bool operator==(const CellIndex&, const CellIndex&) = default;
};

std::uint64_t hash_of(const CellIndex& cell) {
  std::uint64_t hash = static_cast<std::uint64_t>(cell.x) * 0x9E3779B97F4A7C15u;
  hash = (hash ^ (hash >> 29)) + static_cast<std::uint64_t>(cell.y) * 0xBF58476D1CE4E5B9u;
  hash = (hash ^ (hash >> 31)) + static_cast<std::uint64_t>(cell.z) * 0x94D049BB133111EBu;
  hash ^= hash >> 30;
  return hash * 0x9E3779B97F4A7C15u >> 20;
}

class Grid {
 public:
  Grid(const std::vector<Object<Sphere>>& atoms, double side) : atoms_(atoms), side_(side) {
    mask_ = std::bit_ceil(std::max<std::uint64_t>(atoms.size(), 16)) - 1;
    starts_.assign(mask_ + 2, 0);
    for (const Object<Sphere>& atom : atoms) ++starts_[bucket(cell_of(atom)) + 1];
    fullest_ = *std::max_element(starts_.begin(), starts_.end());
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    members_.resize(atoms.size());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t i = 0; i < atoms.size(); ++i)
      members_[next[bucket(cell_of(atoms[i]))]++] = i;
  }

  std::uint32_t fullest() const { return fullest_; }

  CellIndex cell_of(const Object<Sphere>& atom) const {
    const auto along = [&](double x) {
      // Beyond that, what is rounded is larger than any bond.
      return static_cast<std::int64_t>(std::floor(std::clamp(x / side_, -1e15, 1e15)));
    };
    const Vec3& p = atom.shape.center;
    return {along(p.x), along(p.y), along(p.z)};
  }

  /// visit(index) for all atoms of a cell.
  template <class Visit>
  void for_each(const CellIndex& cell, const Visit& visit) const {
    const std::uint64_t b = bucket(cell);
    for (std::uint32_t at = starts_[b]; at != starts_[b + 1]; ++at)
      if (cell_of(atoms_[members_[at]]) == cell) visit(members_[at]);
  }

 private:
  std::uint64_t bucket(const CellIndex& cell) const { return hash_of(cell) & mask_; }

  const std::vector<Object<Sphere>>& atoms_;
  double side_;
  std::uint64_t mask_ = 0;
  std::vector<std::uint32_t> starts_, members_;
  std::uint32_t fullest_ = 0;
};

}  // namespace

std::optional<std::vector<std::array<std::uint32_t, 2>>> find_bonds(
    const std::vector<Object<Sphere>>& atoms, const std::vector<float>& covalent) {
  using Pairs = std::vector<std::array<std::uint32_t, 2>>;
  float largest = 0;
  for (const float radius : covalent) largest = std::max(largest, radius);
  if (largest == 0 || atoms.size() < 2) return Pairs{};
  const Grid grid(atoms, 2 * static_cast<double>(largest) + kTolerance);
  if (grid.fullest() > kMostInCell) return std::nullopt;

  const auto bonds_of = [&](std::uint32_t i, Pairs& pairs) {
    const Object<Sphere>& atom = atoms[i];
    const double own = static_cast<double>(covalent[atom.material]);
    if (own == 0) return;
    const std::size_t before = pairs.size();
    const CellIndex cell = grid.cell_of(atom);
    for (std::int64_t x = cell.x - 1; x <= cell.x + 1; ++x)
      for (std::int64_t y = cell.y - 1; y <= cell.y + 1; ++y)
        for (std::int64_t z = cell.z - 1; z <= cell.z + 1; ++z)
          grid.for_each({x, y, z}, [&](std::uint32_t j) {
            if (j <= i) return;
            const double other = static_cast<double>(covalent[atoms[j].material]);
            if (other == 0) return;
            const Vec3 &p = atom.shape.center, &q = atoms[j].shape.center;
            const double dx = p.x - q.x, dy = p.y - q.y, dz = p.z - q.z;
            const double square = dx * dx + dy * dy + dz * dz, most = own + other + kTolerance;
            if (square <= most * most && square >= kLeast * kLeast) pairs.push_back({i, j});
          });
    std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(before), pairs.end());
  };

  constexpr std::size_t kBlock = 16384;
  std::vector<Pairs> blocks((atoms.size() + kBlock - 1) / kBlock);
  in_parallel(
      blocks.size(),
      [&](std::size_t first, std::size_t last) {
        for (std::size_t block = first; block != last; ++block)
          for (std::size_t i = block * kBlock; i < std::min(atoms.size(), (block + 1) * kBlock);
               ++i)
            bonds_of(static_cast<std::uint32_t>(i), blocks[block]);
      },
      1);
  Pairs all;
  for (Pairs& block : blocks) {
    all.insert(all.end(), block.begin(), block.end());
    block = {};
  }
  return all;
}

}  // namespace zraka
