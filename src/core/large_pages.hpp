// SPDX-License-Identifier: Apache-2.0
// Memory in large pages.
#pragma once

#include <cstddef>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace zraka {

/// Room for so many values of an empty vector, if there is much of it in large pages, where the
/// system has them to give: to touch the first value of each small page takes longer than to fill
/// the page.
template <class T>
void reserve_large_pages(std::vector<T>& values, std::size_t count) {
  values.reserve(count);
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::size_t kSmall = 4096, kMuch = std::size_t{4} << 20;
  const auto begin = reinterpret_cast<std::size_t>(values.data());
  const std::size_t first = (begin + kSmall - 1) / kSmall * kSmall;
  const std::size_t end = (begin + count * sizeof(T)) / kSmall * kSmall;
  // Where it is refused, pages are as small as they would have been.
  if (count * sizeof(T) >= kMuch)
    (void)madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#endif
}

}  // namespace zraka
