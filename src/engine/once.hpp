// SPDX-License-Identifier: Apache-2.0
// What is compiled once for an instruction set, in engine/kernel.cpp: whoever else traces with its
// lanes calls it there. Compiled again, and perhaps optimised less, either might be linked for both.
#pragma once

#include "engine/trace_tile.hpp"

namespace zraka::ZRAKA_ISA {

extern template void nearest_in_hierarchy<WideLanes>(const FrozenScene<float>&,
                                                     RayGroup<WideLanes>&);
extern template std::uint32_t blocked_in_hierarchy<WideLanes>(const FrozenScene<float>&,
                                                              LastBlocker&, RayGroup<WideLanes>&);
extern template void trace_shadow_rays<WideLanes>(const FrozenScene<float>&, std::size_t,
                                                  Scratch<float>&);
extern template void color_hits<WideLanes>(const HitsOfMaterial&, const Level<float>&,
                                           Scratch<float>&);

}  // namespace zraka::ZRAKA_ISA
