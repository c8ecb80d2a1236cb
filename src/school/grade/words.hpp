// SPDX-License-Identifier: Apache-2.0
// A grade for people and for programs.
#pragma once

#include <string>
#include <vector>
#include <zraka/school/grade.hpp>

#include "core/words.hpp"

namespace zraka {

/// "2.5", "2,5".
std::string marks_text(Language language, double marks);
/// "right", as JSON and pages call it, and "+", as tables do.
std::string_view key_of(Verdict verdict);
char sign_of(Verdict verdict);

/// How a picture was aligned; "" if it was not.
std::string alignment_text(Language language, const Alignment& alignment);

/// What was found out about a stage, line by line; the first says what it is.
std::vector<std::string> findings(Language language, const Grader& grader, const StageGrade& stage);

/// "2.5 of 7 marks", then a line for each stage with its findings below.
std::string grade_text(Language language, const Grader& grader, const Grade& grade);

/// A line for each submission, stage by stage.
std::string grades_table(Language language, const std::vector<Grade>& grades);

/// {"score", "max_score", "tests": [...]}: what Submitty, Gradescope and GitHub Classroom read
/// (docs/grade.md).
std::string grade_json(Language language, const Grader& grader, const std::vector<Grade>& grades,
                       bool several);

}  // namespace zraka
