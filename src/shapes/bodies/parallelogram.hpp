// SPDX-License-Identifier: Apache-2.0
// The parallelogram: z = 0 between -1 and 1 along x and y in its own space.
#pragma once

#include <algorithm>
#include <cmath>

#include "shapes/bodies/reach.hpp"

namespace zraka {

template <>
struct ShapeTraits<Parallelogram> {
  static constexpr const char* kName = "parallelogram";
  static constexpr const char* kNouns[2][4] = {
      {"parallelogram", "parallelogram", "parallelogram", "parallelogram"},
      {"paralelogram", "paralelogram", "paralelograma", "paralelogramu"}};
  static constexpr bool kClosed = false, kComposed = false;
  static constexpr int kNumbers = 0;

  static Bounds bounds(const Parallelogram& s) { return bounds_under(s, {}); }

  static Bounds bounds_under(const Parallelogram& s, const Transform& t) {
    const Vec3 u = vector_under(half(s.edge_u), t), v = vector_under(half(s.edge_v), t);
    return bounds_around(point_under(middle_of(s), t),
                         {std::fabs(u.x) + std::fabs(v.x), std::fabs(u.y) + std::fabs(v.y),
                          std::fabs(u.z) + std::fabs(v.z)});
  }

  /// Above or below it from its plane, elsewhere from its edges.
  static double distance_to(const Parallelogram& s, const Vec3& p) {
    const V3<double> u = vector_of(s.edge_u), v = vector_of(s.edge_v), up = unit_normal(s);
    const V3<double> q = vector_of(p) - vector_of(s.corner);
    const V3<double> across_u = cross(up, u), across_v = cross(v, up);
    const double along_u = dot(q, across_v) / dot(u, across_v),
                 along_v = dot(q, across_u) / dot(v, across_u);
    if (along_u >= 0 && along_u <= 1 && along_v >= 0 && along_v <= 1) return std::fabs(dot(q, up));
    return std::min({from_edge(q, u), from_edge(q - v, u), from_edge(q, v), from_edge(q - u, v)});
  }

  static const char* check(const Parallelogram& s) {
    if (!finite(s.corner)) return "its corner is not finite";
    if (!finite(s.edge_u) || !finite(s.edge_v)) return "an edge is not finite";
    const double u = length_of(s.edge_u), v = length_of(s.edge_v);
    if (!(u > 0 && v > 0)) return "an edge is 0";
    // Of edges that differ by rounding alone, the plane is anywhere.
    const V3<double> across = cross(vector_of(s.edge_u) * (1 / u), vector_of(s.edge_v) * (1 / v));
    if (!(safe_length(across.x, across.y, across.z) > 0x1p-40)) return "its edges are parallel";
    return nullptr;
  }

  static Placement place(const Parallelogram& s) {
    const double size = std::max(length_of(s.edge_u), length_of(s.edge_v)) / 2;
    return {{half(s.edge_u), half(s.edge_v), vec3_of(unit_normal(s) * size), middle_of(s)}};
  }

  static BodySurface surface(const double*, const V3<double>& p) {
    const auto share = [](double x) { return std::fmin(1, std::fmax(0, 0.5 + x / 2)); };
    return {{0, 0, 1}, share(p.x), share(p.y), {2, 0, 0}, {0, 2, 0}};
  }

 private:
  static Vec3 half(const Vec3& v) { return {v.x / 2, v.y / 2, v.z / 2}; }
  static double length_of(const Vec3& v) { return safe_length(v.x, v.y, v.z); }
  static Vec3 middle_of(const Parallelogram& s) {
    const Vec3 u = half(s.edge_u), v = half(s.edge_v);
    return {s.corner.x + u.x + v.x, s.corner.y + u.y + v.y, s.corner.z + u.z + v.z};
  }
  static V3<double> unit_normal(const Parallelogram& s) {
    const V3<double> n = cross(vector_of(s.edge_u) * (1 / length_of(s.edge_u)),
                               vector_of(s.edge_v) * (1 / length_of(s.edge_v)));
    return n * (1 / safe_length(n.x, n.y, n.z));
  }
  static double from_edge(const V3<double>& q, const V3<double>& edge) {
    const double share = std::fmin(1, std::fmax(0, dot(q, edge) / dot(edge, edge)));
    const V3<double> away = q - edge * share;
    return safe_length(away.x, away.y, away.z);
  }
};

#ifdef ZRAKA_ISA
namespace ZRAKA_ISA {

template <class D>
struct BodyLanes<Parallelogram, D> {
  using F = typename D::F;
  static constexpr int kMost = 1;

  /// Along the plane, t is infinite or no number, and so nothing is within.
  template <class Numbers>
  static ZRAKA_INLINE void cross(const Numbers&, const BodyRay<F>& ray, F (&at)[kMost]) {
    const V3<F>&o = ray.origin, &d = ray.direction;
    const F t = -(o.z / d.z);
    const auto within = both(abs(o.x + t * d.x) <= F(1.0), abs(o.y + t * d.y) <= F(1.0));
    at[0] = select(within, t, F(kNever));
  }

  template <class Numbers>
  static ZRAKA_INLINE V3<F> normal(const Numbers&, const V3<F>&) {
    return {F(0.0), F(0.0), F(1.0)};
  }
};

}  // namespace ZRAKA_ISA
#endif

}  // namespace zraka
