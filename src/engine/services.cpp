// SPDX-License-Identifier: Apache-2.0
// What the general engine asks of one instruction set. CMake compiles this file once for each, like
// engine/kernel.cpp.
#include "engine/coefficients.hpp"
#include "engine/drawn_rays.hpp"
#include "engine/hemisphere.hpp"
#include "engine/hits.hpp"
#include "engine/light_samples.hpp"
#include "engine/point_shadows.hpp"
#include "engine/shading.hpp"
#include "engine/steps.hpp"

namespace zraka::ZRAKA_ISA {
namespace {

#ifdef ZRAKA_WIDE
using Lanes = WideLanes;
#else
using Lanes = ScalarLanes<double>;
#endif

void find_hits(const FrozenScene<Lanes::Real>& scene, Level<Lanes::Real>& level,
               Scratch<Lanes::Real>& scratch) {
  // As the lean engine calls them, so that they are compiled for both.
  const Steps steps;
  trace_nearest<Lanes>(scene, level, scratch, steps);
  find_surfaces<Lanes>(scene, level, scratch, steps);
}

void make_rays(const FrozenCamera<Lanes::Real>& camera, const InverseFilter* filter,
               const SampleRuns& runs, std::size_t n, RayArrays<Lanes::Real>& rays,
               std::uint8_t* negative) {
  make_window_rays(camera, filter, runs, n, rays, negative);
}

}  // namespace

extern const HitServices<Lanes::Real> kHitServices;
extern const Services<Lanes::Real> kServices;
const Services<Lanes::Real> kServices = {find_hits, find_blocked_in_order<Lanes>,
                                         find_blocked_as_listed<Lanes>,
                                         find_blocked_from_points<Lanes>,
                                         make_hemisphere<Lanes::Real>,
                                         find_arriving<Lanes>,
                                         sample_light<Lanes>,
                                         find_highlights<Lanes>, make_rays,
                                         drop_blocked<Lanes>, &kHitServices, color_hits<Lanes>};

}  // namespace zraka::ZRAKA_ISA
