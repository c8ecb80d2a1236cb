// SPDX-License-Identifier: Apache-2.0
#include "sampling/pixel_filter.hpp"

#include <algorithm>
#include <cmath>

#include "math/elementary.hpp"

namespace zraka {
namespace {

double box(double) {
  return 1;
}

double tent(double x) {
  return 1 - x;
}

double gauss(double x) {
  constexpr double kSigma = 0.5;
  return elementary::exp(-x * x / (2 * kSigma * kSigma));
}

/// Mitchell and Netravali, "Reconstruction filters in computer graphics", 1988, equation 8, with B
/// and C of 1/3.
double mitchell(double x) {
  if (x < 1) return (7 * x * x * x - 12 * x * x + 16.0 / 3) / 6;
  return (2 - x) * (2 - x) * (8 - 7 * x) / 18;
}

}  // namespace

PixelFilterShape::PixelFilterShape(double radius, int steps, double (*f)(double),
                                   double sign_change, double negative_in_one_dimension)
    : radius_(radius), step_(radius / steps), integral_{0}, sign_change_(sign_change) {
  for (int i = 0; i <= steps; ++i) density_.push_back(std::fabs(f(radius * i / steps)));
  for (int i = 1; i <= steps; ++i) {
    const auto at = static_cast<std::size_t>(i);
    integral_.push_back(integral_.back() + step_ * (density_[at - 1] + density_[at]) / 2);
  }
  const int parts = 2 * steps;
  for (int part = 0; part < parts; ++part) {
    const double area = integral_.back() * part / parts;
    const auto above = std::upper_bound(integral_.begin() + 1, integral_.end() - 1, area);
    guide_.push_back(static_cast<std::uint16_t>(above - integral_.begin() - 1));
  }
  for (int part = 0; part <= InverseFilter::kParts; ++part)
    inverse_.push_back(static_cast<float>(place(0.5 + 0.5 * part / InverseFilter::kParts)));
  inverse_.push_back(inverse_.back());
  double positive = 1;
  for (std::size_t i = 0; sign_change > 0 && i < integral_.size(); ++i)
    if (std::fabs(static_cast<double>(i) * step_ - sign_change) < step_ / 2)
      positive = integral_[i] / integral_.back();
  negative_from_ = static_cast<std::int32_t>(positive * 0x1p24);
  // f(x)·f(y) is negative where one of them is.
  negative_ = 2 * negative_in_one_dimension * (1 + negative_in_one_dimension);
}

const PixelFilterShape& PixelFilterShape::of(PixelFilter filter) {
  // Linear pieces are exact for the first two; for the others they are within 2e-5 of the peak.
  static const PixelFilterShape kBox(0.5, 1, box), kTent(1, 1, tent), kGauss(1.5, 256, gauss),
      // Below 0 from 8/7 on, which is at the end of a step, and the integral there is -6/343.
      kMitchell(2, 448, mitchell, 8.0 / 7, 12.0 / 343);
  switch (filter) {
    case PixelFilter::box:
      return kBox;
    case PixelFilter::tent:
      return kTent;
    case PixelFilter::gauss:
      return kGauss;
    case PixelFilter::mitchell:
      return kMitchell;
  }
  return kBox;
}

/// The inverse of the integral from -radius on, over its end: odd around u = ½.
double PixelFilterShape::place(double u) const {
  const double from_middle = std::fabs(2 * u - 1), area = from_middle * integral_.back();
  const std::size_t parts = guide_.size();
  std::size_t i = guide_[std::min(
      static_cast<std::size_t>(from_middle * static_cast<double>(parts)), parts - 1)];
  while (i + 2 < integral_.size() && area >= integral_[i + 1]) ++i;
  while (i > 0 && area < integral_[i]) --i;  // where the guide was rounded
  // d0·t + (d1 - d0)/step·t²/2 = rest, solved so that nothing cancels.
  const double rest = area - integral_[i], d0 = density_[i], slope = (density_[i + 1] - d0) / step_;
  const double root = d0 + std::sqrt(std::fmax(0.0, d0 * d0 + 2 * slope * rest));
  const double t = root > 0 ? std::fmin(2 * rest / root, step_) : 0;
  const double x = static_cast<double>(i) * step_ + t;
  return u < 0.5 ? -x : x;
}

InverseFilter PixelFilterShape::inverse() const {
  // A single step: a density that is the same everywhere.
  return {density_.size() == 2 && density_[0] == density_[1] ? nullptr : inverse_.data(),
          negative_from_};
}

FilterOffset PixelFilterShape::offset(const Point2& point) const {
  const double x = place(point.u), y = place(point.v);
  const auto below = [&](double v) { return sign_change_ > 0 && std::fabs(v) > sign_change_; };
  return {x, y, below(x) != below(y)};
}

}  // namespace zraka
