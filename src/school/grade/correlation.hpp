// SPDX-License-Identifier: Apache-2.0
// How alike the outlines of two pictures are: normalised cross-correlation over what is visible.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "school/grade/resample.hpp"

namespace zraka {

/// Sums over any rectangle of a grid, of its values and of their squares.
class Table {
 public:
  explicit Table(const Grid& grid)
      : stride_(std::size_t{grid.width} + 1), sums_(stride_ * (std::size_t{grid.height} + 1)) {
    for (std::uint32_t y = 0; y < grid.height; ++y) {
      std::array<double, 2> row{};
      for (std::uint32_t x = 0; x < grid.width; ++x) {
        const auto value = static_cast<double>(grid.row(y)[x]);
        row[0] += value;
        row[1] += value * value;
        const std::size_t here = (y + 1) * stride_ + x + 1;
        for (std::size_t i = 0; i < 2; ++i) sums_[here][i] = sums_[here - stride_][i] + row[i];
      }
    }
  }
  /// Right and bottom are outside.
  std::array<double, 2> over(std::size_t left, std::size_t top, std::size_t right,
                             std::size_t bottom) const {
    std::array<double, 2> sum{};
    for (std::size_t i = 0; i < 2; ++i)
      sum[i] = sums_[bottom * stride_ + right][i] - sums_[bottom * stride_ + left][i] -
               sums_[top * stride_ + right][i] + sums_[top * stride_ + left][i];
    return sum;
  }
  double energy() const { return sums_.back()[1]; }

 private:
  std::size_t stride_;
  std::vector<std::array<double, 2>> sums_;
};

/// The template in one of its sizes.
struct Searched {
  explicit Searched(Grid grid_of) : grid(std::move(grid_of)), table(grid) {}
  Grid grid;
  Table table;
};

/// A template in one of its sizes, and the submission in its own; positions are of the template's
/// pixels in the submission's.
class SearchLevel {
 public:
  SearchLevel(const Searched& searched, const Grid& submission)
      : searched_(searched), submission_(submission) {}

  /// At most 1; -1 where too little is visible.
  double likeness(const GridPlacement& at) const;

  /// Climbs from a placement: shifts and scales of both axes by steps that are halved. The first
  /// ones are in the template's pixels.
  double refine(GridPlacement& at, double first, double last) const;

 private:
  const Searched& searched_;
  const Grid& submission_;
};

/// All shifts of a template in a submission, both small, that are more alike than `least`.
void slide(const Searched& small, const Grid& where, double least,
           const std::function<void(std::int32_t left, std::int32_t top, double likeness)>& found);

}  // namespace zraka
