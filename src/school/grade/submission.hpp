// SPDX-License-Identifier: Apache-2.0
// What somebody handed in: pictures in a file, a folder or an archive.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>
#include <zraka/diagnostic.hpp>
#include <zraka/image.hpp>
#include <zraka/school/grade.hpp>

#include "image/jpeg_again.hpp"
#include "school/grade/unpainted.hpp"

namespace zraka {

/// The stage of letters, differences and contact sheets, which get no marks.
inline constexpr int kNoStage = 8;

/// A picture that was handed in, not decoded yet: submissions hold many, and may hold large ones.
struct SubmittedPicture {
  std::string file;            ///< as it is called in the submission
  int stage = 0;               ///< by its name: 1 to 7, kNoStage, or 0 where the name does not say
  std::string path{};          ///< where it lies; "" in an archive
  std::string bytes{};         ///< the file, of one in an archive
  Diagnostics problems{};      ///< why it cannot be read, where that is known
  bool stage_is_sure = false;  ///< a word tells it, or whoever marks; numbers are hints
  bool alone = false;          ///< it was handed in as a file of its own
  bool document = false;       ///< it is a report's, whose program has chosen its name
};

/// One that was decoded.
struct DecodedPicture {
  Image image;
  bool jpeg = false;
  std::optional<JpegTables> tables{};  ///< of a JPEG that has its own size
  /// Lines of a JPEG that `image` is without; nullptr where there are none.
  std::shared_ptr<const UnpaintedLines> unpainted{};
};

/// What pictures are compared with.
struct PictureKind {
  std::uint32_t width = 0, height = 0;
  Transfer transfer = Transfer::linear;  ///< of stored values
};

/// All pictures of a submission, in the order of their names. Fails where a part of it cannot be
/// read; a picture that cannot is in the list. No link in a folder is followed, and nothing outside
/// of the path is touched; whether the path itself may be a link is said by `links`.
Result<std::vector<SubmittedPicture>> read_submission(const std::string& path, Links links);

/// A picture of a submission in stored values, with about as many pixels at most as one four times
/// as wide and as high as what it is compared with. Large ones are decoded one at a time, whatever
/// the number of threads.
Result<DecodedPicture> read_picture(const SubmittedPicture& picture, const PictureKind& kind);

/// Is the file called like a picture, or like an archive of pictures?
bool is_handed_in(const std::string& file);

/// The stage that a file's name tells, in English or Croatian: 0 where it tells none, or
/// kNoStage.
int stage_of_name(const std::string& file);
/// Whether a word tells it.
bool is_named_for_sure(const std::string& file);

}  // namespace zraka
