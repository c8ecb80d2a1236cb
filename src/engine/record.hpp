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
  Recording<R>& to_;
};

}  // namespace zraka::ZRAKA_ISA
