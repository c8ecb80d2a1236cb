// SPDX-License-Identifier: Apache-2.0
// Numbers for people, of those that a rounded one may stand for.
#pragma once

#include <cmath>
#include <cstdlib>

namespace zraka {

/// The number with the fewest decimals that is not farther than `error` from a value.
inline double roundest_within(double value, double error) {
  if (!std::isfinite(value) || !(error > 0)) return value;
  if (std::fabs(value) <= error) return 0;
  // Multiples of the last power are so close to each other that one of them always is near enough.
  const int last = static_cast<int>(std::floor(std::log10(2 * error)));
  for (int e = static_cast<int>(std::floor(std::log10(std::fabs(value)))) + 1; e >= last; --e) {
    const double power = std::pow(10.0, std::abs(e));
    const double near =
        e < 0 ? std::round(value * power) / power : std::round(value / power) * power;
    if (std::fabs(near - value) <= error) return near;
  }
  return value;
}

}  // namespace zraka
