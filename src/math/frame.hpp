// SPDX-License-Identifier: Apache-2.0
// The engine's frame: the world moved to the scene's centre and scaled, so that floats are spent on
// the scene and not on its distance from the origin or its unit.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <zraka/values.hpp>

#include "math/bounds.hpp"

namespace zraka {

struct Frame {
  Vec3 center;
  double scale = 1;  ///< a power of two, so that scaling by it is exact
  double reach = 1;  ///< at least as large as all coordinates of shapes
  /// How wide the picture is where the nearest shape in it lies; infinite where there is none.
  double width_seen = std::numeric_limits<double>::infinity();
  /// How far the eye is moved along the view, off a surface that it lies on.
  double eye_shift = 0;

  Vec3 point(const Vec3& world) const {
    return {(world.x - center.x) * scale, (world.y - center.y) * scale,
            (world.z - center.z) * scale};
  }
  Vec3 vector(const Vec3& world) const {
    return {world.x * scale, world.y * scale, world.z * scale};
  }
  double length(double world) const { return world * scale; }
  /// Back to the world.
  Vec3 world_point(const Vec3& framed) const {
    return {framed.x / scale + center.x, framed.y / scale + center.y, framed.z / scale + center.z};
  }
  double world_length(double framed) const { return framed / scale; }

  /// The frame around a point in which the farthest side of `bounds` is at a distance in (½, 1].
  static Frame around(const Vec3& center, const Bounds& bounds) {
    if (bounds.empty()) return {};
    Frame frame{center};
    const double reach =
        std::max({bounds.upper.x - center.x, bounds.upper.y - center.y, bounds.upper.z - center.z,
                  center.x - bounds.lower.x, center.y - bounds.lower.y, center.z - bounds.lower.z});
    if (reach > 0 && std::isfinite(reach)) {
      int exponent = 0;
      const double mantissa = std::frexp(reach, &exponent);  // [½, 1)
      frame.scale =
          std::ldexp(1.0, std::clamp(mantissa == 0.5 ? 1 - exponent : -exponent, -1000, 1000));
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
