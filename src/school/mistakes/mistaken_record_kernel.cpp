// SPDX-License-Identifier: Apache-2.0
// The engine that makes mistakes once more, telling its terms.
#include "school/mistakes/mistaken_kernel.hpp"
#include "school/mistakes/mistaken_steps.hpp"

namespace zraka::ZRAKA_ISA {

void record_mistaken_tile(const FrozenScene<float>& scene, const TraceSettings& settings,
                          const TileRect& tile, Workspace<float>& workspace, RayCounts& counts,
                          float* pixels, std::size_t stride, Recording<float>& recording) {
  trace_tile<WideLanes>(
      scene, settings, tile, workspace, counts, pixels, stride, Record<WideLanes>(recording),
      MistakenSteps{{{},
                     first_of_number(settings.variation),
                     second_of_number(settings.variation),
                     settings.unit}});
}

}  // namespace zraka::ZRAKA_ISA
