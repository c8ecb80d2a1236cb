// SPDX-License-Identifier: Apache-2.0
// What is wrong with a picture of a stage, and how sure that is.
#pragma once

#include "school/grade/align.hpp"
#include "school/grade/stage_pictures.hpp"

namespace zraka {

/// A picture of a submission, once it is known where the right one lies in it.
struct Registered {
  std::vector<Fitted> fitted;  ///< where it may be, the plainest first
  bool jpeg = false;
};

/// Judges it as one of the stage. `known` are the mistakes that earlier stages have shown.
StageGrade judge(const StagePictures& pictures, int stage, const Registered& submitted,
                 const std::set<Mistake>& known = {});

/// The stage whose right picture is nearest, with what is beyond for each in `rest`.
int nearest_stage(const StagePictures& pictures, const Registered& submitted);

}  // namespace zraka
