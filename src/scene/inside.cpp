// SPDX-License-Identifier: Apache-2.0
#include "scene/inside.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "math/elementary.hpp"

namespace zraka {
namespace {

V3<double> between(const Vec3& from, const Vec3& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

double square(double a) {
  return a * a;
}

/// Of a point: how far along an axis from its first end to its other, as a share of the way, and
/// how far away from it.
struct AlongAxis {
  double share, away;
};
AlongAxis along_axis(const Vec3& base, const Vec3& top, const Vec3& point) {
  const V3<double> axis = between(base, top), p = between(base, point);
  const double share = dot(p, axis) / dot(axis, axis);
  const V3<double> off = p - axis * share;
  return {share, std::sqrt(dot(off, off))};
}

}  // namespace

bool Insides::has(const Sphere& s, const Vec3& point) const {
  const V3<double> p = between(s.center, point);
  return dot(p, p) < square(s.radius);
}

bool Insides::has(const Ellipsoid& s, const Vec3& point) const {
  const V3<double> p = between(s.center, point);
  return square(p.x / s.radii.x) + square(p.y / s.radii.y) + square(p.z / s.radii.z) < 1;
}

bool Insides::has(const Box& s, const Vec3& point) const {
  const Bounds sharp{{s.min.x + s.radius, s.min.y + s.radius, s.min.z + s.radius},
                     {s.max.x - s.radius, s.max.y - s.radius, s.max.z - s.radius}};
  if (s.radius > 0) return sharp.distance_to(point) < s.radius;
  return point.x > s.min.x && point.x < s.max.x && point.y > s.min.y && point.y < s.max.y &&
         point.z > s.min.z && point.z < s.max.z;
}

bool Insides::has(const Frustum& s, const Vec3& point) const {
  const auto [share, away] = along_axis(s.base, s.top, point);
  return s.caps && share > 0 && share < 1 &&
         away < s.base_radius + (s.top_radius - s.base_radius) * share;
}

bool Insides::has(const Capsule& s, const Vec3& point) const {
  const V3<double> axis = between(s.base, s.top);
  const double share = std::clamp(along_axis(s.base, s.top, point).share, 0.0, 1.0);
  const V3<double> off = between(s.base, point) - axis * share;
  return dot(off, off) < square(s.radius);
}

bool Insides::has(const Torus& s, const Vec3& point) const {
  const V3<double> axis = vector_of(s.normal), p = between(s.center, point);
  const double height = dot(p, axis) / std::sqrt(dot(axis, axis));
  const double round = std::sqrt(std::max(0.0, dot(p, p) - square(height)));
  return square(round - s.radius) + square(height) < square(s.tube_radius);
}

bool Insides::has(const Quadric& s, const Vec3& point) const {
  if (ShapeTraits<Quadric>::check_member(s) != nullptr) return false;  // it is cut off
  const auto& k = s.coefficients;
  const auto& [x, y, z] = point;
  return k[0] * x * x + k[1] * y * y + k[2] * z * z + k[3] * x * y + k[4] * x * z + k[5] * y * z +
             k[6] * x + k[7] * y + k[8] * z + k[9] <
         0;
}

bool Insides::has(const Superellipsoid& s, const Vec3& point) const {
  const V3<double> p = between(s.center, point);
  const auto power = [](double a, double e) { return elementary::pow(std::fabs(a), e); };
  const double across = power(p.x / s.radii.x, 2 / s.e) + power(p.y / s.radii.y, 2 / s.e);
  return power(across, s.e / s.n) + power(p.z / s.radii.z, 2 / s.n) < 1;
}

bool Insides::has(const Csg& s, const Vec3& point) const {
  const auto in = [&](const CsgMember& member) { return has(member, point); };
  switch (s.operation) {
    case CsgOperation::unite:
      return std::any_of(s.of.begin(), s.of.end(), in);
    case CsgOperation::intersect:
      return std::all_of(s.of.begin(), s.of.end(), in);
    case CsgOperation::subtract:
      return in(s.of.front()) && std::none_of(s.of.begin() + 1, s.of.end(), in);
  }
  return false;
}

bool Insides::has(const CsgMember& member, const Vec3& point) const {
  return std::visit(
      [&]<class Body>(const Body& body) {
        if constexpr (std::is_same_v<Body, std::monostate>) {
          return false;
        } else if constexpr (std::is_same_v<Body, Plane>) {
          const std::optional<Transform> to_own = inverse(where_.transform(member.transform));
          return to_own &&
                 dot(between(body.point, moved(point, *to_own)), vector_of(body.normal)) < 0;
        } else {
          return has(body, member.transform, point);
        }
      },
      member.body);
}

bool Insides::has(const Instance& s, const Vec3& point) const {
  const Group& group = scene_.groups[s.group];
  const auto in = [&](const auto& objects) {
    return std::any_of(objects.begin(), objects.end(),
                       [&](const auto& object) { return has(object, point); });
  };
#define ZRAKA_OR(Type, plural) || in(group.plural)
  return false ZRAKA_SHAPES(ZRAKA_OR);
#undef ZRAKA_OR
}

// These have no inside.
bool Insides::has(const Triangle&, const Vec3&) const {
  return false;
}
bool Insides::has(const SmoothTriangle&, const Vec3&) const {
  return false;
}
bool Insides::has(const Cone&, const Vec3&) const {
  return false;
}
bool Insides::has(const Plane&, const Vec3&) const {
  return false;
}
bool Insides::has(const Disc&, const Vec3&) const {
  return false;
}
bool Insides::has(const Parallelogram&, const Vec3&) const {
  return false;
}

}  // namespace zraka
