// SPDX-License-Identifier: Apache-2.0
// The engine once more, making one of the lab's mistakes. Compiled like kernel.cpp, for the
// portable set, whose bits are those of all others.
#include "engine/mistaken_rules.hpp"
#include "engine/trace_tile.hpp"

namespace zraka::ZRAKA_ISA {

void mistaken_tile(const FrozenScene<float>& scene, const TraceSettings& settings,
                   const TileRect& tile, Workspace<float>& workspace, RayCounts& counts,
                   float* pixels, std::size_t stride) {
  trace_tile<WideLanes>(scene, settings, tile, workspace, counts, pixels, stride, NoRecord{},
                        MistakenRules{{}, settings.mistake, settings.unit});
}

extern const Kernel<float> kMistakenKernel;
const Kernel<float> kMistakenKernel = {mistaken_tile, static_cast<int>(WideLanes::kWidth)};

}  // namespace zraka::ZRAKA_ISA
