// SPDX-License-Identifier: Apache-2.0
// Where samples of a pixel lie, so that each counts as much as the others: distributed as the
// filter (Ernst, Stamminger and Greiner, "Filter importance sampling", 2006). A pixel then needs no
// samples of its neighbours.
#pragma once

#include <cstdint>
#include <vector>
#include <zraka/sampling.hpp>

#include "math/inline.hpp"
#include "sampling/sobol.hpp"

namespace zraka {

/// A place relative to the pixel's, in pixels: right and down.
struct FilterOffset {
  double x, y;
  bool negative;  ///< where the filter is below 0
};

/// Places by the bits of a random number, for loops over many: linear pieces of equal weight.
struct InverseFilter {
  static constexpr int kParts = 1024;
  /// From the middle on, at equal steps of the density's integral, kParts + 1 of them; nullptr: the
  /// box filter.
  const float* places;
  std::int32_t negative_from;  ///< in 2^-24 of the integral from the middle on

  /// How far from the middle, in 2^-24 of the integral on that side; an odd number.
  ZRAKA_INLINE static std::int32_t from_middle(std::uint32_t bits) {
    return 2 * static_cast<std::int32_t>(bits >> 8) + 1 - (1 << 24);
  }
  ZRAKA_INLINE bool is_negative(std::uint32_t bits) const {
    const std::int32_t away = from_middle(bits);
    return (away < 0 ? -away : away) > negative_from;
  }
  template <bool kBox, class R>
  ZRAKA_INLINE R place(std::uint32_t bits) const {
    const std::int32_t signed_away = from_middle(bits);
    if constexpr (kBox) return static_cast<R>(signed_away) * R(0x1p-25);
    const std::int32_t away = signed_away < 0 ? -signed_away : signed_away;
    const std::int32_t part = away >> 14;
    const R rest = static_cast<R>(away & ((1 << 14) - 1)) * R(0x1p-14);
    const auto before = static_cast<R>(places[part]), after = static_cast<R>(places[part + 1]);
    const R x = before + rest * (after - before);
    return signed_away < 0 ? -x : x;
  }
};

/// A filter f(x)·f(y) as the density |f(x)|·|f(y)| and its sign.
class PixelFilterShape {
 public:
  static const PixelFilterShape& of(PixelFilter filter);

  FilterOffset offset(const Point2& point) const;
  /// The same, to within a thousandth of the integral.
  InverseFilter inverse() const;
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
  std::vector<float> inverse_;  ///< InverseFilter's places
  std::int32_t negative_from_;
  double sign_change_;  ///< how far from the middle f becomes negative; 0: nowhere
  double negative_;
};

}  // namespace zraka
