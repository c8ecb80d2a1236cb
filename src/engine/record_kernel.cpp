// SPDX-License-Identifier: Apache-2.0
// The engine once more for one instruction set, telling its terms. Compiled like kernel.cpp, and
// apart from it, so that the renderer's code stays what it is.
#include "engine/trace_tile.hpp"

namespace zraka::ZRAKA_ISA {

#ifdef ZRAKA_WIDE
using Lanes = WideLanes;
#else
using Lanes = ScalarLanes<double>;
#endif

void record_tile(const FrozenScene<Lanes::Real>& scene, const TraceSettings& settings,
                 const TileRect& tile, Workspace<Lanes::Real>& workspace, RayCounts& counts,
                 float* pixels, std::size_t stride, Recording<Lanes::Real>& recording) {
  trace_tile<Lanes>(scene, settings, tile, workspace, counts, pixels, stride,
                    Record<Lanes>(recording));
}

}  // namespace zraka::ZRAKA_ISA
