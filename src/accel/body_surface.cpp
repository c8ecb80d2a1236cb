// SPDX-License-Identifier: Apache-2.0
#include "accel/body_surface.hpp"

#include <algorithm>

#include "accel/csg.hpp"

namespace zraka::ZRAKA_ISA {
namespace {

/// Of a body that is made of no others.
template <class Shape>
BodyHit hit_of(const FrozenBodies& bodies, std::int32_t body, const V3<double>& origin,
               const V3<double>& direction, double t) {
  BodyHit hit{};
  if constexpr (!ShapeTraits<Shape>::kComposed) {
    const double* const row = bodies.numbers + bodies.start[body];
    const auto view = view_of(SharedNumbers<ScalarDoubles>{row}, origin, direction);
    const V3<double> own = view.ray.origin + view.ray.direction * (t / view.unit - view.before);
    const BodySurface surface = ShapeTraits<Shape>::surface(row + kBodyNumbers, own);
    const double* const m = row + kBodyMatrix;
    const V3<double> x{m[0], m[1], m[2]}, y{m[3], m[4], m[5]}, z{m[6], m[7], m[8]};
    // A gradient goes back by the transposed matrix.
    const V3<double> normal = x * surface.normal.x + y * surface.normal.y + z * surface.normal.z;
    hit.t = t;
    hit.point = origin + direction * t;
    hit.normal = normal * (1 / std::sqrt(dot(normal, normal)));
    hit.size = view.unit;
    hit.body = body;
    hit.inside = dot(hit.normal, direction) > 0;
  }
  return hit;
}

using HitOf = BodyHit (*)(const FrozenBodies&, std::int32_t, const V3<double>&, const V3<double>&,
                          double);
constexpr HitOf kHitOf[kBodyTypes] = {
#define ZRAKA_FUNCTION(Type, plural) hit_of<Type>,
    ZRAKA_BODIES(ZRAKA_FUNCTION)
#undef ZRAKA_FUNCTION
};

/// Which way it goes through is known where the body is closed, also where it only grazes. A
/// quadric may be cut off by its box: then a ray comes in where there is no surface.
template <class Shape>
BodyHit first_hit(const FrozenBodies& bodies, std::int32_t body, const V3<double>& origin,
                  const V3<double>& direction) {
  if constexpr (ShapeTraits<Shape>::kComposed) {
    return {};
  } else {
    double at[BodyLanes<Shape, ScalarDoubles>::kMost];
    cross_body<Shape, ScalarDoubles>(
        SharedNumbers<ScalarDoubles>{bodies.numbers + bodies.start[body]}, origin, direction, at);
    const double t = first_in_front(at);
    BodyHit hit = hit_of<Shape>(bodies, body, origin, direction, t);
    if constexpr (ShapeTraits<Shape>::kClosed && !std::is_same_v<Shape, Quadric>)
      hit.inside = (std::find(std::begin(at), std::end(at), t) - std::begin(at)) % 2 == 1;
    return hit;
  }
}

template <class Shape>
OnBody on(const FrozenBodies& bodies, std::int32_t body, const V3<double>& point) {
  OnBody found{};
  if constexpr (!ShapeTraits<Shape>::kComposed) {
    const double* const row = bodies.numbers + bodies.start[body];
    const double* const m = row + kBodyMatrix;
    const V3<double> x{m[0], m[1], m[2]}, y{m[3], m[4], m[5]}, z{m[6], m[7], m[8]};
    const V3<double> p = point - V3<double>{row[0], row[1], row[2]};
    found.surface = ShapeTraits<Shape>::surface(row + kBodyNumbers, {dot(x, p), dot(y, p), dot(z, p)});
    BodySurface& s = found.surface;
    // A gradient goes back by the transposed matrix, what moves along the surface by its inverse.
    s.normal = x * s.normal.x + y * s.normal.y + z * s.normal.z;
    const V3<double> yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
    const double determinant = 1 / dot(x, yz);
    const auto back = [&](const V3<double>& v) {
      return (yz * v.x + zx * v.y + xy * v.z) * determinant;
    };
    s.along_u = back(s.along_u);
    s.along_v = back(s.along_v);
    found.curvature = s.curvature * std::sqrt(std::fmax(dot(x, x), std::fmax(dot(y, y), dot(z, z))));
  }
  return found;
}

using On = OnBody (*)(const FrozenBodies&, std::int32_t, const V3<double>&);
constexpr On kOn[kBodyTypes] = {
#define ZRAKA_FUNCTION(Type, plural) on<Type>,
    ZRAKA_BODIES(ZRAKA_FUNCTION)
#undef ZRAKA_FUNCTION
};

using FirstHit = BodyHit (*)(const FrozenBodies&, std::int32_t, const V3<double>&,
                             const V3<double>&);
constexpr FirstHit kFirstHit[kBodyTypes] = {
#define ZRAKA_FUNCTION(Type, plural) first_hit<Type>,
    ZRAKA_BODIES(ZRAKA_FUNCTION)
#undef ZRAKA_FUNCTION
};

}  // namespace

BodyHit body_hit(const FrozenBodies& bodies, std::int32_t body, const V3<double>& origin,
                 const V3<double>& direction) {
  if (bodies.type[body] != kTypeCsg)
    return kFirstHit[bodies.type[body]](bodies, body, origin, direction);
  const CsgWay<ScalarDoubles> way(bodies, body, origin, direction);
  const double t = way.first_hit(kNever);
  const std::int32_t member = way.member_at(t);
  BodyHit hit = kHitOf[bodies.type[member]](bodies, member, origin, direction, t);
  // Outside is where the whole is not, whichever way the member's own surface looks.
  hit.inside = !way.inside(t);
  if ((dot(hit.normal, direction) > 0) != hit.inside) hit.normal = -hit.normal;
  return hit;
}

OnBody on_body(const FrozenBodies& bodies, std::int32_t body, const V3<double>& point) {
  return kOn[bodies.type[body]](bodies, body, point);
}

int csg_crossings(const FrozenBodies& bodies, std::int32_t body, const V3<double>& origin,
                  const V3<double>& direction, CsgCrossing* found, int most) {
  const CsgWay<ScalarDoubles> way(bodies, body, origin, direction);
  int count = 0;
  for (double t = way.next(0); t < kNever; t = way.next(t))
    for (int i = 0; i < way.members(); ++i)
      for (int k = 0; k < way.crossing_count(i); ++k)
        if (way.crossings(i)[k] == t) {
          if (count < most) found[count] = {t, way.member(i), k % 2 == 0, way.inside(t)};
          ++count;
        }
  return count;
}

}  // namespace zraka::ZRAKA_ISA
