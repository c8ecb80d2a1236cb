// SPDX-License-Identifier: Apache-2.0
// ((|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n))^(n/2) = 1 in units of the radii.
#pragma once

#include <algorithm>

#include "truth/truth.hpp"

namespace zraka::truth {

/// As precise as std::pow is for what is near 1, and takes a tenth of the time.
inline Real power(Real base, Real exponent) {
  return base == 0 ? 0 : std::exp2(exponent * std::log2(base));
}

/// Of exponents of 2 or less: then the left side is a norm.
template <>
struct Truth<Superellipsoid> {
  static constexpr bool kConvex = true;  ///< the residual, along each line
  Point center, radii;
  Real e, n, steepest;

  explicit Truth(const Superellipsoid& s)
      : center(exact(s.center)), radii(exact(s.radii)), e(s.e), n(s.n) {
    // It is at most |x| + |y| + |z|, or √(x² + y² + z²) where both exponents are 1 or less.
    const Point inverse{1 / radii.x, 1 / radii.y, 1 / radii.z};
    steepest = e <= 1 && n <= 1 ? std::max({inverse.x, inverse.y, inverse.z}) : length(inverse);
  }
  Real residual(const Point& p) const { return (norm(p) - 1) / steepest; }
  Point gradient(const Point& p) const {
    const Point q = in_radii(p);
    const Powers k(q, e, n);
    // The slope of u^m is m·u^m/u, and the exponents cancel.
    const auto over = [](Real power, Real base) { return base == 0 ? 0 : power / base; };
    const Real outer = over(k.norm, k.all), inner = outer * over(k.of_level, k.level);
    return Point{inner * over(k.x, q.x) / radii.x, inner * over(k.y, q.y) / radii.y,
                 outer * over(k.z, q.z) / radii.z} *
           (1 / steepest);
  }
  Real norm(const Point& p) const { return Powers(in_radii(p), e, n).norm; }

  static Superellipsoid random(Random& random, const Place& place) {
    const auto radius = [&] { return place.length(between(0.3, 0.6, random)); };
    const Vec3 center = place.point(in_cube(random));
    const double x = radius(), y = radius(), z = radius(), e = between(0.5, 1.5, random);
    return {center, {x, y, z}, e, between(0.5, 1.5, random)};
  }

 private:
  struct Powers {
    Real x, y, z, level, of_level, all, norm;
    Powers(const Point& q, Real e, Real n)
        : x(power(std::fabs(q.x), 2 / e)),
          y(power(std::fabs(q.y), 2 / e)),
          z(power(std::fabs(q.z), 2 / n)),
          level(x + y),
          of_level(power(level, e / n)),
          all(of_level + z),
          norm(power(all, n / 2)) {}
  };
  Point in_radii(const Point& p) const {
    const Point q = p - center;
    return {q.x / radii.x, q.y / radii.y, q.z / radii.z};
  }
};

}  // namespace zraka::truth
