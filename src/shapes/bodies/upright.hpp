// SPDX-License-Identifier: Apache-2.0
// Bodies that stand on an axis: the axis is y in their own space.
#pragma once

#include <cmath>

#include "shapes/bodies/body.hpp"

namespace zraka {

/// What is wrong with an axis, or nullptr.
inline const char* check_axis(const Vec3& axis) {
  if (!finite(axis)) return "its normal is not finite";
  const double largest =
      std::fmax(std::fabs(axis.x), std::fmax(std::fabs(axis.y), std::fabs(axis.z)));
  return largest > 0 ? nullptr : "its normal is 0";
}

/// Right-handed unit axes whose y points along an axis; x and z where the axis is y, so that what
/// stands upright keeps its own.
struct AxisFrame {
  V3<double> x, y, z;
};
inline AxisFrame axis_frame(const Vec3& axis) {
  // Scaled first, for squares of what is very large or small.
  const double largest =
      std::fmax(std::fabs(axis.x), std::fmax(std::fabs(axis.y), std::fabs(axis.z)));
  V3<double> y = vector_of(axis) * (1 / largest);
  y = y * (1 / std::sqrt(dot(y, y)));
  // x is the world's x turned as y is: for an axis near -y, by way of z.
  V3<double> z = cross(V3<double>{1, 0, 0}, y);
  if (dot(z, z) < 1e-4) z = cross(V3<double>{0, 0, 1}, y);  // an axis along x
  z = z * (1 / std::sqrt(dot(z, z)));
  return {cross(y, z), y, z};
}

/// Gives a surface that has no u and v any two tangents, unmirrored.
inline void put_any_tangents(BodySurface& s) {
  const AxisFrame frame = axis_frame(vec3_of(s.normal));
  s.along_u = frame.z;
  s.along_v = frame.x;
}

/// The transform of what stands on an axis at a point, of so many units a unit.
inline Transform upright(const Vec3& point, const Vec3& axis, double scale) {
  const AxisFrame f = axis_frame(axis);
  return {vec3_of(f.x * scale), vec3_of(f.y * scale), vec3_of(f.z * scale), point};
}

}  // namespace zraka
