// SPDX-License-Identifier: Apache-2.0
// A camera's axes, for the kinds that have no window.
#pragma once

#include <algorithm>
#include <cmath>
#include <zraka/cameras.hpp>

#include "math/vec.hpp"

namespace zraka {

inline V3<double> as_vector(const Vec3& v) {
  return {v.x, v.y, v.z};
}

inline V3<double> vector_between(const Vec3& from, const Vec3& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

/// Of any length whose numbers are finite; 0 and NaN stay what they are.
inline V3<double> unit_vector(const V3<double>& v) {
  const double most = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  if (!(most > 0)) return v;
  const V3<double> small = {v.x / most, v.y / most, v.z / most};
  return small * (1 / std::sqrt(dot(small, small)));
}

/// Unit vectors, perpendicular to each other; mirrored where the window is. `up` is as near to the
/// window's as that allows, and right after that.
struct ViewAxes {
  V3<double> ahead, right, up;

  explicit ViewAxes(const Camera& camera)
      : ahead(unit_vector(vector_between(camera.eye, camera.window_center))) {
    const V3<double> u = unit_vector(as_vector(camera.window_up));
    up = unit_vector(u - ahead * dot(u, ahead));
    const V3<double> r = unit_vector(as_vector(camera.window_right));
    right = cross(ahead, up);
    if (dot(right, r) < 0) right = right * -1.0;
  }
  /// False where the camera looks nowhere, or up is ahead.
  bool good() const {
    return dot(ahead, ahead) > 0.5 && dot(up, up) > 0.5 && std::fabs(dot(ahead, up)) < 1e-6;
  }
};

}  // namespace zraka
