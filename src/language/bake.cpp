// SPDX-License-Identifier: Apache-2.0
#include "language/bake.hpp"

#include <algorithm>
#include <cmath>

#include "scene/bounds_of.hpp"

namespace zraka::language {
namespace {

double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// By which a transform that keeps balls round changes lengths.
double scale_of(const Transform& t) {
  double largest = 0, squares = 0;
  for (const Vec3& v : {t.along_x, t.along_y, t.along_z})
    largest = std::max({largest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  for (const Vec3& v : {t.along_x, t.along_y, t.along_z}) {
    const Vec3 small{v.x / largest, v.y / largest, v.z / largest};
    squares += dot(small, small);
  }
  return largest * std::sqrt(squares / 3);
}

/// The inverse, by a factor: how long normals are does not matter, and so they keep their digits.
Transform inverse_of_size_1(const Transform& t) {
  Transform back = inverse(t).value_or(Transform{});
  double largest = 0;
  for (const Vec3& v : {back.along_x, back.along_y, back.along_z})
    largest = std::max({largest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  for (Vec3* const v : {&back.along_x, &back.along_y, &back.along_z})
    *v = {v->x / largest, v->y / largest, v->z / largest};
  return back;
}

}  // namespace

Sphere baked(const Sphere& s, const Transform& t) {
  return {moved(s.center, t), s.radius * scale_of(t)};
}

Cone baked(const Cone& c, const Transform& t) {
  const double scale = scale_of(t);
  return {moved(c.base, t), c.base_radius * scale, moved(c.apex, t), c.apex_radius * scale};
}

Triangle baked(const Triangle& s, const Transform& t) {
  return {moved(s.a, t), moved(s.b, t), moved(s.c, t)};
}

SmoothTriangle baked(const SmoothTriangle& s, const Transform& t) {
  const Transform back = inverse_of_size_1(t);
  const auto normal = [&](const Vec3& n) {
    return Vec3{dot(back.along_x, n), dot(back.along_y, n), dot(back.along_z, n)};
  };
  return {moved(s.a, t),      moved(s.b, t),      moved(s.c, t),
          normal(s.normal_a), normal(s.normal_b), normal(s.normal_c)};
}

}  // namespace zraka::language
