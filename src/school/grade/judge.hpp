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
  const Image* handed_in = nullptr;
};

/// Judges it as one of the stage. `known` are the mistakes that earlier stages have shown.
StageGrade judge(const StagePictures& pictures, int stage, const Registered& submitted,
                 const std::set<Mistake>& known = {});

/// A stage whose right picture it is, the named one if that is one of them; 0 where it is none.
int right_stage(const StagePictures& pictures, const Registered& submitted, int named);

/// The stage whose right picture is nearest.
int nearest_stage(const StagePictures& pictures, const Registered& submitted);

}  // namespace zraka
