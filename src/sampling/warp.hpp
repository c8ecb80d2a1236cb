// SPDX-License-Identifier: Apache-2.0
// From even points of the unit square to other shapes and densities, neighbours to neighbours, so
// that what is even stays so.
#pragma once

#include <cmath>

#include "math/elementary.hpp"
#include "math/vec.hpp"
#include "sampling/sobol.hpp"

namespace zraka {

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
