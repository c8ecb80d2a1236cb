// SPDX-License-Identifier: Apache-2.0
// Steps that go wrong as a whole; mistakes of one quantity are MistakenRules.
#pragma once

#include "engine/indices.hpp"
#include "engine/load_rays.hpp"
#include "engine/once.hpp"
#include "school/mistakes/mistaken_rules.hpp"

namespace zraka::ZRAKA_ISA {

struct MistakenSteps : MistakenRules {
  template <class L, class R>
  void trace_shadow_rays(const FrozenScene<R>& scene, std::size_t shadow_rays,
                         Scratch<R>& scratch) const {
    ZRAKA_ISA::trace_shadow_rays<L>(scene, shadow_rays, scratch);
    if (is(Mistake::shadows_at_first)) light_later_hits(scene, shadow_rays, scratch);
    if (is(Mistake::feeler_overwrites)) move_hits_to_blockers<L>(scene, shadow_rays, scratch);
  }

  template <class L, class R, class Recorder, class Ruling>
  void add_light(const FrozenLight<R>& light, const Terms& terms,
                 Level<R>& level, Scratch<R>& scratch, const Recorder& record,
                 const Ruling& rules) const {
    if (is(Mistake::shadow_takes_ambient)) blacken_shadows<L>(level, scratch);
    if (is(Mistake::shadow_half)) add_half_light<L>(light, terms, level, scratch, rules);
    if (!is(Mistake::shadow_leaves_specular)) {
      ZRAKA_ISA::add_light<L>(light, terms, level, scratch, record, rules);
      return;
    }
    Terms first = terms, second = terms;
    first.specular = second.diffuse = false;
    ZRAKA_ISA::add_light<L>(light, first, level, scratch, record, rules);
    // Blocked hits count as lit for the highlight, and are blocked again then.
    const auto n = static_cast<std::size_t>(level.hit_count);
    for (std::size_t h = 0; h < n; ++h)
      if (faces_light(scratch, h) && !(scratch.lit[h] > 0)) scratch.lit[h] = R(0.5);
    ZRAKA_ISA::add_light<L>(light, second, level, scratch, record, rules);
    for (std::size_t h = 0; h < n; ++h)
      if (scratch.lit[h] == R(0.5)) scratch.lit[h] = R(0);
  }

  template <class L, class R, class Recorder, class Ruling>
  void spawn_reflected(const TraceSettings& settings, Level<R>& level,
                       const Scratch<R>& scratch, Level<R>& next, RayCounts& counts,
                       const Recorder& record, const Ruling& rules) const {
    ZRAKA_ISA::spawn_reflected<L>(settings, level, scratch, next, counts, record, rules);
    if (is(Mistake::total_white) && settings.terms.refraction)
      whiten_total_reflection<L>(level, scratch);
  }

 private:
  template <class R>
  static bool faces_light(const Scratch<R>& s, std::size_t h) {
    return s.lx[h] * s.nx[h] + s.ly[h] * s.ny[h] + s.lz[h] * s.nz[h] >= 0;
  }

  /// Hits that are not seen from the eye count as lit, whatever lies before the light.
  template <class R>
  static void light_later_hits(const FrozenScene<R>& scene, std::size_t shadow_rays,
                               Scratch<R>& scratch) {
    for (std::size_t i = 0; i < shadow_rays; ++i) {
      const auto h = static_cast<std::size_t>(scratch.shadow_ray_hit[i]);
      const R x = scratch.px[h] - scene.camera.eye.x, y = scratch.py[h] - scene.camera.eye.y,
              z = scratch.pz[h] - scene.camera.eye.z;
      const R along = -(x * scratch.vx[h] + y * scratch.vy[h] + z * scratch.vz[h]);
      const R squared = x * x + y * y + z * z;
      const bool seen = along > 0 && along * along >= squared * R(0.99999);
      if (seen) continue;
      scratch.lit[h] = R(1);
      scratch.sdistance[i] = R(0);  // what is recorded of the ray blocks it nowhere
    }
  }

  /// Half of a light for the hits that it does not reach.
  template <class L, class R, class Ruling>
  static void add_half_light(const FrozenLight<R>& light, const Terms& terms, Level<R>& level,
                             Scratch<R>& scratch, const Ruling& rules) {
    const auto n = static_cast<std::size_t>(level.hit_count);
    for (std::size_t h = 0; h < n; ++h)
      scratch.lit[h] = scratch.lit[h] > 0 ? R(-1) : faces_light(scratch, h) ? R(1) : R(0);
    FrozenLight<R> half = light;
    half.color = half.color * R(0.5);
    ZRAKA_ISA::add_light<L>(half, terms, level, scratch, NoRecord{}, rules);
    for (std::size_t h = 0; h < n; ++h) scratch.lit[h] = scratch.lit[h] < 0 ? R(1) : R(0);
  }

  /// The stored hit becomes the one that its shadow ray has found.
  template <class L, class R>
  void move_hits_to_blockers(const FrozenScene<R>& scene, std::size_t shadow_rays,
                             Scratch<R>& scratch) const {
    using F = typename L::F;
    for (std::size_t first = 0; first < shadow_rays; first += RayGroup<L>::kRays) {
      RayGroup<L> rays = group_of_shadow_rays<L>(scratch, first, shadow_rays);
      ZRAKA_ISA::find_nearest<L>(scene, rays);
      each_register(rays, first, shadow_rays,
                    [&](std::size_t i, const RayLanes<L>& ray, typename L::M active) {
                      const V3<F> point = ray.origin + ray.direction * ray.t;
                      const Indices<L> hit(L::load(scratch.shadow_ray_hit + i));
                      const auto blocked = both(ray.slot >= typename L::I(0), active);
                      hit.store(point.x, blocked, scratch.px);
                      hit.store(point.y, blocked, scratch.py);
                      hit.store(point.z, blocked, scratch.pz);
                    });
    }
  }

  /// Hits that face the light and are blocked lose all local light.
  template <class L, class R>
  static void blacken_shadows(Level<R>& level, const Scratch<R>& scratch) {
    for (std::size_t h = 0; h < static_cast<std::size_t>(level.hit_count); ++h)
      if (faces_light(scratch, h) && !(scratch.lit[h] > 0))
        level.hits.r[h] = level.hits.g[h] = level.hits.b[h] = R(0);
  }

  /// Total internal reflection adds white in the share of the ray that cannot be.
  template <class L, class R>
  void whiten_total_reflection(Level<R>& level, const Scratch<R>& scratch) const {
    using F = typename L::F;
    const auto n = static_cast<std::size_t>(level.hit_count);
    for (std::size_t h = 0; h < n; h += L::kWidth) {
      const auto material = load_materials<L>(scratch, h, n);
      const HitLanes<L> hit = HitLanes<L>(scratch, h).for_refraction(scratch, h, *this);
      const Snell<L> snell(material, scratch, h, refraction_cosine(hit.cosine), *this);
      const F white = select(snell.d >= F(0), F(0), material[kRefraction]);
      for (R* channel : {level.hits.r, level.hits.g, level.hits.b})
        L::store(L::load(channel + h) + white, channel + h);
    }
  }
};

}  // namespace zraka::ZRAKA_ISA
