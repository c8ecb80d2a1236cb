// SPDX-License-Identifier: Apache-2.0
// Arithmetic of scenes' vectors and colours, for readers and writers.
#pragma once

#include <cmath>
#include <zraka/values.hpp>

namespace zraka {

inline Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator*(const Vec3& a, double s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline bool is_zero(const Vec3& a) {
  return a == Vec3{};
}
inline double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vec3& a) {
  return std::hypot(a.x, a.y, a.z);
}
/// 0 stays 0.
inline Vec3 unit(const Vec3& a) {
  const double most = std::fmax(std::fabs(a.x), std::fmax(std::fabs(a.y), std::fabs(a.z)));
  if (!(most > 0)) return {};
  const Vec3 b = a * (1 / most);
  return b * (1 / std::sqrt(dot(b, b)));
}
/// Of unit length, at right angles to a vector that is not 0.
inline Vec3 any_across(const Vec3& a) {
  const Vec3 n = unit(a);
  return unit(std::fabs(n.y) < 0.9 ? cross(Vec3{0, 1, 0}, n) : cross(Vec3{0, 0, 1}, n));
}
inline Color operator*(const Color& c, double s) {
  return {c.r * s, c.g * s, c.b * s};
}
inline Color operator*(const Color& a, const Color& b) {
  return {a.r * b.r, a.g * b.g, a.b * b.b};
}
inline double mean(const Color& c) {
  return c.r == c.g && c.g == c.b ? c.r : (c.r + c.g + c.b) / 3;
}

}  // namespace zraka
