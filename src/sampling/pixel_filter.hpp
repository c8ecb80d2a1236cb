// SPDX-License-Identifier: Apache-2.0
// Where samples of a pixel lie, so that each counts as much as the others: distributed as the
// filter (Ernst, Stamminger and Greiner, "Filter importance sampling", 2006). A pixel then needs no
// samples of its neighbours.
#pragma once

#include <cstdint>
#include <vector>
#include <zraka/sampling.hpp>

#include "sampling/sobol.hpp"

namespace zraka {

/// A place relative to the pixel's, in pixels: right and down.
struct FilterOffset {
  double x, y;
  bool negative;  ///< where the filter is below 0
};

/// A filter f(x)·f(y) as the density |f(x)|·|f(y)| and its sign.
class PixelFilterShape {
 public:
  static const PixelFilterShape& of(PixelFilter filter);

  FilterOffset offset(const Point2& point) const;
  double radius() const { return radius_; }
  /// The filter's integral is 1: so much it is where f is positive, and so much below 0 elsewhere.
  double positive() const { return 1 + negative_; }
  double negative() const { return negative_; }

 private:
  PixelFilterShape(double radius, int steps, double (*f)(double), double sign_change = 0,
                   double negative_in_one_dimension = 0);
  double place(double u) const;

  double radius_, step_;
  /// Densities at equal steps from the middle to the radius, linear between; and their integral.
  std::vector<double> density_, integral_;
  /// For equal parts of the integral, in which step they begin.
  std::vector<std::uint16_t> guide_;
  double sign_change_;  ///< how far from the middle f becomes negative; 0: nowhere
  double negative_;
};

}  // namespace zraka
