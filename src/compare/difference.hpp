// SPDX-License-Identifier: Apache-2.0
// What counts as the difference of two values, and of two pixels.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace zraka {

/// Where both are the same, infinities and NaNs too, 0; where else one is no finite number, 1.
inline float difference(float a, float b) {
  const float d = std::fabs(a - b);
  const bool same = (a == b) | ((a != a) & (b != b));
  const float otherwise = same ? 0.0f : 1.0f;
  return d <= std::numeric_limits<float>::max() ? d : otherwise;
}

/// Largest difference of a pixel's three channels.
inline float pixel_difference(const float* a, const float* b) {
  return std::max(std::max(difference(a[0], b[0]), difference(a[1], b[1])), difference(a[2], b[2]));
}

}  // namespace zraka
