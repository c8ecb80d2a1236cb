// SPDX-License-Identifier: Apache-2.0
// The engine's frame: the world moved to the scene's centre and scaled, so that floats are spent on
// the scene and not on its distance from the origin or its unit.
#pragma once

#include <algorithm>
#include <cmath>
#include <zraka/values.hpp>

#include "math/box.hpp"

namespace zraka {

struct Frame {
  Vec3 center;
  double scale = 1;  ///< a power of two, so that scaling by it is exact

  Vec3 point(const Vec3& world) const {
    return {(world.x - center.x) * scale, (world.y - center.y) * scale,
            (world.z - center.z) * scale};
  }
  Vec3 vector(const Vec3& world) const {
    return {world.x * scale, world.y * scale, world.z * scale};
  }
  double length(double world) const { return world * scale; }

  /// The frame in which `bounds` is centred and its largest half extent lies in (½, 1].
  static Frame around(const Box& bounds) {
    if (bounds.empty()) return {};
    const auto middle = [](double a, double b) { return a / 2 + b / 2; };
    Frame frame{{middle(bounds.lower.x, bounds.upper.x), middle(bounds.lower.y, bounds.upper.y),
                 middle(bounds.lower.z, bounds.upper.z)}};
    const double half = std::max({bounds.upper.x - frame.center.x, bounds.upper.y - frame.center.y,
                                  bounds.upper.z - frame.center.z});
    if (half > 0 && std::isfinite(half)) {
      int exponent = 0;
      const double mantissa = std::frexp(half, &exponent);  // [½, 1)
      frame.scale = std::ldexp(1.0, mantissa == 0.5 ? 1 - exponent : -exponent);
    }
    return frame;
  }
};

inline bool finite(double v) {
  return std::isfinite(v);
}
inline bool finite(const Vec3& v) {
  return finite(v.x) && finite(v.y) && finite(v.z);
}
inline bool finite(const Color& c) {
  return finite(c.r) && finite(c.g) && finite(c.b);
}

}  // namespace zraka
