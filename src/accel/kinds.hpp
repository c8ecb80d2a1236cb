// SPDX-License-Identifier: Apache-2.0
// Which kind of shape a reference stands for: a leaf holds one kind.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "accel/ranges.hpp"
#include "scene/frozen.hpp"

namespace zraka {

/// Kind k holds the slots [starts[k], starts[k + 1]).
class Kinds {
 public:
  explicit Kinds(const std::vector<std::int32_t>& starts) : starts_(starts) {}

  std::int32_t of(const BuildRef& ref) const {
    std::size_t kind = 0;
    while (ref.index >= starts_[kind + 1]) ++kind;
    return static_cast<std::int32_t>(kind);
  }
  /// Bodies are intersected out of line and in double: to ask one takes as long as many others.
  bool is_body(const BuildRef& ref) const { return of(ref) == kKindOfBody; }
  bool are_one(const Range& range) const {
    return std::all_of(range.begin, range.end,
                       [&](const BuildRef& r) { return of(r) == of(*range.begin); });
  }
  /// Those of the first kind that there is in a range of several, and the others.
  std::pair<Range, Range> split(const Range& range) const {
    std::sort(range.begin, range.end,
              [](const BuildRef& a, const BuildRef& b) { return a.index < b.index; });
    BuildRef* middle = std::find_if(range.begin, range.end,
                                    [&](const BuildRef& r) { return of(r) != of(*range.begin); });
    return {range_of(range.begin, middle), range_of(middle, range.end)};
  }

 private:
  const std::vector<std::int32_t>& starts_;
};

}  // namespace zraka
