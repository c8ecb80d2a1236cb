// SPDX-License-Identifier: Apache-2.0
// Where the right picture lies in what was handed in: found by outlines, which mistakes of light
// and colour leave where they are.
#pragma once

#include <memory>

#include "school/grade/correlation.hpp"
#include "school/grade/resample.hpp"

namespace zraka {

/// What was done to a submission before: top and bottom change places, then columns and rows, then
/// top and bottom once more.
struct Turn {
  bool flipped_first = false, transposed = false, flipped = false;
  friend bool operator==(const Turn&, const Turn&) = default;
};
/// All that the sheet's wording allows; the first leaves it as it is.
inline constexpr Turn kTurns[] = {{},
                                  {.flipped = true},
                                  {.transposed = true},
                                  {.transposed = true, .flipped = true},
                                  {.flipped_first = true, .transposed = true}};

/// Where a picture lies in a submission that was turned first.
struct Position {
  Turn turn;
  GridPlacement placement;
  double likeness = -1;  ///< correlation of outlines, at most 1
};

/// Outlines of a picture: how much its colours change, compressed.
Grid outlines(const Image& image);

/// With sides of no more than `side`.
Grid reduced_to(const Grid& plane, std::uint32_t side);
/// A placement of one size of template and submission in those of another.
GridPlacement rescaled(const GridPlacement& p, double template_by_x, double template_by_y,
                       double submission_by_x, double submission_by_y);

/// Sides of what is searched for in the steps of the search.
inline constexpr std::uint32_t kCoarseOutlines = 24, kMiddleOutlines = 64, kFineOutlines = 200;
/// The scales that are tried.
inline constexpr double kSmallestScale = 0.45, kLargestScale = 3.3, kScaleStep = 1.07;
/// Axes may be scaled that far apart.
inline constexpr double kAxesApart = 0.07;

/// What is searched for.
class Template {
 public:
  Template() = default;
  /// From pictures of the same size that show the same silhouettes.
  explicit Template(const std::vector<const Image*>& pictures);
  /// Positions in a submission that may be right, the plainest first: at least one. Scales from 0.5
  /// to 3 are tried, axes up to 7 % apart.
  std::vector<Position> find(const Image& submission) const;

 private:
  struct Sizes;
  GridPlacement best_shift(const Grid& submission, const GridPlacement& found) const;

  Grid outlines_;
  std::shared_ptr<const Sizes> sizes_;  ///< of the steps of the search
};

}  // namespace zraka
