// SPDX-License-Identifier: Apache-2.0
// What is wrong with a picture, where it is known where it lies.
#pragma once

#include <deque>
#include <limits>
#include <set>
#include <vector>

#include "school/grade/comparison.hpp"

namespace zraka {

/// A picture is near to another where it leaves this much of what a plain one does, in squares.
inline constexpr double kNear = 0.6;

class Judge {
 public:
  Judge(const StagePictures& pictures, int stage, const Fitted& fitted,
        const Compression& compression, const MistakenBy& lies_on = {})
      : pictures_(pictures),
        stage_(stage),
        compression_(compression),
        compared_(pictures, stage, fitted, compression, lies_on) {}

  /// Two mistakes at once are only looked for where that is wanted.
  StageGrade verdict(const std::set<Mistake>* known);
  double distance_if_right() {
    compared_.take_way(0);
    return compared_.compare_with_right() ? compared_.right().distance
                                          : std::numeric_limits<double>::infinity();
  }
  /// From the picture with these mistakes, as it was handed in.
  double distance(const MistakenBy& by) {
    compared_.take_way(0);
    return mean_square(compared_.taken(), compared_.picture_of(by), compared_.region());
  }

 private:
  bool find_right(std::vector<Match>& by_few);
  void lie_on_nearest(const std::vector<Match>& by_few);
  bool explains(const Match& match) const;
  bool leaves_a_shape(const Match& match) const;
  enum class Left { noise, perhaps, more };
  Left left_where_changed(const MistakenBy& by) const;
  std::vector<Match> as_likely(const std::vector<Match>& matches) const;
  std::vector<Match> hidden_besides(const MistakenBy& by, const Image& picture, bool& sign) const;
  void name_second(const Match& first, StageGrade& grade) const;
  std::vector<Match> likely_pairs(const std::vector<Match>& singles,
                                  const std::set<Mistake>& known) const;
  bool name_two(const std::vector<Match>& singles, const std::set<Mistake>& known,
                StageGrade& grade);
  bool name_probable(const std::vector<Match>& matches, StageGrade& grade) const;
  void settle(Verdict verdict, const Rest& left, StageGrade& grade) const;
  StageGrade& finish(StageGrade& grade) const;

  const StagePictures& pictures_;
  int stage_;
  Compression compression_;
  StageComparison compared_;
  mutable std::deque<Candidate> made_;  ///< pairs
};

}  // namespace zraka
