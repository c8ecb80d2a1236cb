// SPDX-License-Identifier: Apache-2.0
// The engine for one instruction set. CMake compiles this file once for each, with ZRAKA_ISA naming
// the namespace, the compiler's flags for the set, and ZRAKA_WIDE where Highway's lanes are used.
#include "accel/called.hpp"
#include "engine/trace_tile.hpp"

namespace zraka::ZRAKA_ISA {

#ifdef ZRAKA_WIDE
using Lanes = WideLanes;
#else
using Lanes = ScalarLanes<double>;
#endif

// accel/called.hpp; instances come back here from engine/bodies.cpp, level by level of groups.
template <>
void find_nearest_called<Lanes>(const FrozenScene<Lanes::Real>& scene, RayGroup<Lanes>& rays) {
  find_nearest<Lanes>(scene, rays);
}
template <>
std::uint32_t find_blocked_called<Lanes>(const FrozenScene<Lanes::Real>& scene, LastBlocker& last,
                                         RayGroup<Lanes>& rays) {
  return find_blocked<Lanes>(scene, last, rays);
}

// engine/once.hpp
template void nearest_in_hierarchy<Lanes>(const FrozenScene<Lanes::Real>&, RayGroup<Lanes>&);
template std::uint32_t blocked_in_hierarchy<Lanes>(const FrozenScene<Lanes::Real>&, LastBlocker&,
                                                   RayGroup<Lanes>&);
template void trace_shadow_rays<Lanes>(const FrozenScene<Lanes::Real>&, std::size_t,
                                       Scratch<Lanes::Real>&);

void render_tile(const FrozenScene<Lanes::Real>& scene, const TraceSettings& settings,
                 const TileRect& tile, Workspace<Lanes::Real>& workspace, RayCounts& counts,
                 float* pixels, std::size_t stride) {
  trace_tile<Lanes>(scene, settings, tile, workspace, counts, pixels, stride);
}

void render_rays(const FrozenScene<Lanes::Real>& scene, const TraceSettings& settings,
                 Workspace<Lanes::Real>& workspace, RayCounts& counts) {
  workspace.levels[0].done = 0;
  counts.camera += static_cast<std::uint64_t>(workspace.levels[0].ray_count);
  trace_trees<Lanes>(scene, settings, workspace, counts);
}

extern const Services<Lanes::Real> kServices;
extern const Kernel<Lanes::Real> kKernel;
const Kernel<Lanes::Real> kKernel = {render_tile, render_rays, &kServices,
                                     static_cast<int>(Lanes::kWidth)};

}  // namespace zraka::ZRAKA_ISA
