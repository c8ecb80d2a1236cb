// SPDX-License-Identifier: Apache-2.0
// Rays of samples that are drawn: from runs of each pixel's to a ray for each.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "engine/sobol_lanes.hpp"
#include "engine/window_rays.hpp"

namespace zraka::ZRAKA_ISA {

/// What each sample of the runs is drawn from, and its pixel's place. Puts kArrayPadding of them at
/// a time, which takes less than to stop where a run ends: what comes next is put there afterwards.
template <class R>
ZRAKA_INLINE void spread_runs(const SampleRuns& of, R* columns, R* rows) {
  const SampleRuns all = of;
  for (std::size_t i = 0; i < all.count; ++i) {
    const SampleRun run = all.runs[i];
    const auto column = static_cast<R>(run.column), row = static_cast<R>(run.row);
    const std::size_t end = std::size_t{run.begin} + run.count;
    std::uint32_t number = run.first;
    for (std::size_t at = run.begin; at < end; at += kArrayPadding, number += kArrayPadding) {
      std::fill_n(columns + at, kArrayPadding, column);
      std::fill_n(rows + at, kArrayPadding, row);
      for (std::uint32_t k = 0; k < kArrayPadding; k += BitLanes::kWidth) {
        BitLanes::store(BitLanes::all(run.shuffle), all.shuffle + at + k);
        BitLanes::store(BitLanes::all(run.u), all.u + at + k);
        BitLanes::store(BitLanes::all(run.v), all.v + at + k);
        BitLanes::store(BitLanes::iota(number + k), all.number + at + k);
      }
    }
  }
}

/// Moves pixels' places, `columns` and `rows`, to those of their samples.
template <bool kBox, class R>
ZRAKA_INLINE void place_samples(const InverseFilter& of, const SampleKeys& keys, std::size_t n,
                                R* __restrict columns, R* __restrict rows,
                                std::uint8_t* __restrict negative) {
  const InverseFilter filter = of;
  for (std::size_t first = 0; first < n; first += kMostPoints) {
    const std::size_t end = std::min(n, first + kMostPoints);
    alignas(64) std::uint32_t u[kMostPoints], v[kMostPoints];
    find_bits(PointsOfEach(keys, first), end - first, u, v);
    for (std::size_t i = first; i < end; ++i) {
      columns[i] += filter.template place<kBox, R>(u[i - first]);
      rows[i] += filter.template place<kBox, R>(v[i - first]);
      if constexpr (!kBox)
        negative[i] = filter.is_negative(u[i - first]) != filter.is_negative(v[i - first]);
    }
  }
}

/// As Services::make_window_rays().
template <class R>
ZRAKA_INLINE void make_window_rays(const FrozenCamera<R>& camera, const InverseFilter* filter,
                                   const SampleRuns& runs, std::size_t n,
                                   const RayArrays<R>& rays, std::uint8_t* negative) {
  if (filter != nullptr) {
    spread_runs(runs, rays.dx, rays.dy);
    const SampleKeys keys{runs.shuffle, runs.u, runs.v, runs.number};
    if (filter->places == nullptr)
      place_samples<true>(*filter, keys, n, rays.dx, rays.dy, negative);
    else
      place_samples<false>(*filter, keys, n, rays.dx, rays.dy, negative);
  }
  look_through_window(camera, n, rays.dx, rays.dy, rays.dz);
  const V3<R> eye = camera.eye;
  for (std::size_t i = 0; i < n; ++i) rays.ox[i] = eye.x;
  for (std::size_t i = 0; i < n; ++i) rays.oy[i] = eye.y;
  for (std::size_t i = 0; i < n; ++i) rays.oz[i] = eye.z;
}

}  // namespace zraka::ZRAKA_ISA
