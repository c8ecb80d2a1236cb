// SPDX-License-Identifier: Apache-2.0
// How the steps tell what they compute on their way. Rendering tells nobody: NoRecord's functions
// are empty and vanish. Explaining runs the same lines with a Record, which keeps the terms by hit.
#pragma once

#include "accel/traverse.hpp"
#include "engine/engine.hpp"
#include "engine/load_rays.hpp"
#include "engine/surfaces.hpp"

namespace zraka::ZRAKA_ISA {

struct NoRecord {
  static constexpr bool kKeeps = false;
  template <class Value>
  ZRAKA_INLINE void keep(Quantity, std::size_t, const Value&) const {}
  template <class... Arrays>
  ZRAKA_INLINE void hits(const Arrays&...) const {}
  template <class... Arrays>
  ZRAKA_INLINE void light(const Arrays&...) const {}
  template <class... Arrays>
  ZRAKA_INLINE void children(const Arrays&...) const {}
  template <class... Arrays>
  ZRAKA_INLINE void folded(const Arrays&...) const {}
  ZRAKA_INLINE bool goes_on() const { return true; }
};

template <class L>
class Record {
 public:
  using R = typename L::Real;
  using F = typename L::F;
  static constexpr bool kKeeps = true;

  explicit Record(Recording<R>& recording) : to_(recording) {}

  /// The values of hits [h, h + kWidth).
  ZRAKA_INLINE void keep(Quantity term, std::size_t h, const F& value) const {
    L::store(value, to_.terms[static_cast<int>(term)] + h);
  }
  ZRAKA_INLINE void keep(Quantity term, std::size_t h, const V3<F>& value) const {
    const int first = static_cast<int>(term);
    L::store(value.x, to_.terms[first] + h);
    L::store(value.y, to_.terms[first + 1] + h);
    L::store(value.z, to_.terms[first + 2] + h);
  }

  void hits(const Level<R>& level, const Scratch<R>& scratch) const {
    to_.at_hits(to_.reader, level, scratch);
  }

  /// A shadow ray stops at any shape; who wants an explanation wants the one nearest to the hit.
  void light(const FrozenScene<R>& scene, std::int32_t light, std::size_t shadow_rays,
             const Level<R>& level, const Scratch<R>& scratch) const {
    for (std::size_t first = 0; first < shadow_rays; first += RayGroup<L>::kRays) {
      RayGroup<L> rays = group_of_shadow_rays<L>(scratch, first, shadow_rays);
      find_nearest<L>(scene, rays);
      if (scene.shadowless != nullptr)
        for (std::size_t r = 0; r < kRegisters<L>; ++r) look_behind(scene, rays, r);
      each_register(rays, first, shadow_rays, [&](std::size_t i, const RayLanes<L>& ray, auto) {
        L::store(ray.t, to_.blocker_t + i);
        L::store(ray.slot, to_.blocker + i);
        if (to_.blocker_path != nullptr && scene.bodies.count > 0)
          surfaces_at<L>(scene, ray.slot, ray.origin, ray.direction, ray.t, to_.blocker_path + i);
      });
    }
    to_.at_light(to_.reader, light, shadow_rays, level, scratch);
  }

  void children(const Level<R>& level, const Level<R>& next) const {
    to_.at_children(to_.reader, level, next);
  }
  void folded(const Level<R>& level) const { to_.at_fold(to_.reader, level); }
  ZRAKA_INLINE bool goes_on() const { return !to_.stop; }

 private:
  /// Which hits are on shapes that throw no shadow.
  static typename L::M on_shadowless(const FrozenScene<R>& scene, typename L::I slot,
                                     typename L::I material) {
    alignas(64) std::int32_t slots[L::kWidth], materials[L::kWidth];
    L::store(slot, slots);
    L::store(material, materials);
    std::uint32_t lanes = 0;
    for (std::size_t i = 0; i < L::kWidth; ++i)
      lanes |= slots[i] >= 0 && scene.shadowless[materials[i]] != 0 ? 1u << i : 0u;
    return L::from_bits(lanes);
  }

  /// Where a register's rays have hit shapes that throw no shadow, what they hit behind these.
  static void look_behind(const FrozenScene<R>& scene, RayGroup<L>& rays, std::size_t r) {
    RayLanes<L> part = rays.ray[r];  // from where it went through a shape
    F walked(0);
    typename L::M lanes = rays.active[r];
    for (;;) {
      const Surfaces<L> hit = surfaces_at<L>(scene, part.slot, part.origin, part.direction, part.t,
                                             static_cast<HitPath*>(nullptr));
      lanes = both(lanes, on_shadowless(scene, part.slot, hit.material));
      if (!any(lanes)) return;
      const V3<F> ahead =
          hit.at.point + hit.at.normal * select(hit.at.inside, hit.at.offset, -hit.at.offset);
      part.origin = {select(lanes, ahead.x, part.origin.x), select(lanes, ahead.y, part.origin.y),
                     select(lanes, ahead.z, part.origin.z)};
      walked = select(lanes, walked + part.t, walked);
      RayGroup<L> behind;
      for (std::size_t i = 0; i < kRegisters<L>; ++i) {
        behind.ray[i] = {part.origin, part.direction, F(kFarAway<R>), typename L::I(-1)};
        behind.active[i] = i == 0 ? lanes : L::first(0);
      }
      find_nearest<L>(scene, behind);
      part.t = select(lanes, behind.ray[0].t, part.t);
      part.slot = select(lanes, behind.ray[0].slot, part.slot);
      rays.ray[r].t = select(lanes, walked + part.t, rays.ray[r].t);
      rays.ray[r].slot = select(lanes, part.slot, rays.ray[r].slot);
    }
  }

  Recording<R>& to_;
};

}  // namespace zraka::ZRAKA_ISA
