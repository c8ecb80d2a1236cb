// SPDX-License-Identifier: Apache-2.0
// Grades as pages for browsers and for paper.
#pragma once

#include <string>
#include <vector>
#include <zraka/school/grade.hpp>

#include "core/words.hpp"

namespace zraka {

/// A self-contained page: for each stage its marks, what was found out, and the pictures that show
/// it: the one handed in as it was compared, the right one, their difference, and the one with the
/// named mistake. `scene` is the scene's name. Fails where a picture cannot be packed.
Result<std::string> grade_page(Language language, const Grader& grader, const Grade& grade,
                               const std::string& scene);

/// A page with a row for each submission of a class, which unfolds; without pictures.
Result<std::string> grades_page(Language language, const Grader& grader,
                                const std::vector<Grade>& grades, const std::string& scene);

}  // namespace zraka
