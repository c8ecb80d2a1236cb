// SPDX-License-Identifier: Apache-2.0
// The ellipsoid: a unit sphere in its own space.
#pragma once

#include <cmath>

#include "shapes/bodies/reach.hpp"
#include "shapes/bodies/sphere_uv.hpp"

namespace zraka {

template <>
struct ShapeTraits<Ellipsoid> {
  static constexpr const char* kName = "ellipsoid";
  static constexpr const char* kNouns[2][4] = {{"ellipsoid", "ellipsoid", "ellipsoid", "ellipsoid"},
                                               {"elipsoid", "elipsoid", "elipsoida", "elipsoidu"}};
  static constexpr bool kClosed = true, kComposed = false;
  static constexpr int kNumbers = 0;
  static constexpr double kCurvature = 1;

  static Bounds bounds(const Ellipsoid& s) {
    return {{s.center.x - s.radii.x, s.center.y - s.radii.y, s.center.z - s.radii.z},
            {s.center.x + s.radii.x, s.center.y + s.radii.y, s.center.z + s.radii.z}};
  }

  static Bounds bounds_under(const Ellipsoid& s, const Transform& t) {
    const Transform from_own = under(place(s).from_own, t);
    return bounds_around(from_own.origin, ball_reach(from_own));
  }

  /// |q| - 1 in units of the radii grows by at most 1 over the least of them.
  static double distance_to(const Ellipsoid& s, const Vec3& p) {
    const double x = (p.x - s.center.x) / s.radii.x, y = (p.y - s.center.y) / s.radii.y,
                 z = (p.z - s.center.z) / s.radii.z;
    return std::fabs(std::sqrt(x * x + y * y + z * z) - 1) *
           std::fmin(s.radii.x, std::fmin(s.radii.y, s.radii.z));
  }

  static const char* check(const Ellipsoid& s) {
    if (!finite(s.center)) return "its centre is not finite";
    if (!finite(s.radii) || !(s.radii.x > 0 && s.radii.y > 0 && s.radii.z > 0))
      return "its radii are not finite numbers above 0";
    return nullptr;
  }

  static Placement place(const Ellipsoid& s) {
    return {{{s.radii.x, 0, 0}, {0, s.radii.y, 0}, {0, 0, s.radii.z}, s.center}};
  }

  static BodySurface surface(const double*, const V3<double>& p) { return unit_sphere_surface(p); }
};

#ifdef ZRAKA_ISA
namespace ZRAKA_ISA {

template <class D>
struct BodyLanes<Ellipsoid, D> {
  using F = typename D::F;
  static constexpr int kMost = 2;

  /// The origin is nearest to the middle: half the chord is √(1 - |o|²).
  template <class Numbers>
  static ZRAKA_INLINE void cross(const Numbers&, const BodyRay<F>& ray, F (&at)[kMost]) {
    const F h = F(1.0) - dot(ray.origin, ray.origin);
    const auto hit = h >= F(0.0);
    const F half = sqrt(max(h, F(0.0)));
    at[0] = select(hit, -half, F(kNever));
    at[1] = select(hit, half, F(kNever));
  }

  template <class Numbers>
  static ZRAKA_INLINE V3<F> normal(const Numbers&, const V3<F>& p) {
    return p;
  }
};

}  // namespace ZRAKA_ISA
#endif

}  // namespace zraka
