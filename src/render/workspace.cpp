// SPDX-License-Identifier: Apache-2.0
#include "render/workspace.hpp"

#include <algorithm>
#include <new>

#include "scene/reals.hpp"

namespace zraka {
namespace {

constexpr std::size_t kCacheLine = 64;

/// Hands out arrays one after the other; with a null base it only counts.
class Layout {
 public:
  explicit Layout(std::byte* base) : base_(base) {}
  std::size_t used() const { return used_; }

  template <class T, class... More>
  void place(std::size_t count, T*& array, More*&... more) {
    array = base_ == nullptr ? nullptr : reinterpret_cast<T*>(base_ + used_);
    const std::size_t bytes = (count + kArrayPadding) * sizeof(T);
    used_ += (bytes + kCacheLine - 1) / kCacheLine * kCacheLine;
    if constexpr (sizeof...(more) > 0) place(count, more...);
  }

 private:
  std::byte* base_;
  std::size_t used_ = 0;
};

template <class R>
void place_all(Layout& layout, Level<R>* levels, Workspace<R>& workspace,
               const WorkspaceNeeds& needs) {
  const auto batch = static_cast<std::size_t>(needs.batch);
  Scratch<R>& s = workspace.scratch;
  s.explained = needs.explained;
  layout.place(batch, s.t, s.px, s.py, s.pz, s.nx, s.ny, s.nz, s.vx, s.vy, s.vz, s.offset, s.inside,
               s.lx, s.ly, s.lz, s.lit, s.strength, s.mirror_side);
  const auto shadow_rays = static_cast<std::size_t>(std::max(needs.batch, needs.shadow_rays));
  layout.place(shadow_rays, s.sox, s.soy, s.soz, s.sdx, s.sdy, s.sdz, s.sdistance);
  layout.place(shadow_rays, s.shadow_ray_hit);
  layout.place(batch, s.slot, s.material);
  layout.place(batch, workspace.samples);
  if (needs.textured) {
    layout.place(batch * kMaterialReals, s.own_rows);
    layout.place(batch, s.own_row);
    layout.place(batch, s.cones);
    if (needs.explained) layout.place(batch, s.points);
  }
  if (needs.textured || needs.general) layout.place(batch, s.paths);
  if (needs.general) layout.place(shadow_rays, s.part, s.blocked, s.shadow_order);
  if (needs.recorded) layout.place(batch, s.smooth_x, s.smooth_y, s.smooth_z);
  const std::size_t rays_of_level = batch * static_cast<std::size_t>(needs.children);
  for (int i = 0; i <= needs.max_depth; ++i) {
    RayArrays<R>& rays = levels[i].rays;
    layout.place(rays_of_level, rays.ox, rays.oy, rays.oz, rays.dx, rays.dy, rays.dz, rays.r,
                 rays.g, rays.b);
    HitArrays<R>& hits = levels[i].hits;
    layout.place(batch, hits.r, hits.g, hits.b, hits.reflection, hits.refraction);
    layout.place(batch, hits.ray, hits.reflected, hits.refracted);
    if (needs.textured) layout.place(rays_of_level, rays.width, rays.spread, rays.travelled);
  }
}

}  // namespace

template <class R>
void WorkspaceMemory<R>::Free::operator()(std::byte* p) const {
  ::operator delete[](p, std::align_val_t{kCacheLine});
}

template <class R>
WorkspaceMemory<R>::WorkspaceMemory(const WorkspaceNeeds& needs)
    : levels_(std::make_unique<Level<R>[]>(static_cast<std::size_t>(needs.max_depth) + 1)) {
  Layout sizes(nullptr);
  place_all(sizes, levels_.get(), workspace_, needs);
  memory_.reset(
      static_cast<std::byte*>(::operator new[](sizes.used(), std::align_val_t{kCacheLine})));
  Layout layout(memory_.get());
  place_all(layout, levels_.get(), workspace_, needs);
  if (needs.textured)
    for (std::int32_t i = 0; i < needs.batch; ++i) workspace_.scratch.own_row[i] = i;
  workspace_.levels = levels_.get();
  workspace_.batch = needs.batch;
}

#define ZRAKA_FOR(R) template class WorkspaceMemory<R>;
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka
