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

/// A share of the light, of each channel; a number is the same for all three.
struct Share : Color {
  constexpr Share(double grey = 0) : Color{grey, grey, grey} {}
  constexpr Share(const Color& color) : Color(color) {}
  constexpr bool is_grey() const { return r == g && g == b; }
  constexpr double most() const { return r > g ? (r > b ? r : b) : (g > b ? g : b); }
  friend constexpr bool operator==(const Share& a, const Share& b) {
    return a.r == b.r && a.g == b.g && a.b == b.b;
  }
};

}  // namespace zraka
