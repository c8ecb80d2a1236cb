// SPDX-License-Identifier: Apache-2.0
// Longitude and latitude of a unit sphere: a picture wrapped round it stands upright and
// unmirrored, its middle towards +z.
#pragma once

#include "math/elementary.hpp"
#include "shapes/bodies/body.hpp"

namespace zraka {

/// u = 0.5 + atan2(x, z)/2π, v = 0.5 + asin(y)/π of the direction of a point.
inline BodySurface unit_sphere_surface(const V3<double>& p) {
  constexpr double kPi = 3.14159265358979323846;
  const double length = std::sqrt(dot(p, p));
  const double height = std::fmin(1.0, std::fmax(-1.0, p.y / length));
  const double around = std::sqrt(p.x * p.x + p.z * p.z) / length;
  BodySurface s{p};
  s.u = 0.5 + elementary::atan2(p.x, p.z) / (2 * kPi);
  s.v = 0.5 + elementary::atan2(height, around) / kPi;
  // Along the circle of latitude, and along the meridian to the north.
  s.along_u = {2 * kPi * p.z, 0, -2 * kPi * p.x};
  const double share = around > 0 ? height / around : 0;
  s.v_ends = true;
  s.along_v = {-kPi * p.x * share, kPi * around * length, -kPi * p.z * share};
  return s;
}

}  // namespace zraka
