// SPDX-License-Identifier: Apache-2.0
// A random body with its truth, rays at it, and what all instruction sets say of them.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

#include "bodies_probe.hpp"
#include "ray_count.hpp"
#include "shapes/bodies.hpp"
#include "truth/bodies.hpp"

namespace zraka::truth {

template <class Shape>
constexpr BodyType type_of() {
#define ZRAKA_IF(Type, plural) \
  if constexpr (std::is_same_v<Shape, Type>) return kType##Type;
  ZRAKA_BODIES(ZRAKA_IF)
#undef ZRAKA_IF
}

/// A body's numbers as the engine has them, of its placement and a transform in the world.
class Row {
 public:
  explicit Row(const Placement& placement, const Transform& world = {}) {
    const Transform from_own = under(placement.from_own, world);
    x_ = exact(from_own.along_x), y_ = exact(from_own.along_y), z_ = exact(from_own.along_z);
    origin_ = exact(from_own.origin);
    const Real determinant = dot(x_, cross(y_, z_));
    const Point rows[] = {cross(y_, z_), cross(z_, x_), cross(x_, y_)};
    put(origin_, kBodyCenter);
    for (int k = 0; k < 3; ++k) put(rows[k] * (1 / determinant), kBodyMatrix + 3 * k);
    std::copy_n(placement.numbers, kMostBodyNumbers, numbers_ + kBodyNumbers);
  }
  const double* numbers() const { return numbers_; }
  const double* own_numbers() const { return numbers_ + kBodyNumbers; }

  /// Into the body's own space.
  Point own(const Point& world) const {
    const Point p = world - origin_;
    const Real determinant = dot(x_, cross(y_, z_));
    return Point{dot(cross(y_, z_), p), dot(cross(z_, x_), p), dot(cross(x_, y_), p)} *
           (1 / determinant);
  }
  Point vector_from_own(const Point& v) const { return x_ * v.x + y_ * v.y + z_ * v.z; }
  Point normal_from_own(const Point& n) const {
    const Real sign = dot(x_, cross(y_, z_)) < 0 ? -1 : 1;
    return (cross(y_, z_) * n.x + cross(z_, x_) * n.y + cross(x_, y_) * n.z) * sign;
  }
  Point world(const Point& own) const { return origin_ + vector_from_own(own); }

  static constexpr std::size_t kSize = kBodyNumbers + kMostBodyNumbers;

 private:
  void put(const Point& p, int at) {
    numbers_[at] = static_cast<double>(p.x);
    numbers_[at + 1] = static_cast<double>(p.y);
    numbers_[at + 2] = static_cast<double>(p.z);
  }
  Point x_, y_, z_, origin_;
  double numbers_[kSize] = {};
};

inline Ray exact(const BodyProbeRay& ray) {
  return {exact(ray.origin), exact(ray.direction)};
}
inline BodyProbeRay probe_ray(const Point& origin, const Point& direction) {
  const Point d = unit(direction);
  const auto number = [](Real v) { return static_cast<double>(v); };
  return {{number(origin.x), number(origin.y), number(origin.z)},
          {number(d.x), number(d.y), number(d.z)}};
}

inline std::string to_string(const BodyProbeRay& ray) {
  return fmt::format("the ray from ({}, {}, {}) to ({}, {}, {})", ray.origin[0], ray.origin[1],
                     ray.origin[2], ray.direction[0], ray.direction[1], ray.direction[2]);
}
inline std::string to_string(const BodyCrossings& found) {
  return fmt::format("{}", fmt::join(found.at, ", "));
}
inline bool same_bits(const BodyCrossings& a, const BodyCrossings& b) {
  const auto same = [](double s, double t) {
    return std::bit_cast<std::uint64_t>(s) == std::bit_cast<std::uint64_t>(t);
  };
  const bool hit = a.first < HUGE_VAL;  // nothing is said of a normal elsewhere
  return std::equal(a.at, a.at + kProbedCrossings, b.at, same) && same(a.first, b.first) &&
         (!hit || (std::equal(a.normal, a.normal + 3, b.normal, same) && a.inside == b.inside)) &&
         a.keeps_limits == b.keeps_limits;
}

/// Of each ray with the body whose numbers begin at start[i]: the same bits by every instruction
/// set.
template <class Shape>
std::vector<BodyCrossings> crossings(const std::vector<double>& numbers,
                                     const std::vector<std::int32_t>& start,
                                     const std::vector<BodyProbeRay>& rays) {
  std::vector<BodyCrossings> first, found(rays.size());
  for (const BodiesProbe& probe : bodies_probes()) {
    probe.cross(type_of<Shape>(), numbers.data(), start.data(), rays.data(), found.data(),
                rays.size());
    if (first.empty()) first = found;
    for (std::size_t i = 0; i < rays.size(); ++i)
      EXPECT_TRUE(same_bits(found[i], first[i]))
          << to_string(rays[i]) << " crosses " << to_string(found[i]) << " by "
          << name_of(probe.isa) << ", but " << to_string(first[i]);
    if (testing::Test::HasFailure()) break;
  }
  return first;
}
template <class Shape>
std::vector<BodyCrossings> crossings(const Row& row, const std::vector<BodyProbeRay>& rays) {
  const std::vector<double> numbers(row.numbers(), row.numbers() + Row::kSize);
  return crossings<Shape>(numbers, std::vector<std::int32_t>(rays.size()), rays);
}

/// Bodies that are open by their parameters, too.
template <class Shape>
bool is_closed(const Shape& shape) {
  if constexpr (requires { ShapeTraits<Shape>::check_member(shape); })
    return ShapeTraits<Shape>::check_member(shape) == nullptr;
  else
    return ShapeTraits<Shape>::kClosed;
}
template <class Shape>
inline constexpr bool has_uv = true;
template <>
inline constexpr bool has_uv<Quadric> = false;
template <>
inline constexpr bool has_uv<Superellipsoid> = false;

/// A body in a place.
template <class Shape>
struct Placed {
  Place place;
  Shape shape;
  Truth<Shape> truth;
  Row row;

