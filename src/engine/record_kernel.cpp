// SPDX-License-Identifier: Apache-2.0
// The engine once more, telling its terms. Compiled like kernel.cpp, for the portable set, whose
// bits are those of all others; and apart from it, so that the renderer's code stays what it is.
#include "engine/once.hpp"

namespace zraka::ZRAKA_ISA {

void record_tile(const FrozenScene<float>& scene, const TraceSettings& settings,
                 const TileRect& tile, Workspace<float>& workspace, RayCounts& counts,
                 float* pixels, std::size_t stride, Recording<float>& recording) {
  trace_tile<WideLanes>(scene, settings, tile, workspace, counts, pixels, stride,
                        Record<WideLanes>(recording));
}

void record_rays(const FrozenScene<float>& scene, const TraceSettings& settings,
                 Workspace<float>& workspace, RayCounts& counts, Recording<float>& recording) {
  workspace.levels[0].done = 0;
  counts.camera += static_cast<std::uint64_t>(workspace.levels[0].ray_count);
  trace_trees<WideLanes>(scene, settings, workspace, counts, Record<WideLanes>(recording));
}

}  // namespace zraka::ZRAKA_ISA
