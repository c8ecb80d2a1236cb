// SPDX-License-Identifier: Apache-2.0
// Marks for what was found out about the pictures.
#pragma once

#include <vector>
#include <zraka/school/grade.hpp>

namespace zraka {

/// Sets the marks of each stage, in their order; a mistake costs where it comes first.
void mark(const Rubric& rubric, std::vector<StageGrade>& grades);

}  // namespace zraka
