// SPDX-License-Identifier: Apache-2.0
// Local light: Phong's model with shadow rays (sheet 3.3).
#pragma once

#include <limits>

#include "accel/traverse.hpp"
#include "engine/camera_rays.hpp"
#include "engine/engine.hpp"
#include "engine/fading.hpp"
#include "engine/indices.hpp"
#include "engine/load_rays.hpp"
#include "engine/record.hpp"
#include "engine/rules.hpp"

namespace zraka::ZRAKA_ISA {

/// Columns of the materials of kWidth hits; one row for all of them where they share it.
template <class L>
struct MaterialLanes {
  const typename L::Real* rows;
  typename L::I row;  ///< index of the row's first number
  bool shared;

  using F = typename L::F;
  ZRAKA_INLINE F operator[](int column) const {
    if (shared) return F(rows[first_lane(row) + column]);
    return L::gather(rows + column, row);
  }
  ZRAKA_INLINE V3<F> color(int column) const {
    return {(*this)[column], (*this)[column + 1], (*this)[column + 2]};
  }
};

/// The materials of hits [h, h + kWidth), of which the first n - h exist.
template <class L, class R = typename L::Real>
ZRAKA_INLINE MaterialLanes<L> load_materials(const Scratch<R>& scratch, std::size_t h,
                                             std::size_t n) {
  using I = typename L::I;
  const I first(scratch.row[h]);
  const I material = select(L::first(n - h), L::load(scratch.row + h), first);
  static_assert(kMaterialReals == 16);
  const I two = material + material, four = two + two, eight = four + four;
  return {scratch.coefficients, eight + eight, all(material == first)};
}

/// From hit to light: unit direction and distance.
template <class L>
struct ToLight {
  V3<typename L::F> direction;
  typename L::F distance;
};

template <class L, class R = typename L::Real, class Ruling = Rules>
ZRAKA_INLINE ToLight<L> towards(const FrozenLight<R>& light, const Scratch<R>& scratch,
                                std::size_t h, const Ruling& rules) {
  using F = typename L::F;
  const V3<F> way =
      broadcast<L>(light.position) -
      V3<F>{L::load(scratch.px + h), L::load(scratch.py + h), L::load(scratch.pz + h)};
  const F distance = sqrt(dot(way, way));
  return {rules.light_direction(way * (F(1) / distance), distance), distance};
}

template <class L, class R = typename L::Real>
ZRAKA_INLINE V3<typename L::F> load_normal(const Scratch<R>& scratch, std::size_t h) {
  return {L::load(scratch.nx + h), L::load(scratch.ny + h), L::load(scratch.nz + h)};
}

/// Shadow rays from the hits that face the light; scratch.lit says which hits face it.
template <class L, class R = typename L::Real, class Recorder = NoRecord, class Ruling = Rules>
std::size_t make_shadow_rays(const FrozenLight<R>& light, std::size_t n, Scratch<R>& scratch,
                             const Recorder& record = {}, const Ruling& rules = {}) {
  using F = typename L::F;
  std::size_t shadow_rays = 0;
  for (std::size_t h = 0; h < n; h += L::kWidth) {
    const V3<F> normal = load_normal<L>(scratch, h);
    const ToLight<L> light_way = towards<L>(light, scratch, h, rules);
    const F l_n = dot(light_way.direction, normal);
    auto facing = both(rules.faces(l_n), L::first(n - h));
    if (light.fading.any) {
      const F strength =
          strength_at<L>(light.fading, light_way.direction, light_way.distance);
      L::store(strength, scratch.strength + h);
      record.keep(Quantity::strength, h, strength);
      // Outside of a cone is no light to be blocked.
      if (light.fading.has_cone) facing = both(facing, strength > F(0));
    }
    record.keep(Quantity::to_light, h, light_way.direction);
    record.keep(Quantity::light_distance, h, light_way.distance);
    record.keep(Quantity::l_n, h, l_n);
    const F offset = L::load(scratch.offset + h);
    L::store(light_way.direction.x, scratch.lx + h);
    L::store(light_way.direction.y, scratch.ly + h);
    L::store(light_way.direction.z, scratch.lz + h);
    L::store(select(facing, F(1), F(0)), scratch.lit + h);
    L::compress_store(L::load(scratch.px + h) + normal.x * offset, facing,
                      scratch.sox + shadow_rays);
    L::compress_store(L::load(scratch.py + h) + normal.y * offset, facing,
                      scratch.soy + shadow_rays);
    L::compress_store(L::load(scratch.pz + h) + normal.z * offset, facing,
                      scratch.soz + shadow_rays);
    L::compress_store(light_way.direction.x, facing, scratch.sdx + shadow_rays);
    L::compress_store(light_way.direction.y, facing, scratch.sdy + shadow_rays);
    L::compress_store(light_way.direction.z, facing, scratch.sdz + shadow_rays);
    L::compress_store(rules.shadow_ray_length(light_way.distance), facing,
                      scratch.sdistance + shadow_rays);
    L::compress_store(L::iota(static_cast<std::int32_t>(h)), facing,
                      scratch.shadow_ray_hit + shadow_rays);
    shadow_rays += count(facing);
  }
  return shadow_rays;
}

/// Marks as occluded the hits whose shadow ray hits a shape before the light.
template <class L, class R = typename L::Real>
void trace_shadow_rays(const FrozenScene<R>& scene, std::size_t shadow_rays, Scratch<R>& scratch) {
  using F = typename L::F;
  LastBlocker last;
  for (std::size_t first = 0; first < shadow_rays; first += RayGroup<L>::kRays) {
    RayGroup<L> rays = group_of_shadow_rays<L>(scratch, first, shadow_rays);
    const std::uint32_t blocked = find_blocked<L>(scene, last, rays);
    if (blocked == 0) continue;
    for (std::size_t r = 0; r < kRegisters<L>; ++r)
      if (const auto lanes = lanes_of<L>(blocked, r); any(lanes))
        Indices<L>(L::load(scratch.shadow_ray_hit + first + r * L::kWidth))
            .store(F(0), lanes, scratch.lit);
  }
}

/// N·H, H halfway between light and viewer (Blinn 1977); 0 where these are opposite.
template <class F>
ZRAKA_INLINE F n_h(const V3<F>& normal, const V3<F>& l, const V3<F>& v) {
  const V3<F> half = l + v;
  return dot(normal, half) / sqrt(max(dot(half, half), F(std::numeric_limits<float>::min())));
}

/// Adds one light's diffuse and specular terms to the hits that it reaches.
template <class L, class R = typename L::Real, class Recorder = NoRecord, class Ruling = Rules>
void add_light(const FrozenLight<R>& light, const Terms& terms, Level<R>& level,
               const Scratch<R>& scratch, const Recorder& record = {}, const Ruling& rules = {}) {
  using F = typename L::F;
  const auto n = static_cast<std::size_t>(level.hit_count);
  const V3<F> color = broadcast<L>(light.color);
  for (std::size_t h = 0; h < n; h += L::kWidth) {
    const auto exists = L::first(n - h);
    const auto lit = both(L::load(scratch.lit + h) > F(0), exists);
    if (!Recorder::kKeeps && !any(lit)) continue;
    const auto material = load_materials<L>(scratch, h, n);
    const V3<F> normal = load_normal<L>(scratch, h);
    const V3<F> l{L::load(scratch.lx + h), L::load(scratch.ly + h), L::load(scratch.lz + h)};
    const F l_n = dot(l, normal);
    const V3<F> intensity =
        light.fading.any ? color * L::load(scratch.strength + h) : color;
    V3<F> sum{L::load(level.hits.r + h), L::load(level.hits.g + h), L::load(level.hits.b + h)};
    if (terms.diffuse) {
      const V3<F> diffuse = intensity * material.color(kDiffuse) * rules.diffuse_factor(l_n);
      record.keep(Quantity::diffuse, h, diffuse);
      const V3<F> more = sum + diffuse;
      sum = {select(lit, more.x, sum.x), select(lit, more.y, sum.y), select(lit, more.z, sum.z)};
    }
    const V3<F> ks = material.color(kSpecular);
    const auto dull = both(ks.x == F(0), both(ks.y == F(0), ks.z == F(0)));
    if (terms.specular && (Recorder::kKeeps || !all(dull))) {
      const V3<F> v{L::load(scratch.vx + h), L::load(scratch.vy + h), L::load(scratch.vz + h)};
      const V3<F> r = rules.mirrored(l, normal, l_n);
      F r_v = rules.r_v(r, v, l, normal, [&] {
        const auto first = typename L::I(level.hits.ray[h]);
        return Indices<L>(select(exists, L::load(level.hits.ray + h), first)).load(scratch.t);
      });
      if (const auto blinn = material[kBlinn] > F(0); any(blinn))
        r_v = select(blinn, n_h(normal, l, v), r_v);
      const auto shines = both(lit, rules.shines(r_v));
      record.keep(Quantity::mirrored, h, r);
      record.keep(Quantity::r_v, h, r_v);
      record.keep(Quantity::shines, h, select(shines, F(1), F(0)));
      if (any(shines)) {
        const F highlight = rules.highlight(r_v, material[kShininess]);
        const V3<F> specular = intensity * ks * highlight;
        record.keep(Quantity::highlight, h, highlight);
        record.keep(Quantity::specular, h, specular);
        const V3<F> more = sum + specular;
        const auto adds = but_not(shines, dull);
        sum = {select(adds, more.x, sum.x), select(adds, more.y, sum.y),
               select(adds, more.z, sum.z)};
      }
    }
    L::store(sum.x, level.hits.r + h);
    L::store(sum.y, level.hits.g + h);
    L::store(sum.z, level.hits.b + h);
  }
}

/// The ambient term, or white for a silhouette.
template <class L, class R = typename L::Real>
void start_local(const FrozenScene<R>& scene, const Terms& terms, Level<R>& level,
                 const Scratch<R>& scratch) {
  using F = typename L::F;
  const auto n = static_cast<std::size_t>(level.hit_count);
  const V3<F> ambient_light = broadcast<L>(scene.ambient_light);
  const F plain(terms.silhouette ? R(1) : R(0));
  for (std::size_t h = 0; h < n; h += L::kWidth) {
    V3<F> local{plain, plain, plain};
    if (terms.ambient && !terms.silhouette)
      local = ambient_light * load_materials<L>(scratch, h, n).color(kAmbient);
    L::store(local.x, level.hits.r + h);
    L::store(local.y, level.hits.g + h);
    L::store(local.z, level.hits.b + h);
  }
}

/// I = Ia·ka + for each light that reaches the hit: Ii·kd·(L·N) + Ii·ks·(R·V)^n, or, where the
/// material says so, (N·H)^n.
template <class L, class R = typename L::Real, class Recorder, class Stepping>
void light_hits(const FrozenScene<R>& scene, const TraceSettings& settings, Level<R>& level,
                Scratch<R>& scratch, RayCounts& counts, const Recorder& record,
                const Stepping& steps) {
  const Terms& terms = settings.terms;
  start_local<L>(scene, terms, level, scratch);
  record.hits(level, scratch);
  if (terms.silhouette || !(terms.diffuse || terms.specular)) return;
  for (std::int32_t i = 0; i < scene.light_count; ++i) {
    const auto n = static_cast<std::size_t>(level.hit_count);
    const std::size_t shadow_rays = make_shadow_rays<L>(scene.lights[i], n, scratch, record, steps);
    if (terms.shadows) {
      steps.template trace_shadow_rays<L>(scene, shadow_rays, scratch);
      counts.shadow += shadow_rays;
    }
    steps.template add_light<L>(scene.lights[i], terms, level, scratch, record, steps);
    record.light(scene, i, shadow_rays, level, scratch);
  }
}

}  // namespace zraka::ZRAKA_ISA