  Placed(Random& random, const Place& where) : Placed(Truth<Shape>::random(random, where), where) {}
  explicit Placed(const Shape& s, const Place& where = {})
      : place(where), shape(s), truth(s), row(ShapeTraits<Shape>::place(s)) {}

  Point middle() const { return exact(place.origin); }
  /// How far off the surface a crossing may be of a ray from there: what coordinates are rounded
  /// by, and the way to the body.
  Real error(const Point& origin) const {
    const auto largest = [](const Point& p) {
      return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    };
    return 0x1p-44L * place.scale + 0x1p-46L * length(origin - middle()) +
           0x1p-48L * largest(middle());
  }
  BodySurface surface(const Point& world) const {
    const Point p = row.own(world);
    return ShapeTraits<Shape>::surface(
        row.own_numbers(),
        {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)});
  }
};

/// From 1 to 10^-15.
inline Real tiny(Random& random) {
  return std::pow(10.0L, -static_cast<Real>(random() % 16));
}

/// Rays of all kinds at a body.
template <class Shape>
std::vector<BodyProbeRay> rays_at(const Placed<Shape>& body, std::size_t count, Random& random) {
  std::vector<BodyProbeRay> rays;
  const auto near = [&](double reach) {
    return body.middle() + exact(in_cube(random)) * (reach * body.place.scale);
  };
  const auto special = [&] { return static_cast<int>(random() % 5) * 0.5L - 1; };
  const auto special_point = [&] {
    const Real x = special(), y = special();
    return Point{x, y, special()};
  };
  while (rays.size() < count) {
    const Point to = body.row.world(exact(in_cube(random)) * 1.25L),
                from = near(rays.size() % 8 == 0 ? 1000 : 3);
    Point way = to - from;
    if (rays.size() % 8 == 3)  // past rims and edges
      way = body.row.world(special_point() + exact(in_cube(random)) * tiny(random)) - from;
    if (rays.size() % 8 == 1) {  // along the body's own axes
      const Real sign = random() % 2 == 0 ? 1 : -1;
      const Point axes[] = {{sign, 0, 0}, {0, sign, 0}, {0, 0, sign}};
      way = body.row.vector_from_own(axes[random() % 3]);
    }
    if (rays.size() % 8 == 2) {  // in planes where something begins or ends
      way = body.row.vector_from_own(special_point());
      if (length(way) > 0) rays.push_back(probe_ray(body.row.world(special_point()), way));
    } else {
      rays.push_back(probe_ray(from, way));
    }
  }
  return rays;
}

/// Rays that touch the body where others cross it, or nearly so.
template <class Shape>
std::vector<BodyProbeRay> touching_rays(const Placed<Shape>& body,
                                        const std::vector<BodyProbeRay>& rays,
                                        const std::vector<BodyCrossings>& found, Random& random) {
  std::vector<BodyProbeRay> touching;
  for (std::size_t i = 0; i < rays.size(); ++i)
    for (const double t : found[i].at) {
      if (!(std::fabs(t) < 1e30)) continue;
      const Point p = exact(rays[i]).at(t), up = normal(body.truth, p);
      Point way = exact(on_unit_sphere(random));
      way = way - up * dot(way, up);
      if (!(length(way) > 0.01L)) continue;  // or no number, at an apex
      const Real away = tiny(random) * (random() % 2 == 0 ? 1 : -1) * body.place.scale;
      const Point from = p + up * away - unit(way) * (body.place.scale * between(-1, 3, random));
      touching.push_back(probe_ray(from, way));
    }
  return touching;
}

}  // namespace zraka::truth
