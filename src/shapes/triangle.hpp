// SPDX-License-Identifier: Apache-2.0
// The flat triangle.
#pragma once

#include <zraka/shapes.hpp>

#include "shapes/shape.hpp"
#ifdef ZRAKA_ISA
#include "math/lanes.hpp"
#endif

namespace zraka {

inline void put(const Vec3& v, double* out) {
  out[0] = v.x, out[1] = v.y, out[2] = v.z;
}

template <>
struct ShapeTraits<Triangle> {
  static constexpr const char* kName = "triangle";
  static constexpr int kReals = 9;  // corners

  static Box bounds(const Triangle& s) {
    Box box;
    for (const Vec3& corner : {s.a, s.b, s.c}) box.include({corner, corner});
    return box;
  }

  static const char* check(const Triangle& s) {
    return finite(s.a) && finite(s.b) && finite(s.c) ? nullptr : "a corner is not finite";
  }

  static void freeze(const Triangle& s, const Frame& frame, double (&out)[kReals]) {
    put(frame.point(s.a), out);
    put(frame.point(s.b), out + 3);
    put(frame.point(s.c), out + 6);
  }
};

#ifdef ZRAKA_ISA
namespace ZRAKA_ISA {

/// What triangles of all kinds share: corners in s[0…8].
template <class L>
struct TriangleLanes {
  using F = typename L::F;

  /// Corners seen from a point, edges, and the flat normal, not of unit length.
  struct Seen {
    V3<F> a, b, c, normal;
    ZRAKA_INLINE Seen(const F* s, const V3<F>& from)
        : a{s[0] - from.x, s[1] - from.y, s[2] - from.z},
          b{s[3] - from.x, s[4] - from.y, s[5] - from.z},
          c{s[6] - from.x, s[7] - from.y, s[8] - from.z},
          normal(cross(b - a, c - a)) {}
  };

  /// Volumes of the parallelepipeds that the direction spans with each edge, after Davidovič,
  /// Engelhardt, Georgiev, Slusallek and Dachsbacher, "3D rasterization: a bridge between
  /// rasterization and ray casting" (2012). The one of an edge is made of its two ends in a way
  /// that only changes sign with their order, so neighbours agree on which of them a ray meets, and
  /// none slips through between.
  static ZRAKA_INLINE F edge(const V3<F>& p, const V3<F>& q, const V3<F>& direction) {
    return dot(cross(q - p, p + q), direction);
  }

  static ZRAKA_INLINE F intersect(const F* s, const V3<F>& origin, const V3<F>& direction) {
    const Seen seen(s, origin);
    const F u = edge(seen.b, seen.c, direction), v = edge(seen.c, seen.a, direction),
            w = edge(seen.a, seen.b, direction);
    const auto inside = both(min(u, min(v, w)) >= F(0.0f), F(0.0f) <= max(u, max(v, w)));
    const auto outside = both(max(u, max(v, w)) <= F(0.0f), F(0.0f) >= min(u, min(v, w)));
    const auto met = either(inside, outside);
    if (!any(met)) return F(-1.0f);
    const F slope = dot(seen.normal, direction);
    const F t = dot(seen.normal, seen.a) / slope;
    // Seen edge-on all of this is noise; what counts as a hit must lie within the triangle's
    // bounds, for only then does every way through the hierarchy find it.
    const F margin = hit_margin<L>(origin);
    const auto within = [&](const F& p, const F& a, const F& b, const F& c) {
      return both(p >= min(a, min(b, c)) - margin, p <= max(a, max(b, c)) + margin);
    };
    const auto bounded = both(within(direction.x * t, seen.a.x, seen.b.x, seen.c.x),
                              both(within(direction.y * t, seen.a.y, seen.b.y, seen.c.y),
                                   within(direction.z * t, seen.a.z, seen.b.z, seen.c.z)));
    return select(both(met, bounded), t, F(-1.0f));
  }

  /// `point` along the ray onto the plane, and the offset that clears it; the normal is not set.
  static ZRAKA_INLINE V3<F> on_plane(const Seen& seen_from_point, const V3<F>& direction,
                                     const V3<F>& point) {
    const F slope = dot(seen_from_point.normal, direction);
    const F along = dot(seen_from_point.normal, seen_from_point.a) / slope;
    const auto steep =
        slope * slope > dot(seen_from_point.normal, seen_from_point.normal) * F(0x1p-12f);
    return point + direction * select(steep, along, F(0.0f));
  }

  static ZRAKA_INLINE F offset_at(const Seen& seen, const V3<F>& point) {
    const auto largest = [](const V3<F>& v) { return max(abs(v.x), max(abs(v.y), abs(v.z))); };
    const F reach = max(largest(seen.a), max(largest(seen.b), largest(seen.c)));
    return (largest(point) + reach) * F(sizeof(typename L::Real) == 4 ? 0x1p-20f : 0x1p-49f);
  }
};

template <class L>
struct ShapeLanes<Triangle, L> {
  using F = typename L::F;

  static ZRAKA_INLINE F intersect(const F (&s)[9], const V3<F>& origin, const V3<F>& direction) {
    return TriangleLanes<L>::intersect(s, origin, direction);
  }

  static ZRAKA_INLINE SurfacePoint<L> surface(const F (&s)[9], const V3<F>&, const V3<F>& direction,
                                              const V3<F>& point) {
    const typename TriangleLanes<L>::Seen seen(s, point);
    const V3<F> on_surface = TriangleLanes<L>::on_plane(seen, direction, point);
    const V3<F> normal = seen.normal * (F(1.0f) / sqrt(dot(seen.normal, seen.normal)));
    return {on_surface, normal, TriangleLanes<L>::offset_at(seen, on_surface),
            dot(normal, direction) > F(0.0f)};
  }
};

}  // namespace ZRAKA_ISA
#endif

}  // namespace zraka
