// SPDX-License-Identifier: Apache-2.0
// What surfaces of clear bodies reflect, in lanes of doubles.
#pragma once

#include <zraka/optics.hpp>

#include "math/double_lanes.hpp"

namespace zraka::ZRAKA_ISA {

/// Of unpolarised light, the share that is reflected (Fresnel); eta is n1/n2. 1 beyond the critical
/// angle.
template <class F>
ZRAKA_INLINE F fresnel_exact(F cosine, F eta) {
  const F sine2 = eta * eta * (F(1) - cosine * cosine);
  const F other = sqrt(F(1) - sine2);
  // Divided by n2: r across = (n1·cosα - n2·cosβ)/(n1·cosα + n2·cosβ), r along likewise.
  const F across = (eta * cosine - other) / (eta * cosine + other);
  const F along = (cosine - eta * other) / (cosine + eta * other);
  return select(sine2 < F(1), F(0.5) * (across * across + along * along), F(1));
}

/// Schlick's approximation; where the ray comes from the denser side, by the other side's angle.
template <class F>
ZRAKA_INLINE F fresnel_schlick(F cosine, F eta) {
  const F sine2 = eta * eta * (F(1) - cosine * cosine);
  const auto dense = eta > F(1);
  const F c = select(dense, sqrt(F(1) - sine2), cosine);
  const F straight = (eta - F(1)) / (eta + F(1)), f0 = straight * straight;
  const F m = F(1) - c, m2 = m * m;
  return select(but_not(dense, sine2 < F(1)), F(1), f0 + (F(1) - f0) * (m2 * m2 * m));
}

/// The same by what lanes of `by` say, values of Fresnel; 0 where that is off.
template <class D, class F = typename D::F>
ZRAKA_INLINE F reflected_share(F by, F cosine, F eta) {
  const auto is = [&](Fresnel kind) { return by == F(static_cast<double>(kind)); };
  F share(0);
  if (const auto exact = is(Fresnel::exact); any(exact))
    share = select(exact, fresnel_exact(cosine, eta), share);
  if (const auto schlick = is(Fresnel::schlick); any(schlick))
    share = select(schlick, fresnel_schlick(cosine, eta), share);
  return share;
}

}  // namespace zraka::ZRAKA_ISA
