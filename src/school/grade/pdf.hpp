// SPDX-License-Identifier: Apache-2.0
// The pictures on a PDF's pages.
#pragma once

#include <string>
#include <vector>

#include "school/grade/submission.hpp"

namespace zraka {

/// Adds the pictures of a PDF that is in memory, in the order of its pages, called `within` and
/// their number. Those in colour spaces or compressions that reports do not have are told to be
/// unreadable. Fails where the PDF is damaged, locked, or unpacks to too much.
Result<void> take_from_pdf(const std::string& bytes, const std::string& within,
                           std::vector<SubmittedPicture>& pictures);

}  // namespace zraka
