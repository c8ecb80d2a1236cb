// SPDX-License-Identifier: Apache-2.0
// What a stage changed and why, in words for what was counted.
#pragma once

#include <string>
#include <vector>

#include "core/words.hpp"
#include "school/report/facts.hpp"

namespace zraka {

/// Sentences about a stage's picture against the one before. Each is true for any scene: what did
/// not occur is not mentioned, or said not to occur.
std::vector<std::string> comments_on(Language language, const SceneFacts& scene, Stage stage);

}  // namespace zraka
