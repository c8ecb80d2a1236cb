// SPDX-License-Identifier: Apache-2.0
// The sphere.
#pragma once

#include <cmath>
#include <zraka/shapes.hpp>

#include "shapes/shape.hpp"
#ifdef ZRAKA_ISA
#include "math/lanes.hpp"
#endif

namespace zraka {

/// A sphere among shapes that are small beside it, a ground: its numbers also hold an anchor.
struct AnchoredSphere : Sphere {};

template <>
struct ShapeTraits<Sphere> {
  static constexpr const char* kName = "sphere";
  static constexpr const char* kNouns[2][4] = {{"sphere", "sphere", "sphere", "sphere"},
                                            {"kugla", "kuglu", "kugle", "kugli"}};
  static constexpr int kReals = 4, kHitReals = 4;  // centre, radius

  static Bounds bounds(const Sphere& s) {
    return {{s.center.x - s.radius, s.center.y - s.radius, s.center.z - s.radius},
            {s.center.x + s.radius, s.center.y + s.radius, s.center.z + s.radius}};
  }

  static double distance_to(const Sphere& s, const Vec3& p) {
    const double x = p.x - s.center.x, y = p.y - s.center.y, z = p.z - s.center.z;
    return std::fabs(std::sqrt(x * x + y * y + z * z) - s.radius);
  }

  static const char* check(const Sphere& s) {
    if (!finite(s.center)) return "its centre is not finite";
    if (!(s.radius > 0) || !finite(s.radius)) return "its radius is not a finite number above 0";
    return nullptr;
  }

  static void freeze(const Sphere& s, const Frame& frame, double* out) {
    const Vec3 c = frame.point(s.center);
    out[0] = c.x, out[1] = c.y, out[2] = c.z;
    out[3] = frame.length(s.radius);
  }

  static Bounds frozen_bounds(const double* s) { return bounds({{s[0], s[1], s[2]}, s[3]}); }
};

template <>
struct ShapeTraits<AnchoredSphere> : ShapeTraits<Sphere> {
  /// Centre, radius, and the anchor: the point of the surface that is nearest to the engine's
  /// origin.
  static constexpr int kReals = 7, kHitReals = 7;

  static void freeze(const Sphere& s, const Frame& frame, double* out) {
    ShapeTraits<Sphere>::freeze(s, frame, out);
    const double away = std::sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
    const double to_anchor = away > 0 ? 1 - out[3] / away : 0;
    for (int k = 0; k < 3; ++k) out[4 + k] = away > 0 ? out[k] * to_anchor : out[k];
    if (!(away > 0)) out[6] += out[3];
  }
};

#ifdef ZRAKA_ISA
namespace ZRAKA_ISA {

/// What spheres of both kinds share; the power of a point is |p - centre|² - r².
template <class L, class PointPower>
struct SphereLanes {
  using F = typename L::F;

  /// From inside, the far intersection (sheet 3.3). The quadratic is that of Haines, Günther and
  /// Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems (2019)
  /// ch. 7: the discriminant from the distance between centre and ray, the roots without
  /// cancellation.
  static ZRAKA_INLINE F intersect(const F* s, const V3<F>& origin, const V3<F>& direction) {
    const V3<F> from_center{origin.x - s[0], origin.y - s[1], origin.z - s[2]};
    const F b = -dot(from_center, direction);
    const V3<F> nearest = from_center + direction * b;
    const F discriminant = s[3] * s[3] - dot(nearest, nearest);
    if (!any(discriminant >= F(0.0f))) return F(-1.0f);
    const F root = sqrt(max(discriminant, F(0.0f)));
    const F c = PointPower::of_point(s, origin);
    const auto ahead = b >= F(0.0f);
    const F q = b + select(ahead, root, -root);  // the root of larger magnitude; c/q is the other
    const auto take_q = both(c < F(0.0f), ahead);
    return select(discriminant >= F(0.0f), select(take_q, q, c / q), F(-1.0f));
  }

