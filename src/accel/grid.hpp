// SPDX-License-Identifier: Apache-2.0
// Large ranges cut into many parts at once.
#pragma once

#include <vector>

#include "accel/ranges.hpp"

namespace zraka {

/// A range's references counted by cells of their centres, 16 a side: four levels of splits from
/// one look at the references.
class Grid {
 public:
  explicit Grid(const Binning& binning) : binning_(binning), bounds_(kCells), counts_(kCells, 0) {}

  std::size_t cell_of(const BuildRef& ref) const {
    const FourInts at = binning_.bins_of(lower_of(ref), upper_of(ref));
    return static_cast<std::size_t>((at[2] * kSide + at[1]) * kSide + at[0]);
  }
  void count(const BuildRef* begin, const BuildRef* end) {
    for (const BuildRef* r = begin; r != end; ++r) {
      const std::size_t cell = cell_of(*r);
      bounds_[cell].include(lower_of(*r), upper_of(*r));
      ++counts_[cell];
    }
  }
  void add(const Grid& other) {
    for (std::size_t i = 0; i < kCells; ++i) {
      bounds_[i].include(other.bounds_[i]);
      counts_[i] += other.counts_[i];
    }
  }
  /// At most `most` ranges, each with its bounds but not those of its centres, in place of one;
  /// fewer than two where all references lie in one cell.
  std::vector<Range> cut(const Range& range, std::size_t most) const;

 private:
  static constexpr int kSide = 16;
  static constexpr std::size_t kCells = std::size_t{kSide} * kSide * kSide;

  /// A box of cells, and where to split it best.
  struct Block {
    int from[3] = {0, 0, 0}, to[3] = {kSide, kSide, kSide};
    BuildBounds bounds;
    std::size_t count = 0;
    int axis = 3, border = 0;  // 3: cannot be split
  };
  template <class Function>
  static void each_cell(const Block& block, const Function& function) {
    for (int z = block.from[2]; z < block.to[2]; ++z)
      for (int y = block.from[1]; y < block.to[1]; ++y)
        for (int x = block.from[0]; x < block.to[0]; ++x)
          function(static_cast<std::size_t>((z * kSide + y) * kSide + x), x, y, z);
  }
  void look_into(Block& block) const;

  Binning binning_;
  std::vector<BuildBounds> bounds_;
  std::vector<std::uint32_t> counts_;
};

/// The grid of a large range, by several tasks.
Grid counted(const Range& range, const Binning& binning);

}  // namespace zraka
