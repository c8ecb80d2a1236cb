// SPDX-License-Identifier: Apache-2.0
// The engine once more, making one of the lab's mistakes. Compiled like kernel.cpp, for
// the portable set and for AVX2.
#include "school/mistakes/mistaken_kernel.hpp"

#include "school/mistakes/mistaken_steps.hpp"

namespace zraka::ZRAKA_ISA {

MistakenSteps steps_for(const TraceSettings& settings) {
  return {{{},
           first_of_number(settings.variation),
           second_of_number(settings.variation),
           settings.unit}};
}

void mistaken_tile(const FrozenScene<float>& scene, const TraceSettings& settings,
                   const TileRect& tile, Workspace<float>& workspace, RayCounts& counts,
                   float* pixels, std::size_t stride) {
  trace_tile<WideLanes>(scene, settings, tile, workspace, counts, pixels, stride, NoRecord{},
                        steps_for(settings));
}

// Lessons have one ray a pixel.
const Kernel<float> kMistakenKernel = {mistaken_tile, nullptr, nullptr,
                                       static_cast<int>(WideLanes::kWidth)};

}  // namespace zraka::ZRAKA_ISA
