// SPDX-License-Identifier: Apache-2.0
#include "scene/view.hpp"

#include <algorithm>
#include <cmath>

namespace zraka {
namespace {

Vec3 scaled(const Vec3& a, double s) {
  return {a.x * s, a.y * s, a.z * s};
}
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(const Vec3& a) {
  return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}

}  // namespace

std::optional<Camera> look_at(const Vec3& eye, const Vec3& target, const Vec3& up, double fov_deg,
                              double aspect) {
  Vec3 along{target.x - eye.x, target.y - eye.y, target.z - eye.z};
  if (!(length(along) > 0)) return std::nullopt;
  along = scaled(along, 1 / length(along));
  Vec3 right = cross(along, up);
  if (!(length(right) > 0)) return std::nullopt;
  right = scaled(right, 1 / length(right));
  const double tall = 2 * std::tan(fov_deg * 3.14159265358979323846 / 360);
  // The window is 1 away, but where the sum of that and the eye's place would lose its digits.
  const double most = std::max({std::fabs(eye.x), std::fabs(eye.y), std::fabs(eye.z)});
  int exponent = 0;
  if (most > 0x1p20) std::frexp(most, &exponent);
  const double away = std::ldexp(1, exponent);
  return Camera{eye,
                {eye.x + along.x * away, eye.y + along.y * away, eye.z + along.z * away},
                scaled(right, tall * aspect * away),
                scaled(cross(right, along), tall * away)};
}

bool spans_a_plane(const Vec3& a, const Vec3& b) {
  return length(cross(a, b)) > 0;
}

}  // namespace zraka
