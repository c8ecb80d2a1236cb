// SPDX-License-Identifier: Apache-2.0
// The sphere.
#pragma once

#include <zraka/shapes.hpp>

#include "shapes/shape.hpp"
#ifdef ZRAKA_ISA
#include "math/lanes.hpp"
#endif

namespace zraka {

template <>
struct ShapeTraits<Sphere> {
  static constexpr const char* kName = "sphere";
  static constexpr int kReals = 4;  // centre x, y, z; radius

  static Box bounds(const Sphere& s) {
    return {{s.center.x - s.radius, s.center.y - s.radius, s.center.z - s.radius},
            {s.center.x + s.radius, s.center.y + s.radius, s.center.z + s.radius}};
  }

  static const char* check(const Sphere& s) {
    if (!finite(s.center)) return "its centre is not finite";
    if (!(s.radius > 0) || !finite(s.radius)) return "its radius is not a finite number above 0";
    return nullptr;
  }

  static void freeze(const Sphere& s, const Frame& frame, double (&out)[kReals]) {
    const Vec3 center = frame.point(s.center);
    out[0] = center.x;
    out[1] = center.y;
    out[2] = center.z;
    out[3] = frame.length(s.radius);
  }
};

#ifdef ZRAKA_ISA
namespace ZRAKA_ISA {

template <class L>
struct ShapeLanes<Sphere, L> {
  using F = typename L::F;

  /// From inside, the far intersection (sheet 3.3). The quadratic is that of Haines, Günther and
  /// Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems (2019)
  /// ch. 7: the discriminant from the distance between centre and ray, the roots without
  /// cancellation.
  static ZRAKA_INLINE F intersect(const F (&s)[4], const V3<F>& origin, const V3<F>& direction) {
    const V3<F> from_center{origin.x - s[0], origin.y - s[1], origin.z - s[2]};
    const F b = -dot(from_center, direction);
    const V3<F> nearest = from_center + direction * b;
    const F r2 = s[3] * s[3];
    const F discriminant = r2 - dot(nearest, nearest);
    if (!any(discriminant >= F(0.0f))) return F(-1.0f);
    const F root = sqrt(max(discriminant, F(0.0f)));
    const F c = dot(from_center, from_center) - r2;
    const auto ahead = b >= F(0.0f);
    const F q = b + select(ahead, root, -root);  // the root of larger magnitude; c/q is the other
    const auto take_q = both(c < F(0.0f), ahead);
    return select(discriminant >= F(0.0f), select(take_q, q, c / q), F(-1.0f));
  }

  static ZRAKA_INLINE SurfacePoint<L> surface(const F (&s)[4], const V3<F>& origin, const V3<F>& point) {
    const V3<F> center{s[0], s[1], s[2]};
    const V3<F> from_center = point - center;
    const V3<F> normal = from_center * (F(1.0f) / sqrt(dot(from_center, from_center)));
    // The point is rounded at the magnitude of its coordinates, the normal and the next ray's quadratic at that
    // of the radius; 16 half units in the last place of their sum is over twice what these add up to.
    const F magnitude = max(abs(s[0]), max(abs(s[1]), abs(s[2]))) + s[3];
    // Where the ray began tells the sides apart also where it only grazes, unlike the sign of N·V.
    const V3<F> began = origin - center;
    return {center + normal * s[3], normal, magnitude * F(kOffset), dot(began, began) < s[3] * s[3]};
  }

 private:
  static constexpr float kOffset = sizeof(typename L::Real) == 4 ? 0x1p-20f : 0x1p-49f;
};

}  // namespace ZRAKA_ISA
#endif

}  // namespace zraka
