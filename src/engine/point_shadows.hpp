// SPDX-License-Identifier: Apache-2.0
// Shadow rays of which many begin at each hit, as ambient occlusion's do.
#pragma once

#include "accel/point_rays.hpp"
#include "engine/shadow_order.hpp"

namespace zraka::ZRAKA_ISA {

/// With fewer rays of a point, to ask for the point first takes longer than it saves: among
/// spheres, and among triangles, which are fewer in their leaves.
inline constexpr std::size_t kFewFromPoint = 8, kFewAmongTriangles = 32;

/// From how many rays of a point on these are asked for the point; none where the scene has no
/// hierarchy, or one with bodies, which are asked by registers of rays, or with cones, of which
/// pairs fill registers better.
template <class R>
ZRAKA_INLINE std::size_t least_from_point(const FrozenScene<R>& scene) {
  std::int32_t all = 0;
#define ZRAKA_ADD(Type, plural) all += scene.plural.count;
  ZRAKA_KINDS(ZRAKA_ADD)
#undef ZRAKA_ADD
  all -= scene.bodies.count - scene.bodies.bounded;
  if (scene.hierarchy.nodes == nullptr) return 0;
  if (all == scene.spheres.count) return kFewFromPoint;
  const std::int32_t triangles = scene.triangles.count + scene.smooth_triangles.count;
  return all == scene.spheres.count + triangles ? kFewAmongTriangles : 0;
}

/// Whether `least` of the first n shadow rays begin at a hit, in the mean.
template <class R>
ZRAKA_INLINE bool begin_together(std::size_t least, std::size_t n, const Scratch<R>& scratch) {
  std::size_t hits = 0;
  for (std::size_t i = 0; i < n; ++i)
    hits += i == 0 || scratch.shadow_ray_hit[i] != scratch.shadow_ray_hit[i - 1] ? 1 : 0;
  return n >= least * hits;
}

/// As Services::find_blocked_from_points(): by points where it can, else in the order of all
/// directions.
template <class L, class R = typename L::Real>
void find_blocked_from_points(const FrozenScene<R>& scene, std::size_t n, Scratch<R>& scratch) {
  const std::size_t least = least_from_point(scene);
  if (least == 0 || !begin_together(least, n, scratch))
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
