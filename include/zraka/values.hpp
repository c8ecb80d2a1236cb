// SPDX-License-Identifier: Apache-2.0
// The plain values that scenes are made of.
#pragma once

namespace zraka {

/// A point or a direction in world space: right-handed, y up.
struct Vec3 {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

/// Linear red, green and blue; 1 is the brightest that a picture can show.
struct Color {
  double r = 0, g = 0, b = 0;
  friend bool operator==(const Color&, const Color&) = default;
};

}  // namespace zraka
