// SPDX-License-Identifier: Apache-2.0
// One body and what is known of it.
#pragma once

#include <utility>
#include <vector>

#include "expect_crossings.hpp"

namespace zraka::truth {

/// Of one ray, as distances.
template <class Shape>
std::vector<Real> crossed_at(const Shape& shape, const Vec3& origin, const Vec3& direction) {
  const Placed<Shape> body(shape);
  const BodyProbeRay ray{{origin.x, origin.y, origin.z}, {direction.x, direction.y, direction.z}};
  return finite_ones(crossings<Shape>(body.row, {ray}).front());
}
inline void expect_near(const std::vector<Real>& got, const std::vector<double>& want) {
  ASSERT_EQ(got.size(), want.size());
  for (std::size_t i = 0; i < got.size(); ++i) EXPECT_NEAR(double(got[i]), want[i], 1e-14);
}

/// Rays of all kinds, and rays that touch.
template <class Shape>
void expect_all_crossings(const Shape& shape) {
  Random random(4);
  ASSERT_EQ(ShapeTraits<Shape>::check(shape), nullptr);
  const Placed<Shape> body(shape);
  const auto rays = rays_at(body, ray_count(2000), random);
  const auto found = crossings<Shape>(body.row, rays);
  expect_crossings(body, rays, found);
  const auto touching = touching_rays(body, rays, found, random);
  expect_crossings(body, touching, crossings<Shape>(body.row, touching));
}

template <class Shape>
void expect_problem(const Shape& shape, const char* want) {
  EXPECT_STREQ(ShapeTraits<Shape>::check(shape), want);
}
/// At a point of a body's own space.
template <class Shape>
std::pair<double, double> uv_at(const Shape& shape, const V3<double>& p) {
  const BodySurface s = ShapeTraits<Shape>::surface(ShapeTraits<Shape>::place(shape).numbers, p);
  return {s.u, s.v};
}
inline constexpr double kNan = __builtin_nan("");

}  // namespace zraka::truth
