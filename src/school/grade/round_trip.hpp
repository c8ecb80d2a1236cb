// SPDX-License-Identifier: Apache-2.0
// What became of a picture between a program and its grader, done once more.
#pragma once

#include "image/jpeg_again.hpp"
#include "school/grade/align.hpp"
#include "school/grade/unpainted.hpp"

namespace zraka {

/// Right and bottom are outside.
struct DrawnBox {
  std::uint32_t left, top, right, bottom;
};

/// A picture of a right size as it comes out of what a submission went through.
class RoundTrip {
 public:
  RoundTrip() = default;
  /// `tables`: the submission's, nullptr where it is no JPEG; `unpainted`: lines that it is
  /// without. All must outlive it.
  RoundTrip(const Fitted& fitted, const JpegTables* tables,
            const UnpaintedLines* unpainted = nullptr);
  Image operator()(Image image) const;

 private:
  Image compressed(const Image& there, const DrawnBox& drawn) const;

  const JpegTables* tables_ = nullptr;
  const UnpaintedLines* unpainted_ = nullptr;
  Fitted part_;  ///< what is compressed: whole blocks around the picture
};

}  // namespace zraka
