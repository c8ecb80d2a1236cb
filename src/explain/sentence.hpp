// SPDX-License-Identifier: Apache-2.0
// A pixel in one or two sentences.
#pragma once

#include <string>
#include <zraka/explain.hpp>

#include "core/words.hpp"

namespace zraka {

/// What gives the pixel most of its colour, and why the rest is missing, decided by the parts
/// (parts.hpp) and nothing else, so that it is true of any scene.
std::string in_words(Language language, const Explanation& explanation);

}  // namespace zraka
