// SPDX-License-Identifier: Apache-2.0
// Shadow rays of which many begin at each hit, as ambient occlusion's do.
#pragma once

#include "accel/point_rays.hpp"
#include "engine/shadow_order.hpp"

namespace zraka::ZRAKA_ISA {

/// Whether all shapes are spheres in a hierarchy, none of them much larger than the others.
template <class R>
ZRAKA_INLINE bool has_spheres_only(const FrozenScene<R>& scene) {
  std::int32_t all = 0;
#define ZRAKA_ADD(Type, plural) all += scene.plural.count;
  ZRAKA_KINDS(ZRAKA_ADD)
#undef ZRAKA_ADD
  return scene.hierarchy.nodes != nullptr && all == scene.spheres.count;
}

/// With fewer rays of a point, to ask for the point first takes longer than it saves.
inline constexpr std::size_t kFewFromPoint = 8;

/// Whether at least so many of the first n shadow rays begin at a hit, in the mean.
template <class R>
ZRAKA_INLINE bool begin_together(std::size_t n, const Scratch<R>& scratch) {
  std::size_t hits = 0;
  for (std::size_t i = 0; i < n; ++i)
    hits += i == 0 || scratch.shadow_ray_hit[i] != scratch.shadow_ray_hit[i - 1] ? 1 : 0;
  return n >= kFewFromPoint * hits;
}

/// As Services::find_blocked_from_points(): by points among spheres, else in the order of all
/// directions.
template <class L, class R = typename L::Real>
void find_blocked_from_points(const FrozenScene<R>& scene, std::size_t n, Scratch<R>& scratch) {
  if (!has_spheres_only(scene) || !begin_together(n, scratch))
    return find_blocked_in_order<L>(scene, n, scratch);
  for (std::size_t first = 0; first < n;) {
    const std::int32_t hit = scratch.shadow_ray_hit[first];
    std::size_t end = first + 1;
    const std::size_t last = std::min(n, first + PointRays<L>::kMost);
    while (end < last && scratch.shadow_ray_hit[end] == hit) ++end;
    const PointRays<L> rays(scene, {scratch.sox[hit], scratch.soy[hit], scratch.soz[hit]},
                            scratch.sdistance[first], scratch.sdx + first, scratch.sdy + first,
                            scratch.sdz + first, end - first);
    const std::uint64_t blocked = blocked_from_point<L>(scene, rays);
    for (std::size_t i = first; i < end; ++i)
      scratch.blocked[i] = static_cast<std::int32_t>(blocked >> (i - first) & 1);
    first = end;
  }
}

}  // namespace zraka::ZRAKA_ISA
