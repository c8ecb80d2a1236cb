// SPDX-License-Identifier: Apache-2.0
// The ways through a scene as functions that are called, not put into their callers: compiled once
// for an instruction set, with the engine's kernel. For rays that come from memory, and for the
// groups of instances, which are scenes in scenes.
#pragma once

#include "accel/ray_lanes.hpp"

namespace zraka::ZRAKA_ISA {

/// As find_nearest().
template <class L>
void find_nearest_called(const FrozenScene<typename L::Real>& scene, RayGroup<L>& rays);

/// As find_blocked().
template <class L>
std::uint32_t find_blocked_called(const FrozenScene<typename L::Real>& scene, LastBlocker& last,
                                  RayGroup<L>& rays);

}  // namespace zraka::ZRAKA_ISA
