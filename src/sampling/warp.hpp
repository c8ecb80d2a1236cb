// SPDX-License-Identifier: Apache-2.0
// From even points of the unit square to other shapes and densities, neighbours to neighbours, so
// that what is even stays so.
#pragma once

#include <cmath>

#include "math/elementary.hpp"
#include "math/vec.hpp"
#include "sampling/sobol.hpp"

namespace zraka {

/// Two directions at right angles to a unit vector and to each other (Duff et al. 2017, "Building
/// an Orthonormal Basis, Revisited").
template <class R>
ZRAKA_INLINE void basis_of(const V3<R>& n, V3<R>& a, V3<R>& b) {
  const R sign = n.z < 0 ? R(-1) : R(1);
  const R p = R(-1) / (sign + n.z), q = n.x * n.y * p;
  a = {1 + sign * n.x * n.x * p, sign * q, -sign * n.x};
  b = {q, sign + n.y * n.y * p, -n.y};
}

struct DiscPoint {
  double x, y;
};

/// Even over the disc of radius 1 (Shirley and Chiu, "A low distortion map between disk and
/// square", 1997): squares around the middle become circles.
inline DiscPoint concentric_disc(const Point2& p) {
  constexpr double kQuarter = 0.78539816339744830962;  // π/4
  const double a = 2 * p.u - 1, b = 2 * p.v - 1;
  if (a == 0 && b == 0) return {0, 0};
  if (std::fabs(a) > std::fabs(b)) {
    const double angle = kQuarter * (b / a);
    return {a * elementary::cos(angle), a * elementary::sin(angle)};
  }
  const double angle = kQuarter * (a / b);
  return {b * elementary::sin(angle), b * elementary::cos(angle)};
}

/// The same, rounder by a billionth: sine and cosine of at most an eighth of a turn by their series.
inline DiscPoint quick_concentric_disc(const Point2& p) {
  constexpr double kQuarter = 0.78539816339744830962;
  const double a = 2 * p.u - 1, b = 2 * p.v - 1;
  if (a == 0 && b == 0) return {0, 0};
  const bool wide = std::fabs(a) > std::fabs(b);
  const double r = wide ? a : b, x = kQuarter * (wide ? b / a : a / b), z = x * x;
  const double sine =
      x * (1 + z * (-1.0 / 6 + z * (1.0 / 120 + z * (-1.0 / 5040 + z * (1.0 / 362880)))));
  const double cosine =
      1 + z * (-1.0 / 2 + z * (1.0 / 24 + z * (-1.0 / 720 + z * (1.0 / 40320))));
  return wide ? DiscPoint{r * cosine, r * sine} : DiscPoint{r * sine, r * cosine};
}

/// Directions around z with a density of cosine/π (Malley's method): the disc, lifted up.
inline V3<double> cosine_hemisphere(const Point2& p) {
  const DiscPoint d = concentric_disc(p);
  return {d.x, d.y, std::sqrt(std::fmax(0.0, 1 - d.x * d.x - d.y * d.y))};
}

/// Even over the unit sphere (Archimedes): z is even from 1 to -1.
inline V3<double> uniform_sphere(const Point2& p) {
  constexpr double kTurn = 6.28318530717958647693;
  const double z = 1 - 2 * p.u, r = std::sqrt(std::fmax(0.0, 1 - z * z));
  return {r * elementary::cos(kTurn * p.v), r * elementary::sin(kTurn * p.v), z};
}

}  // namespace zraka
