// SPDX-License-Identifier: Apache-2.0
// Rays and shadow rays from the engine's arrays into lanes.
#pragma once

#include "accel/ray_lanes.hpp"
#include "engine/engine.hpp"

namespace zraka::ZRAKA_ISA {

/// The rays [i, i + kWidth) of a level.
template <class L, class R = typename L::Real>
ZRAKA_INLINE RayLanes<L> load_rays(const RayArrays<R>& rays, std::size_t i) {
  return {{L::load(rays.ox + i), L::load(rays.oy + i), L::load(rays.oz + i)},
          {L::load(rays.dx + i), L::load(rays.dy + i), L::load(rays.dz + i)},
          typename L::F(kFarAway<R>),
          typename L::I(-1)};
}

/// The shadow rays [i, i + kWidth), which end at the light.
template <class L, class R = typename L::Real>
ZRAKA_INLINE RayLanes<L> load_shadow_rays(const Scratch<R>& scratch, std::size_t i) {
  return {{L::load(scratch.sox + i), L::load(scratch.soy + i), L::load(scratch.soz + i)},
          {L::load(scratch.sdx + i), L::load(scratch.sdy + i), L::load(scratch.sdz + i)},
          L::load(scratch.sdistance + i),
          typename L::I(-1)};
}

/// So many shadow rays from number i on, as one group.
template <class L, class R = typename L::Real>
ZRAKA_INLINE RayGroup<L> group_of_shadow_rays(const Scratch<R>& scratch, std::size_t i,
                                              std::size_t shadow_rays) {
  return RayGroup<L>(i, shadow_rays,
                     [&](std::size_t at) { return load_shadow_rays<L>(scratch, at); });
}

/// Calls function(i, ray, active) for each register of a group whose first ray is number `first` of
/// n.
template <class L, class Function>
ZRAKA_INLINE void each_register(const RayGroup<L>& rays, std::size_t first, std::size_t n,
                                const Function& function) {
  for (std::size_t r = 0; r < kRegisters<L> && first + r * L::kWidth < n; ++r)
    function(first + r * L::kWidth, rays.ray[r], L::first(n - first - r * L::kWidth));
}

}  // namespace zraka::ZRAKA_ISA
