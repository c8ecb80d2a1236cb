// SPDX-License-Identifier: Apache-2.0
// Boxes with sides along the axes.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <zraka/values.hpp>

namespace zraka {

/// Empty (lower above upper) until something is put in.
struct Bounds {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Vec3 lower{kInfinity, kInfinity, kInfinity};
  Vec3 upper{-kInfinity, -kInfinity, -kInfinity};

  static Bounds everything() {
    return {{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, kInfinity}};
  }
  bool bounded() const { return reach() < kInfinity; }
  bool empty() const { return !(lower.x <= upper.x); }
  void include(const Bounds& other) {
    lower = {std::min(lower.x, other.lower.x), std::min(lower.y, other.lower.y),
             std::min(lower.z, other.lower.z)};
    upper = {std::max(upper.x, other.upper.x), std::max(upper.y, other.upper.y),
             std::max(upper.z, other.upper.z)};
  }
  /// From a point; 0 inside.
  double distance_to(const Vec3& p) const {
    const double x = std::max({lower.x - p.x, p.x - upper.x, 0.0}),
                 y = std::max({lower.y - p.y, p.y - upper.y, 0.0}),
                 z = std::max({lower.z - p.z, p.z - upper.z, 0.0});
    return std::sqrt(x * x + y * y + z * z);
  }
  /// Half of its longest side.
  double reach() const {
    return std::max({upper.x - lower.x, upper.y - lower.y, upper.z - lower.z}) / 2;
  }
};

}  // namespace zraka
