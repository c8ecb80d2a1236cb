// SPDX-License-Identifier: Apache-2.0
// What is wrong with a picture of a stage, and how sure that is.
#pragma once

#include "school/grade/align.hpp"
#include "school/grade/comparison.hpp"
#include "school/grade/drawn_size.hpp"
#include "school/grade/stage_pictures.hpp"
#include "school/grade/submission.hpp"

namespace zraka {

/// A picture of a submission, and where the right one lies in it.
class Registered {
 public:
  Registered(const DecodedPicture& read, const StagePictures& pictures, const SizedPictures& sizes)
      : read_(read), pictures_(pictures), sizes_(sizes) {}
  const Image& handed_in() const { return read_.image; }
  bool jpeg() const { return read_.jpeg; }
  Compression compression() const {
    return {jpeg(), read_.tables ? &*read_.tables : nullptr, read_.unpainted.get()};
  }
  /// As a whole, pixel by pixel: where it shows what the scene does there. Fast to find.
  const std::vector<Fitted>& plain() const;
  /// Wherever outlines say that it may be, the plainest first.
  const std::vector<Fitted>& fitted() const;

 private:
  const DecodedPicture& read_;
  const StagePictures& pictures_;
  const SizedPictures& sizes_;
  mutable std::vector<Fitted> plain_, fitted_;
  mutable bool looked_ = false;
};

/// Does a picture that lies about where the whole one does explain the named mistakes no better
/// than the whole one? Then it is that, pixel by pixel.
bool is_the_whole(const StagePictures& pictures, int stage, const Registered& submitted,
                  const Fitted& fitted, const StageGrade& grade);

/// Judges it as one of the stage. `known` are the mistakes that earlier stages have shown.
StageGrade judge(const StagePictures& pictures, int stage, const Registered& submitted,
                 const std::set<Mistake>& known = {});

/// A stage whose right picture it is, the named one if that is one of them; 0 where it is none.
int right_stage(const StagePictures& pictures, const Registered& submitted, int named);

/// The stage whose right picture is nearest, and whether it is so near that they may be the same.
struct NearestStage {
  int stage = 7;
  bool near = false;
};
NearestStage nearest_stage(const StagePictures& pictures, const Registered& submitted);

}  // namespace zraka
