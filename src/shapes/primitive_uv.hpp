// SPDX-License-Identifier: Apache-2.0
// u and v of primitives, which stand in the world: in the engine's frame, of their frozen numbers.
#pragma once

#include "shapes/bodies/sphere_uv.hpp"
#include "shapes/bodies/upright.hpp"
#include "shapes/shapes.hpp"

namespace zraka {

/// What a primitive's u and v depend on besides its numbers.
struct UvContext {
  /// From the engine's frame into the shape's own space, directions only: three columns.
  V3<double> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const CornerUvs* uvs = nullptr;         ///< of this triangle
  const double* whole_corners = nullptr;  ///< of the triangle that this one is a piece of

  V3<double> own(const V3<double>& v) const { return x * v.x + y * v.y + z * v.z; }
};

/// A body's surface is in its own space, a primitive's in the engine's frame: there the normal is
/// known.
inline BodySurface uv_of(const Sphere*, const double* s, const V3<double>& p, const UvContext& c) {
  const V3<double> from_center = p - V3<double>{s[0], s[1], s[2]};
  const BodySurface own = unit_sphere_surface(c.own(from_center));
  // The map keeps angles: its transpose is its inverse but for a scale.
  const double scale = 1 / dot(c.x, c.x);
  const auto back = [&](const V3<double>& v) {
    return V3<double>{dot(c.x, v), dot(c.y, v), dot(c.z, v)} * scale;
  };
  BodySurface surface{from_center};
  surface.u = own.u, surface.v = own.v;
  surface.along_u = back(own.along_u), surface.along_v = back(own.along_v);
  return surface;
}

inline BodySurface uv_of(const Triangle*, const double* s, const V3<double>& p,
                         const UvContext& c) {
  const double* const k = c.whole_corners != nullptr ? c.whole_corners : s;
  const V3<double> a{k[0], k[1], k[2]}, ab = V3<double>{k[3], k[4], k[5]} - a,
                   ac = V3<double>{k[6], k[7], k[8]} - a, ap = p - a;
  const V3<double> n = cross(ab, ac);
  const double area2 = dot(n, n);
  const double wb = dot(cross(ap, ac), n) / area2, wc = dot(cross(ab, ap), n) / area2;
  static constexpr CornerUvs kPlain{{{0, 0}, {1, 0}, {0, 1}}};
  const CornerUvs& t = c.uvs != nullptr ? *c.uvs : kPlain;
  const auto at = [&](std::size_t corner, std::size_t i) {
    return static_cast<double>(t[corner][i]);
  };
  BodySurface surface{n};
  surface.u = at(0, 0) + wb * (at(1, 0) - at(0, 0)) + wc * (at(2, 0) - at(0, 0));
  surface.v = at(0, 1) + wb * (at(1, 1) - at(0, 1)) + wc * (at(2, 1) - at(0, 1));
  // ab and ac in terms of u and v, turned round.
  const double bu = at(1, 0) - at(0, 0), bv = at(1, 1) - at(0, 1), cu = at(2, 0) - at(0, 0),
               cv = at(2, 1) - at(0, 1), det = bu * cv - cu * bv;
  if (det != 0) {
    surface.along_u = (ab * cv - ac * bv) * (1 / det);
    surface.along_v = (ac * bu - ab * cu) * (1 / det);
  } else {
    // Corners that all have one u and v, as those of models that take colours from a palette, see
    // one point of a texture: it is as if u and v would change far away.
    const double far = t[0] == t[1] && t[0] == t[2] ? 0x1p60 : 1;
    surface.along_u = ab * far, surface.along_v = ac * far;
  }
  return surface;
}

inline BodySurface around_axis(const double* s, double half, const V3<double>& p,
                               const UvContext& c) {
  constexpr double kPi = 3.14159265358979323846;
  // Round the axis as it lies in the shape's own space, so that u turns with it.
  const V3<double> axis{s[3], s[4], s[5]}, from = p - V3<double>{s[0], s[1], s[2]};
  const AxisFrame f = axis_frame(vec3_of(c.own(axis)));
  const V3<double> own = c.own(from);
  const double x = dot(own, f.x), z = dot(own, f.z), along = dot(from, axis);
  BodySurface surface{from - axis * along};
  surface.u = 0.5 + elementary::atan2(x, z) / (2 * kPi);
  surface.v = (along + half) / (2 * half);
  surface.along_u = cross(axis, surface.normal) * (2 * kPi);
  surface.along_v = axis * (2 * half);
  surface.v_ends = true;
  return surface;
}
inline BodySurface uv_of(const Cone*, const double* s, const V3<double>& p, const UvContext& c) {
  return around_axis(s, s[8], p, c);
}
inline BodySurface uv_of(const Cylinder*, const double* s, const V3<double>& p,
                         const UvContext& c) {
  return around_axis(s, s[7], p, c);
}

inline BodySurface uv_of(const SmoothTriangle*, const double* s, const V3<double>& p,
                         const UvContext& c) {
  return uv_of(static_cast<const Triangle*>(nullptr), s, p, c);
}

/// 1 over the radius of a primitive's curvature.
inline double curvature_of(const Sphere*, const double* s) {
  return 1 / s[3];
}
inline double curvature_of(const Cone*, const double* s) {
  return s[6] > 0 ? 1 / s[6] : 0;
}
inline double curvature_of(const void*, const double*) {
  return 0;
}

}  // namespace zraka
