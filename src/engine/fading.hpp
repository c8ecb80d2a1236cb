// SPDX-License-Identifier: Apache-2.0
// What distance and a spot's cone leave of a light.
#pragma once

#include "math/lanes.hpp"
#include "scene/frozen.hpp"

namespace zraka::ZRAKA_ISA {

/// The angle between unit vectors: 2·asin(|a - b|/2), or from the other side π - 2·asin(|a + b|/2),
/// which floats know just as well near 0 and π. asin is a series up to ½ (Cephes' asinf), and
/// π/2 - 2·asin √((1 - x)/2) above.
template <class F>
ZRAKA_INLINE F angle_between(const V3<F>& a, const V3<F>& b) {
  constexpr float kHalfTurn = 3.14159265358979f;
  const V3<F> apart = a - b, together = a + b;
  const F square = min(dot(apart, apart), dot(together, together));
  const F half = F(0.5f) * sqrt(square);
  const auto wide = half > F(0.5f);
  const F z = select(wide, max(F(0.5f) - F(0.5f) * half, F(0)), F(0.25f) * square);
  F series = F(4.2163199048e-2f);
  series = series * z + F(2.4181311049e-2f);
  series = series * z + F(4.5470025998e-2f);
  series = series * z + F(7.4953002686e-2f);
  series = series * z + F(1.6666752422e-1f);
  const F x = select(wide, sqrt(z), half);
  const F asin = x + x * z * series;
  const F angle = select(wide, F(kHalfTurn) - F(4) * asin, F(2) * asin);
  return select(dot(a, b) < F(0), F(kHalfTurn) - angle, angle);
}

/// What the cone leaves in the direction to the light: 1 inside of the inner angle, 0 outside of
/// the outer one; between them x²(3 - 2x) of the cosine, or where the edge is linear x of the
/// angle.
template <class L, class R = typename L::Real>
ZRAKA_INLINE typename L::F cone_at(const FrozenFading<R>& fading,
                                   const V3<typename L::F>& to_light) {
  using F = typename L::F;
  const V3<F> chord = to_light + broadcast<L>(fading.axis);
  const F square = dot(chord, chord);
  const auto inside = square <= F(fading.inner_square), outside = square > F(fading.outer_square);
  if (all(either(inside, outside))) return select(inside, F(1), F(0));
  F x = fading.linear_edge
            ? (F(fading.outer) - angle_between(-to_light, broadcast<L>(fading.axis))) *
                  F(fading.slope)
            : (F(fading.outer_square) - square) * F(fading.slope);
  x = min(max(x, F(0)), F(1));
  if (!fading.linear_edge) x = x * x * (F(3) - (x + x));
  return select(inside, F(1), select(outside, F(0), x));
}

template <class L, class R = typename L::Real>
ZRAKA_INLINE typename L::F strength_at(const FrozenFading<R>& fading,
                                       const V3<typename L::F>& to_light, typename L::F distance) {
  using F = typename L::F;
  const F left = F(1) / (F(fading.constant) + F(fading.linear) * distance +
                         F(fading.quadratic) * distance * distance);
  return fading.has_cone ? left * cone_at<L>(fading, to_light) : left;
}

}  // namespace zraka::ZRAKA_ISA
