// SPDX-License-Identifier: Apache-2.0
// What somebody handed in: pictures in a file, a folder or an archive.
#pragma once

#include <string>
#include <vector>
#include <zraka/diagnostic.hpp>
#include <zraka/image.hpp>

namespace zraka {

/// The stage of letters, differences and contact sheets, which get no marks.
inline constexpr int kNoStage = 8;

struct SubmittedPicture {
  std::string file;  ///< as it is called in the submission
  int stage = 0;     ///< by its name: 1 to 7, kNoStage, or 0 where the name does not say
  Result<ReadImage> image;
  bool alone = false;  ///< it was handed in as a file of its own
};

/// All pictures of a submission, in the order of their names. Fails where nothing can be read; a
/// picture that cannot is in the list with its problem. Links are not followed, and nothing outside
/// of the path is touched.
Result<std::vector<SubmittedPicture>> read_submission(const std::string& path);

/// The stage that a file's name tells, in English or Croatian: 0 where it tells none, or
/// kNoStage.
int stage_of_name(const std::string& file);

}  // namespace zraka
