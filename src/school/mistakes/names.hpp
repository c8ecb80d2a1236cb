// SPDX-License-Identifier: Apache-2.0
// What mistakes are called.
#pragma once

#include <string_view>
#include <zraka/school/mistakes.hpp>

#include "core/words.hpp"

namespace zraka {

/// What is wrong, as a sentence without a full stop. Not for Mistake::none.
std::string_view text_of(Language language, Mistake mistake);

}  // namespace zraka
