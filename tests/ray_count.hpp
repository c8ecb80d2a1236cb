// SPDX-License-Identifier: Apache-2.0
// How many rays a test takes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace zraka {

/// ZRAKA_TEST_RAYS=1000000 in the environment asks for more rays than a test has time for.
inline std::size_t ray_count(std::size_t usual) {
  const char* more = std::getenv("ZRAKA_TEST_RAYS");
  return more == nullptr
             ? usual
             : std::max(usual, static_cast<std::size_t>(std::strtoull(more, nullptr, 10)));
}

}  // namespace zraka
