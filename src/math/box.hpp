// SPDX-License-Identifier: Apache-2.0
// Axis-aligned boxes in world space.
#pragma once

#include <algorithm>
#include <limits>
#include <zraka/values.hpp>

namespace zraka {

/// Empty (lower above upper) until something is put in.
struct Box {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Vec3 lower{kInfinity, kInfinity, kInfinity};
  Vec3 upper{-kInfinity, -kInfinity, -kInfinity};

  bool empty() const { return !(lower.x <= upper.x); }
  void include(const Box& other) {
    lower = {std::min(lower.x, other.lower.x), std::min(lower.y, other.lower.y),
             std::min(lower.z, other.lower.z)};
    upper = {std::max(upper.x, other.upper.x), std::max(upper.y, other.upper.y),
             std::max(upper.z, other.upper.z)};
  }
};

}  // namespace zraka
