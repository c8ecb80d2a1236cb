// SPDX-License-Identifier: Apache-2.0
// What a pixel's colour is to be computed from.
#pragma once

#include <string>
#include <vector>
#include <zraka/explain.hpp>

#include "core/words.hpp"

namespace zraka {

/// Lines for a pixel of one tree whose first ray hits a shape: all that its colour follows from,
/// and no sum or product of it.
std::vector<std::string> facts_of(Language language, const Explanation& explanation);

}  // namespace zraka
