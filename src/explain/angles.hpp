// SPDX-License-Identifier: Apache-2.0
// The angles that Snell's terms stand for.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <zraka/explain.hpp>

namespace zraka {

struct Angles {
  double alpha_deg = 0;                  ///< of incidence, from the normal
  std::optional<double> beta_deg{};      ///< of refraction; none where reflection is total
  std::optional<double> critical_deg{};  ///< beyond it reflection is total; none if b ≤ 1
};

/// sin β = b·sin α; the critical angle has b·sin α = 1.
inline Angles angles_of(const SnellTerms& snell) {
  constexpr double kDegrees = 57.295779513082320877;
  const double b = static_cast<double>(snell.ratio);
  const double alpha = std::acos(std::clamp(static_cast<double>(snell.cosine), -1.0, 1.0));
  Angles angles{.alpha_deg = alpha * kDegrees};
  if (!snell.total)
    angles.beta_deg = std::asin(std::clamp(b * std::sin(alpha), -1.0, 1.0)) * kDegrees;
  if (std::fabs(b) > 1) angles.critical_deg = std::asin(1 / std::fabs(b)) * kDegrees;
  return angles;
}

}  // namespace zraka
