// SPDX-License-Identifier: Apache-2.0
// What the general engine asks of one instruction set. CMake compiles this file once for each, like
// engine/kernel.cpp.
#include "engine/hits.hpp"
#include "engine/light.hpp"

namespace zraka::ZRAKA_ISA {
namespace {

#ifdef ZRAKA_WIDE
using Lanes = WideLanes;
#else
using Lanes = ScalarLanes<double>;
#endif

void find_hits(const FrozenScene<Lanes::Real>& scene, Level<Lanes::Real>& level,
               Scratch<Lanes::Real>& scratch) {
  trace_nearest<Lanes>(scene, level, scratch);
  find_surfaces<Lanes>(scene, level, scratch);
}

void find_blocked_rays(const FrozenScene<Lanes::Real>& scene, std::size_t n,
                       Scratch<Lanes::Real>& scratch) {
  LastBlocker last;
  for (std::size_t first = 0; first < n; first += RayGroup<Lanes>::kRays) {
    RayGroup<Lanes> rays = group_of_shadow_rays<Lanes>(scratch, first, n);
    const std::uint32_t blocked = find_blocked<Lanes>(scene, last, rays);
    const std::size_t count = n - first < RayGroup<Lanes>::kRays ? n - first : RayGroup<Lanes>::kRays;
    for (std::size_t i = 0; i < count; ++i)
      scratch.blocked[first + i] = static_cast<std::int32_t>(blocked >> i & 1);
  }
}

}  // namespace

extern const Services<Lanes::Real> kServices;
const Services<Lanes::Real> kServices = {find_hits, find_blocked_rays};

}  // namespace zraka::ZRAKA_ISA
