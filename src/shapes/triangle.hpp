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
  static constexpr const char* kNouns[2][4] = {{"triangle", "triangle", "triangle", "triangle"},
                                            {"trokut", "trokut", "trokuta", "trokutu"}};
  static constexpr int kReals = 9, kHitReals = 9;  // corners

  static Bounds bounds(const Triangle& s) {
    Bounds box;
    for (const Vec3& corner : {s.a, s.b, s.c}) box.include({corner, corner});
    return box;
  }

  /// From its box or from its plane, whichever is farther.
  static double distance_to(const Triangle& s, const Vec3& p) {
    const V3<double> a{s.a.x, s.a.y, s.a.z};
    const V3<double> normal =
        cross(V3<double>{s.b.x, s.b.y, s.b.z} - a, V3<double>{s.c.x, s.c.y, s.c.z} - a);
    const double away =
        std::fabs(dot(V3<double>{p.x, p.y, p.z} - a, normal)) / std::sqrt(dot(normal, normal));
    return std::fmax(bounds(s).distance_to(p), away);  // fmax: a line has no plane
  }

  static Bounds frozen_bounds(const double* s) {
    return bounds({{s[0], s[1], s[2]}, {s[3], s[4], s[5]}, {s[6], s[7], s[8]}});
  }

  static const char* check(const Triangle& s) {
    return finite(s.a) && finite(s.b) && finite(s.c) ? nullptr : "a corner is not finite";
  }

  static void freeze(const Triangle& s, const Frame& frame, double* out) {
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

  /// Corners relative to the origin are sheared along the ray into a plane across the axis that it
  /// follows most, after Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1)
  /// (2013), here scaled so that nothing is divided. A corner comes out the same for all triangles
  /// that it belongs to, and an edge function only changes sign with the order of its ends: so
  /// neighbours agree on which of them a ray hits, and none slips through between.
  static ZRAKA_INLINE F intersect(const F* s, const V3<F>& origin, const V3<F>& direction) {
    const F x = abs(direction.x), y = abs(direction.y), z = abs(direction.z);
    const auto along_z = both(z >= x, z >= y);
    const auto along_y = but_not(y >= x, along_z);
    const auto part = [](const F* p) { return V3<F>{p[0], p[1], p[2]}; };
    const V3<F> a = part(s) - origin, b = part(s + 3) - origin, c = part(s + 6) - origin;
    // Axes in a circle, the one that the ray follows last.
    const auto turn_z = [](const V3<F>& v) { return v; };
    const auto turn_y = [](const V3<F>& v) { return V3<F>{v.z, v.x, v.y}; };
    const auto turn_x = [](const V3<F>& v) { return V3<F>{v.y, v.z, v.x}; };
    if (all(along_z)) return intersect_turned(a, b, c, direction, turn_z, origin);
    if (all(along_y)) return intersect_turned(a, b, c, direction, turn_y, origin);
    if (!any(either(along_z, along_y))) return intersect_turned(a, b, c, direction, turn_x, origin);
    const auto turn_each = [&](const V3<F>& v) {
      return V3<F>{select(along_z, v.x, select(along_y, v.z, v.y)),
                   select(along_z, v.y, select(along_y, v.x, v.z)),
                   select(along_z, v.z, select(along_y, v.y, v.x))};
    };
    return intersect_turned(a, b, c, direction, turn_each, origin);
  }

  template <class Turn>
  static ZRAKA_INLINE F intersect_turned(const V3<F>& seen_a, const V3<F>& seen_b,
                                         const V3<F>& seen_c, const V3<F>& direction,
                                         const Turn& turn, const V3<F>& origin) {
    const V3<F> a = turn(seen_a), b = turn(seen_b), c = turn(seen_c), d = turn(direction);
    const F ax = a.x * d.z - a.z * d.x, ay = a.y * d.z - a.z * d.y;
    const F bx = b.x * d.z - b.z * d.x, by = b.y * d.z - b.z * d.y;
    const F cx = c.x * d.z - c.z * d.x, cy = c.y * d.z - c.z * d.y;
    const F u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
    const auto inside = either(min(u, min(v, w)) >= F(0.0f), max(u, max(v, w)) <= F(0.0f));
    if (!any(inside)) return F(-1.0f);
    const F above = u * a.z + v * b.z + w * c.z, below = (u + v + w) * d.z;
    // Rays that start on a face, as shadow rays do, have its plane behind them.
    const auto ahead =
        either(both(above > F(0.0f), below > F(0.0f)), both(above < F(0.0f), below < F(0.0f)));
    if (!any(both(inside, ahead))) return F(-1.0f);
    const F t = above / below;
    // Seen edge-on all of this is noise; what counts as a hit must lie within the triangle's
    // bounds, for only then does every way through the hierarchy find it.
    const F margin = hit_margin<L>(origin);
    const auto within = [&](const F& p, const F& one, const F& two, const F& three) {
      return both(p >= min(one, min(two, three)) - margin, p <= max(one, max(two, three)) + margin);
    };
    const auto bounded = both(within(direction.x * t, seen_a.x, seen_b.x, seen_c.x),
                              both(within(direction.y * t, seen_a.y, seen_b.y, seen_c.y),
                                   within(direction.z * t, seen_a.z, seen_b.z, seen_c.z)));
    return select(both(inside, bounded), t, F(-1.0f));
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
