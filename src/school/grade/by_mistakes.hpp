// SPDX-License-Identifier: Apache-2.0
// Where a submission lies on a mistake's own picture: where the mistake moves outlines, or makes
// others, the right picture's tell little.
#pragma once

#include <optional>

#include "school/grade/judge.hpp"

namespace zraka {

/// What is wrong with a submission that lies nowhere on the right picture, if its outlines say
/// that it is a mistake's picture, and its colours do.
std::optional<StageGrade> judge_by_mistakes(const StagePictures& pictures, int stage,
                                            const Registered& submitted);

/// The picture of a window that is too large has the right one in its middle: is that all?
std::optional<StageGrade> judge_as_wide(const StagePictures& pictures, int stage,
                                        const Registered& submitted, const Fitted& right);

}  // namespace zraka
