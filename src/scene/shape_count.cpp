// SPDX-License-Identifier: Apache-2.0
#include <zraka/scene.hpp>

namespace zraka {

std::uint64_t ShapeLists::shape_count() const {
  std::uint64_t count = 0;
#define ZRAKA_COUNT(Type, plural) count += plural.size();
  ZRAKA_SHAPES(ZRAKA_COUNT)
#undef ZRAKA_COUNT
  return count;
}

}  // namespace zraka
