// SPDX-License-Identifier: Apache-2.0
// First hits for one instruction set. CMake compiles this file once for each, like
// engine/kernel.cpp.
#include "engine/first_hits.hpp"

#include "accel/group_rays.hpp"
#include "engine/camera_rays.hpp"
#include "engine/hits.hpp"

namespace zraka::ZRAKA_ISA {

#ifdef ZRAKA_WIDE
using Lanes = WideLanes;
#else
using Lanes = ScalarLanes<double>;
#endif
using R = Lanes::Real;

namespace {

/// The traversal that the kernel has compiled for groups serves the scene as well.
struct CompiledTraversal : Rules {
  template <class L, class Scene>
  void find_nearest(const Scene& scene, RayGroup<L>& rays) const {
    nearest_in_group<L>(scene, rays);
  }
};

}  // namespace

void trace_first_hits(const FrozenScene<R>& scene, Workspace<R>& workspace) {
  Level<R>& level = workspace.levels[0];
  level.done = 0;
  level.in_batch = level.ray_count;
  trace_nearest<Lanes>(scene, level, workspace.scratch, CompiledTraversal());
  find_surfaces<Lanes>(scene, level, workspace.scratch);
}

void trace_first_hits_of_tile(const FrozenScene<R>& scene, const TileRect& tile,
                              Workspace<R>& workspace) {
  make_camera_rays<Lanes>(scene.camera, tile, workspace.levels[0]);
  CameraSample* sample = workspace.samples;
  each_pixel(tile, [&](std::int32_t x, std::int32_t y) {
    *sample++ = {tile.x + x, tile.y + y, 0};
  });
  trace_first_hits(scene, workspace);
}

}  // namespace zraka::ZRAKA_ISA
