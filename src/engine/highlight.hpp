// SPDX-License-Identifier: Apache-2.0
// Highlights in lanes of doubles: general/lights.cpp's, to the same bits.
#pragma once

#include "engine/engine.hpp"
#include "math/double_lanes.hpp"
#include "math/elementary_power.hpp"
#include "math/vec.hpp"

namespace zraka::ZRAKA_ISA {

/// (R·V)^n, or (N·H)^n in lanes where `blinn` is above 0: kFacesAway where the cosine is below 0,
/// kUnknownHighlight where the power has to be asked for by itself.
template <class D, class F = typename D::F>
ZRAKA_INLINE F highlight_at(const V3<F>& normal, const V3<F>& view, const V3<F>& light, F shininess,
                            F blinn) {
  const F n_l = dot(normal, light);
  F cosine = dot(normal * (F(2) * n_l) - light, view);
  if (const auto by_half = blinn > F(0); any(by_half)) {
    const V3<F> half = light + view;
    const F length = sqrt(dot(half, half));
    const F n_h = select(length > F(0), dot(normal, half) / length, F(0));
    cosine = select(by_half, n_h, cosine);
  }
  const auto none = (F(1) - cosine) * shininess > F(kNoHighlight);
  F highlight(0);
  if (!all(none))
    highlight =
        select(none, F(0), elementary_power(min(cosine, F(1)), shininess, F(kUnknownHighlight)));
  return select(cosine >= F(0), highlight, F(kFacesAway));
}

}  // namespace zraka::ZRAKA_ISA
