// SPDX-License-Identifier: Apache-2.0
// Shapes by their textbook equations, in long double, for the engine to be held against. Nothing
// here uses src/shapes.
#pragma once

#include <cmath>
#include <random>
#include <zraka/shapes.hpp>

namespace zraka::truth {

using Real = long double;

/// A point or a vector of the world.
struct Point {
  Real x, y, z;
};
inline Point operator+(const Point& a, const Point& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Point operator-(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Point operator*(const Point& a, Real s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline Real dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Point cross(const Point& a, const Point& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Real length(const Point& a) {
  return std::sqrt(dot(a, a));
}
inline Point unit(const Point& a) {
  return a * (1 / length(a));
}
inline Point exact(const Vec3& v) {
  return {v.x, v.y, v.z};
}
inline Point exact(const double (&v)[3]) {
  return {v[0], v[1], v[2]};
}

/// Specialised by each shape, from its parameters, with
///   residual(p)            how far p is off the surface, or less: 0 on it, positive outside, and
///                          never changing by more than the distance between two points
///   gradient(p)            the residual's, by calculus
///   random(random, place)  a shape within 2 of the place's origin; no radius of curvature, height
///                          or thickness of it is below kFinest
/// and, where it is an open surface or has other normals than the gradient,
///   beyond(p)              how far p, of the surface's continuation, is past its rim, or less; 0
///                          or less within; changing no faster than the residual
///   normal(p)              of any length
template <class Shape>
struct Truth;

inline constexpr double kFinest = 0.1;

template <class T>
Real beyond(const T& truth, const Point& p) {
  if constexpr (requires { truth.beyond(p); })
    return truth.beyond(p);
  else
    return -HUGE_VALL;
}
template <class T>
Point normal(const T& truth, const Point& p) {
  if constexpr (requires { truth.normal(p); })
    return unit(truth.normal(p));
  else
    return unit(truth.gradient(p));
}

using Random = std::mt19937;
inline double between(double low, double high, Random& random) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
/// In a cube of sides 2.
inline Vec3 in_cube(Random& random) {
  const double x = between(-1, 1, random), y = between(-1, 1, random);
  return {x, y, between(-1, 1, random)};
}
inline Vec3 on_unit_sphere(Random& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  const double length = std::hypot(x, y, z);
  return {x / length, y / length, z / length};
}

/// Where in the world shapes of about size 1 stand, and how large they are there.
struct Place {
  double scale = 1;
  Vec3 origin;

  double length(double l) const { return l * scale; }
  Vec3 point(const Vec3& p) const {
    return {p.x * scale + origin.x, p.y * scale + origin.y, p.z * scale + origin.z};
  }
};

/// A unit direction from a point of the world.
struct Ray {
  Point origin, direction;
  Point at(Real t) const { return origin + direction * t; }
};

/// Whether a ray goes through a surface and comes out on the other side before `end`, so that no
/// error of a distance of less than `thickness` from the surface could hide it. Cuts the way into
/// halves where the residual does not say that the surface is out of reach.
template <class T>
class Passage {
 public:
  Passage(const T& truth, const Ray& ray, Real thickness)
      : truth_(truth), ray_(ray), thickness_(thickness) {}

  bool before(Real end) {
    const Real first = residual(0), last = residual(end);
    note(0, first);
    return visit(0, first, end, last);
  }

 private:
  Real residual(Real t) const { return truth_.residual(ray_.at(t)); }

  bool visit(Real from, Real there, Real to, Real then) {
    constexpr Real kSlack = 1 + 1e-6L;  // directions are of unit length in float
    const Real width = to - from;
    const bool out_of_reach =
        there * then > 0 && std::fabs(there) + std::fabs(then) > width * kSlack;
    if (out_of_reach || width < thickness_ / 4) return note(to, then);
    const Real middle = from + width / 2, here = residual(middle);
    return visit(from, there, middle, here) || visit(middle, here, to, then);
  }

  bool note(Real t, Real residual) {
    if (std::fabs(residual) <= thickness_) return false;
    const bool through = residual * last_residual_ < 0 && within_rim(last_, t);
    last_ = t;
    last_residual_ = residual;
    return through;
  }
  bool within_rim(Real from, Real to) const {
    const Real least = (to - from) + thickness_;
    return beyond(truth_, ray_.at(from)) < -least && beyond(truth_, ray_.at(to)) < -least;
  }

  const T& truth_;
  const Ray ray_;
  const Real thickness_;
  Real last_ = 0, last_residual_ = 0;  ///< the last time that it was off the surface
};

}  // namespace zraka::truth
