// SPDX-License-Identifier: Apache-2.0
// Boxes around the images of balls and circles under a transform: tighter than around the image of
// their box.
#pragma once

#include <cmath>

#include "shapes/bodies/body.hpp"

namespace zraka {

inline Vec3 vector_under(const Vec3& v, const Transform& t) {
  return vec3_of(vector_of(t.along_x) * v.x + vector_of(t.along_y) * v.y +
                 vector_of(t.along_z) * v.z);
}
inline Vec3 point_under(const Vec3& p, const Transform& t) {
  return vec3_of(vector_of(vector_under(p, t)) + vector_of(t.origin));
}
/// From a body's own space to where the transform leads.
inline Transform under(const Transform& from_own, const Transform& t) {
  return {vector_under(from_own.along_x, t), vector_under(from_own.along_y, t),
          vector_under(from_own.along_z, t), point_under(from_own.origin, t)};
}

/// The length of a vector whose squares may leave the range of doubles.
inline double safe_length(double x, double y, double z) {
  const double largest = std::fmax(std::fabs(x), std::fmax(std::fabs(y), std::fabs(z)));
  if (!(largest > 0)) return 0;
  x /= largest, y /= largest, z /= largest;
  return largest * std::sqrt(x * x + y * y + z * z);
}

/// How far the image of the unit ball reaches along each axis: as far as the longest row of the
/// map.
inline Vec3 ball_reach(const Transform& t) {
  const auto reach = [&](double Vec3::*axis) {
    return safe_length(t.along_x.*axis, t.along_y.*axis, t.along_z.*axis);
  };
  return {reach(&Vec3::x), reach(&Vec3::y), reach(&Vec3::z)};
}
/// Of the unit circle round y.
inline Vec3 circle_reach(const Transform& t) {
  return ball_reach({t.along_x, {}, t.along_z, {}});
}

/// Around what reaches so far, so many times, from a point.
inline Bounds bounds_around(const Vec3& p, const Vec3& reach, double times = 1) {
  const Vec3 r = vec3_of(vector_of(reach) * times);
  return {{p.x - r.x, p.y - r.y, p.z - r.z}, {p.x + r.x, p.y + r.y, p.z + r.z}};
}

}  // namespace zraka