  static ZRAKA_INLINE SurfacePoint<L> surface(const F* s, const V3<F>& origin,
                                              const V3<F>& direction, const V3<F>& point) {
    // A Newton step along the ray takes the point to the surface; where the ray grazes, along the
    // normal.
    const V3<F> near_center{point.x - s[0], point.y - s[1], point.z - s[2]};
    const F power = PointPower::of_point(s, point);
    const F slope = dot(near_center, direction);
    const auto steep = slope * slope > s[3] * s[3] * F(0x1p-12f);
    const F along = select(steep, power / (slope + slope), F(0.0f));
    const V3<F> from_center = near_center - direction * along;
    const V3<F> normal = from_center * (F(1.0f) / sqrt(dot(from_center, from_center)));
    const F below = select(steep, F(0.0f), power / (s[3] + s[3]));
    const V3<F> on_surface = (point - direction * along) - normal * below;
    // 16 half units in the last place of the sum of what is rounded are over twice what the
    // roundings here and in the next ray's quadratic add up to.
    const F magnitude = largest(on_surface) + PointPower::magnitude(s, point);
    // Where the ray began tells the sides apart also where it only grazes, unlike the sign of N·V.
    return {on_surface, normal, magnitude * F(kOffset), PointPower::of_point(s, origin) < F(0.0f)};
  }

  static ZRAKA_INLINE F largest(const V3<F>& v) { return max(abs(v.x), max(abs(v.y), abs(v.z))); }

 private:
  static constexpr float kOffset = sizeof(typename L::Real) == 4 ? 0x1p-20f : 0x1p-49f;
};

template <class L>
struct PlainPointPower {
  using F = typename L::F;
  static ZRAKA_INLINE F of_point(const F* s, const V3<F>& p) {
    const V3<F> from_center{p.x - s[0], p.y - s[1], p.z - s[2]};
    return dot(from_center, from_center) - s[3] * s[3];
  }
  /// Distances to the centre.
  static ZRAKA_INLINE F magnitude(const F* s, const V3<F>&) { return s[3] + s[3]; }
};

/// From the anchor a as g·(g + 2w) with g = p - a, w = a - centre: for a sphere that is large
/// beside the scene the squares would leave no digits for the distance from its surface.
template <class L>
struct AnchoredPointPower {
  using F = typename L::F;
  static ZRAKA_INLINE F of_point(const F* s, const V3<F>& p) {
    const V3<F> g{p.x - s[4], p.y - s[5], p.z - s[6]};
    const V3<F> w{s[4] - s[0], s[5] - s[1], s[6] - s[2]};
    return dot(g, V3<F>{g.x + (w.x + w.x), g.y + (w.y + w.y), g.z + (w.z + w.z)});
  }
  /// Distances to the anchor; in the anchor itself, where nothing is rounded, next to nothing: the
  /// next ray must still begin on its side.
  static ZRAKA_INLINE F magnitude(const F* s, const V3<F>& p) {
    const V3<F> g{p.x - s[4], p.y - s[5], p.z - s[6]};
    return max(SphereLanes<L, AnchoredPointPower>::largest(g), F(0x1p-60f));
  }
};

template <class L>
struct ShapeLanes<Sphere, L> : SphereLanes<L, PlainPointPower<L>> {
  using F = typename L::F;

  /// What intersect() finds is known without its root and its quotient where the discriminant,
  /// here b² - c of the sphere's power c, is farther from 0 than either way to compute it errs: by
  /// 64 half units of its largest parts, which is more than all of their roundings together. From
  /// outside, the near intersection is at c/q with q > b, so nearer than b; behind the origin there
  /// is none. What this cannot tell intersect() does.
  static ZRAKA_INLINE typename L::M blocks(const F* s, const V3<F>& origin,
                                           const V3<F>& direction, F limit) {
    const V3<F> to_center{s[0] - origin.x, s[1] - origin.y, s[2] - origin.z};
    const F radius_square = s[3] * s[3];
    const F b = dot(to_center, direction), square = dot(to_center, to_center);
    const F c = square - radius_square;
    const F discriminant = roughly_mul_sub(b, b, c);
    const F margin = (square + radius_square) * F(0x1p-18f);
    const auto outside = c > F(0.0f);
    const auto hit = both(both(discriminant > margin, outside), both(b > F(0.0f), b < limit));
    const auto missed = either(discriminant < -margin, both(b < F(0.0f), outside));
    const auto unknown = but_not(but_not(limit > F(0.0f), missed), hit);
    if (!any(unknown)) return hit;
    const F t = ShapeLanes::intersect(s, origin, direction);
    return either(hit, both(unknown, both(t > F(0.0f), t < limit)));
  }
};
template <class L>
struct ShapeLanes<AnchoredSphere, L> : SphereLanes<L, AnchoredPointPower<L>> {};

}  // namespace ZRAKA_ISA
#endif

}  // namespace zraka
