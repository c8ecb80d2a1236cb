// SPDX-License-Identifier: Apache-2.0
// Shadow rays of the general engine: they wait until there are many, go together in the order of
// their directions, and what is transparent is walked through.
#pragma once

#include <algorithm>

#include "engine/general/steps.hpp"

namespace zraka::general {

/// As far as shadow rays of no end go.
inline constexpr double kFarthest = 0x1p100;

/// What shadows leave of all that wait: general.filter.
template <class R>
void trace_waiting(const Batch<R>& batch);

/// Where the shadow rays of a hit begin.
template <class R>
V3<R> shadow_origin(const Batch<R>& batch, std::size_t h) {
  return narrowed<R>(batch.point(h) + batch.smooth_normal(h) * batch.offset(h));
}

/// As many samples as a ray's weight in the pixel is worth: what counts little may be noisier.
template <class R>
std::int32_t samples_for(std::int32_t of_light, const RayState<R>& ray) {
  if (of_light == 1) return 1;
  const auto most = static_cast<double>(most_size(ray.weight));
  return std::clamp(static_cast<std::int32_t>(std::ceil(of_light * std::fmin(most, 1.0))), 1,
                    of_light);
}

/// Two directions at right angles to a unit vector and to each other (Duff et al. 2017, "Building
/// an Orthonormal Basis, Revisited").
inline void basis_of(const V3<double>& n, V3<double>& a, V3<double>& b) {
  const double sign = std::copysign(1.0, n.z);
  const double p = -1 / (sign + n.z), q = n.x * n.y * p;
  a = {1 + sign * n.x * n.x * p, sign * q, -sign * n.x};
  b = {q, sign + n.y * n.y * p, -n.y};
}

/// How much of the ambient light reaches each hit: general.occlusion.
template <class R>
void find_occlusion(const Batch<R>& batch);

}  // namespace zraka::general
