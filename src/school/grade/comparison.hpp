// SPDX-License-Identifier: Apache-2.0
// A submission beside the pictures of a stage: how near it is to the right one and to those of
// mistakes.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "school/grade/align.hpp"
#include "school/grade/round_trip.hpp"
#include "school/grade/stage_pictures.hpp"

namespace zraka {

struct Match {
  const Candidate* candidate = nullptr;  ///< nullptr: the right picture
  std::size_t way = 0;
  double distance = std::numeric_limits<double>::infinity();  ///< mean square
  Rest rest{};
};

/// How much of what a picture leaves unexplained is what a change would make.
struct Likeness {
  double strength = 0;  ///< the change's multiple that comes nearest: 1 if it was made
  double share = 0;     ///< of the squares that this multiple explains
};

/// What a picture with mistakes leaves, in mean squares.
struct LeftOfChange {
  double changed = 0;   ///< where they change something
  double of_right = 0;  ///< what the right picture leaves there
  /// Where they change nothing and the picture is not plain; infinite where that is too little.
  double noise = 0;
  bool same_there = false;  ///< most pixels are the same there
};

/// How a submission was compressed.
struct Compression {
  bool jpeg = false;
  const JpegTables* tables = nullptr;         ///< where they are known
  const UnpaintedLines* unpainted = nullptr;  ///< that the submission is without
};

class StageComparison {
 public:
  /// It lies where it lies best on the picture with `by`, by default on the right one.
  StageComparison(const StagePictures& pictures, int stage, const Fitted& fitted,
                  const Compression& compression, const MistakenBy& by = {});

  const Region& region() const { return fitted_.region; }
  const Image& wanted() const { return wanted_; }
  const Image& taken() const { return taken_; }  ///< in the chosen way
  const Match& right() const { return right_; }
  const Closeness& close() const { return close_; }
  const Fitted& fitted() const { return fitted_; }
  std::size_t way() const { return way_; }
  const std::vector<Alignment>& ways() const { return ways_; }

  void take_way(std::size_t way);
  /// Looks anew where the right picture lies, by a mistake's, in the chosen way.
  void lie_on(const MistakenBy& by);
  /// Is it the right picture, in the chosen way?
  bool compare_with_right();
  /// All pictures with few pixels, in all ways.
  std::vector<Match> nearest_by_few() const;
  /// As it was handed in, unless another way fits much better.
  std::size_t best_way(const std::vector<Match>& matches) const;
  /// Keeps the best few of the chosen way, compared pixel by pixel, the nearest first.
  void look_closely(std::vector<Match>& matches) const;
  /// What is left where nothing but a JPEG's rounding was lost, which the picture has lost as well:
  /// values between those of neighbours are excused no more. Right pictures leave no blocks.
  Rest left_of_rounding(const Image& picture) const;
  /// Is every picture compressed by the submission's own tables, pixel by pixel?
  bool compresses_alike() const {
    return tables_ != nullptr && unpainted_ == nullptr && fitted_.exact && way_ == 0;
  }
  LeftOfChange left_of_change(const Image& picture) const;
  Match look_at(const Candidate& candidate, const Image& picture) const;

  /// A picture with mistakes in the size of the submission's, as it comes out of its scaling.
  Image picture_of(const MistakenBy& by) const;
  bool shows(const MistakenBy& by) const;
  /// Where the powers of highlights are what is wrong: are they those, rather than some others?
  bool has_its_powers(const MistakenBy& by) const;
  /// Does it leave no more than a share of what a plain picture leaves, in squares?
  bool is_near(const MistakenBy& by, double share) const;
  /// The submission with few pixels, as those of candidates.
  Image few(std::uint32_t width, std::uint32_t height) const;
  Region region_of_few(std::uint32_t width, std::uint32_t height) const;

  /// Products of what differs from the right picture and what each mistake changes, by few pixels.
  std::vector<double> products_with(const std::vector<Candidate>& candidates) const;
  /// What the step from one picture to another explains of what the first leaves.
  Likeness likeness_of_change(const Image& from, const Image& to) const;
  /// Mistakes whose change, by few pixels, explains most of what a picture leaves, beside those
  /// that it has: the best first.
  std::vector<Mistake> likely_besides(const MistakenBy& by, const Image& picture,
                                      std::size_t most) const;

 private:
  void lie_best_on(const Image& picture);

  const StagePictures& pictures_;
  const StagePictures& sized_;  ///< in the size that it was drawn in
  int stage_;
  const Image& wanted_;
  Fitted fitted_;
  Closeness close_;
  std::vector<Alignment> ways_;
  std::size_t way_ = 0;
  bool jpeg_;
  const JpegTables* tables_;
  const UnpaintedLines* unpainted_;
  RoundTrip as_handed_in_;
  Image taken_, smooth_;
  Match right_;
};

/// Rows and columns at the edges that are mostly of one colour, which the right picture has not,
/// are a frame over it, or were transparent: they were not handed in.
void trim_frame(Fitted& fitted, const Image& wanted, bool jpeg);

}  // namespace zraka
