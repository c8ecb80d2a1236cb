// SPDX-License-Identifier: Apache-2.0
// Where the right picture lies in what was handed in: found by outlines, which mistakes of light
// and colour leave where they are.
#pragma once

#include <memory>

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

/// What is searched for.
class Template {
 public:
  Template() = default;
  /// From pictures of the same size that show the same silhouettes.
  explicit Template(const std::vector<const Image*>& pictures);
  /// With left and right exchanged.
  Template mirrored() const;
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
