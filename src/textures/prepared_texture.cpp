// SPDX-License-Identifier: Apache-2.0
#include "textures/prepared_texture.hpp"

#include <algorithm>
#include <cmath>

namespace zraka {

double width_along(const TexturePlace& at, const V3<double>& direction) {
  const double a = dot(at.axes[0], direction), b = dot(at.axes[1], direction);
  return 2 * std::sqrt(a * a + b * b);
}

double greatest_width(const TexturePlace& at) {
  // A map may have turned the two axes towards each other. The longest half axis is the root of the
  // larger eigenvalue of the matrix of their products.
  const double aa = dot(at.axes[0], at.axes[0]), bb = dot(at.axes[1], at.axes[1]);
  const double ab = dot(at.axes[0], at.axes[1]), half = (aa - bb) / 2;
  return 2 * std::sqrt((aa + bb) / 2 + std::sqrt(half * half + ab * ab));
}

double tolerance(const PreparedTexture& texture, const TexturePlace& at) {
  const double cells = at.error / texture.size;
  return cells > kLeastTolerance ? std::min(cells, kMostTolerance) : kLeastTolerance;
}

}  // namespace zraka
