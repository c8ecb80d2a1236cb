// SPDX-License-Identifier: Apache-2.0
// What became of a picture between a program and its grader, done once more.
#pragma once

#include "image/jpeg_again.hpp"
#include "school/grade/align.hpp"

namespace zraka {

/// A picture of a right size as it comes out of what a submission went through.
class RoundTrip {
 public:
  RoundTrip() = default;
  /// `tables`: the submission's, nullptr where it is no JPEG. The fit must outlive it.
  RoundTrip(const Fitted& fitted, const JpegTables* tables);
  Image operator()(Image image) const;

 private:
  const JpegTables* tables_ = nullptr;
  Fitted part_;  ///< what is compressed: whole blocks around the picture
};

}  // namespace zraka
