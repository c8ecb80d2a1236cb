// SPDX-License-Identifier: Apache-2.0
// What lights of all kinds share.
#pragma once

#include "engine/general/shadows.hpp"
#include "math/elementary.hpp"

namespace zraka::general {

/// Adds a light with one sample to the local light of all hits, in lanes. Nobody listens.
template <class R>
void add_single_light(const Batch<R>& batch, std::int32_t index);

/// From 1 at a spot's inner angle to 0 at its outer one.
inline double linear_edge(const OpticalLight& light, double cosine) {
  // Farther from both angles than roundings reach, the angle itself is not needed.
  constexpr double kMargin = 1e-9, kHalfTurn = 3.14159265358979323846;
  if (light.inner >= 0 && light.outer <= kHalfTurn) {
    if (cosine > light.cos_inner + kMargin) return 1;
    if (cosine < light.cos_outer - kMargin) return 0;
  }
  const double angle =
      0.5 * 3.14159265358979323846 - elementary::asin(std::fmin(std::fmax(cosine, -1.0), 1.0));
  return std::fmin(std::fmax((light.outer - angle) / (light.outer - light.inner), 0.0), 1.0);
}

/// cosine^n; what is below 2^-40 is nothing: ln x ≤ x - 1.
inline double highlight_of(double cosine, double shininess) {
  if ((1 - cosine) * shininess > kNoHighlight) return 0;
  return elementary::pow(std::fmin(cosine, 1.0), shininess);
}

/// R·V, or N·H.
template <class R>
double highlight_cosine(const Batch<R>& batch, std::size_t h, const V3<double>& to_light) {
  const V3<double> n = batch.normal(h), v = batch.view(h);
  if (batch.material(h).highlight == Highlight::phong)
    return dot(n * (2 * dot(n, to_light)) - to_light, v);
  const V3<double> half = to_light + v;
  const double length = std::sqrt(dot(half, half));
  return length > 0 ? dot(n, half) / length : 0;
}

}  // namespace zraka::general
