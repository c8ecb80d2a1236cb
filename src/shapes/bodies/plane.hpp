// SPDX-License-Identifier: Apache-2.0
// The plane, and the half-space behind it: y = 0 and y < 0 in its own space.
#pragma once

#include <cmath>

#include "shapes/bodies/body.hpp"
#include "shapes/bodies/upright.hpp"

namespace zraka {

template <>
struct ShapeTraits<Plane> {
  static constexpr const char* kName = "plane";
  static constexpr const char* kNouns[2][4] = {{"plane", "plane", "plane", "plane"},
                                               {"ravnina", "ravninu", "ravnine", "ravnini"}};
  static constexpr bool kClosed = true, kComposed = false;
  static constexpr int kNumbers = 0;

  static Bounds bounds(const Plane&) { return Bounds::everything(); }

  static double distance_to(const Plane& s, const Vec3& p) {
    const V3<double> n = vector_of(s.normal);
    return std::fabs(dot(vector_of(p) - vector_of(s.point), n)) / std::sqrt(dot(n, n));
  }

  static const char* check(const Plane& s) {
    if (!finite(s.point)) return "its point is not finite";
    return check_axis(s.normal);
  }

  static Placement place(const Plane& s) { return {upright(s.point, s.normal, 1)}; }

  /// u and v along two axes of the plane, in units of the space that it is described in.
  static BodySurface surface(const double*, const V3<double>& p) {
    return {{0, 1, 0}, p.x, -p.z, {1, 0, 0}, {0, 0, -1}};
  }
};

#ifdef ZRAKA_ISA
namespace ZRAKA_ISA {

template <class D>
struct BodyLanes<Plane, D> {
  using F = typename D::F;
  static constexpr int kMost = 2;

  template <class Numbers>
  static ZRAKA_INLINE void cross(const Numbers&, const BodyRay<F>& ray, F (&at)[kMost]) {
    const F t = -(ray.origin.y / ray.direction.y);
    const auto down = ray.direction.y<F(0.0), up = ray.direction.y> F(0.0);
    // What goes along the plane is below it forever, or never.
    const F never(kNever), ever(-kNever);
    const auto below = ray.origin.y < F(0.0);
    at[0] = select(down, t, select(up, ever, select(below, ever, never)));
    at[1] = select(up, t, never);
  }

  template <class Numbers>
  static ZRAKA_INLINE V3<F> normal(const Numbers&, const V3<F>&) {
    return {F(0.0), F(1.0), F(0.0)};
  }
};

}  // namespace ZRAKA_ISA
#endif

}  // namespace zraka
