// SPDX-License-Identifier: Apache-2.0
#include "accel/body_surface.hpp"

#include <algorithm>

#include "accel/csg.hpp"

namespace zraka::ZRAKA_ISA {
namespace {

template <class Shape>
V3<double> normal_of(const double* numbers, const V3<double>& point) {
  if constexpr (ShapeTraits<Shape>::kComposed)
    return {0, 1, 0};
  else
    return ShapeTraits<Shape>::surface(numbers, point).normal;
}

using NormalOf = V3<double> (*)(const double*, const V3<double>&);
constexpr NormalOf kNormalOf[kBodyTypes] = {
#define ZRAKA_FUNCTION(Type, plural) normal_of<Type>,
    ZRAKA_BODIES(ZRAKA_FUNCTION)
#undef ZRAKA_FUNCTION
};

template <class Shape>
BodySurface on(const FrozenBodies& bodies, std::int32_t body, const V3<double>& point) {
  BodySurface s{};
  if constexpr (!ShapeTraits<Shape>::kComposed) {
    const double* const row = bodies.numbers + bodies.start[body];
    const double* const m = row + kBodyMatrix;
    const V3<double> x{m[0], m[1], m[2]}, y{m[3], m[4], m[5]}, z{m[6], m[7], m[8]};
    const V3<double> p = point - V3<double>{row[0], row[1], row[2]};
    s = ShapeTraits<Shape>::surface(row + kBodyNumbers, {dot(x, p), dot(y, p), dot(z, p)});
    // A gradient goes back by the transposed matrix, what moves along the surface by its inverse.
    s.normal = x * s.normal.x + y * s.normal.y + z * s.normal.z;
    const V3<double> yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
    const double determinant = 1 / dot(x, yz);
    const auto back = [&](const V3<double>& v) {
      return (yz * v.x + zx * v.y + xy * v.z) * determinant;
    };
    s.along_u = back(s.along_u);
    s.along_v = back(s.along_v);
  }
  return s;
}

template <class Shape>
constexpr double own_curvature() {
  if constexpr (requires { ShapeTraits<Shape>::kCurvature; })
    return ShapeTraits<Shape>::kCurvature;
  else
    return 0;
}
constexpr double kOwnCurvature[kBodyTypes] = {
#define ZRAKA_FUNCTION(Type, plural) own_curvature<Type>(),
    ZRAKA_BODIES(ZRAKA_FUNCTION)
#undef ZRAKA_FUNCTION
};

using On = BodySurface (*)(const FrozenBodies&, std::int32_t, const V3<double>&);
constexpr On kOn[kBodyTypes] = {
#define ZRAKA_FUNCTION(Type, plural) on<Type>,
    ZRAKA_BODIES(ZRAKA_FUNCTION)
#undef ZRAKA_FUNCTION
};

}  // namespace

V3<double> own_normal(std::uint8_t type, const double* numbers, const V3<double>& point) {
  return kNormalOf[type](numbers, point);
}

BodySurface on_body(const FrozenBodies& bodies, std::int32_t body, const V3<double>& point) {
  return kOn[bodies.type[body]](bodies, body, point);
}

double curvature_of_body(const FrozenBodies& bodies, std::int32_t body) {
  const double own = kOwnCurvature[bodies.type[body]];
  if (own == 0) return 0;
  const double* const m = bodies.numbers + bodies.start[body] + kBodyMatrix;
  const V3<double> x{m[0], m[1], m[2]}, y{m[3], m[4], m[5]}, z{m[6], m[7], m[8]};
  return own * std::sqrt(std::fmax(dot(x, x), std::fmax(dot(y, y), dot(z, z))));
}

int csg_crossings(const FrozenBodies& bodies, std::int32_t body, const V3<double>& origin,
                  const V3<double>& direction, CsgCrossing* found, int most) {
  const CsgWay<ScalarDoubles> way(bodies, body, origin, direction, true, kNever, false);
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
