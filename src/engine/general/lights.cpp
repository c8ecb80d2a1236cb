// SPDX-License-Identifier: Apache-2.0
// Local light of the general engine: lights of all kinds.
#include "engine/general/lights.hpp"

#include <limits>

#include "sampling/hash.hpp"
#include "sampling/sobol.hpp"
#include "sampling/warp.hpp"

namespace zraka::general {
namespace {

/// What a light sends to a point, from one of its samples.
struct Arriving {
  V3<double> to_light;  ///< unit length
  double distance;      ///< infinite for directional light
  double strength;      ///< attenuation and the spot's cone
};

/// x²(3 - 2x) between 0 and 1.
double smooth(double x) {
  const double t = std::fmin(std::fmax(x, 0.0), 1.0);
  return t * t * (3 - 2 * t);
}

Arriving arriving(const OpticalLight& light, const V3<double>& point, const Point2& at) {
  if (light.kind == LightKind::directional)
    return {-light.direction, std::numeric_limits<double>::infinity(), 1};
  V3<double> from = light.position;
  if (light.kind == LightKind::rectangle) {
    from = from + light.edge_u * at.u + light.edge_v * at.v;
  } else if (light.kind == LightKind::disc) {
    const DiscPoint on = quick_concentric_disc(at);
    from = from + light.edge_u * on.x + light.edge_v * on.y;
  } else if (light.kind == LightKind::sphere) {
    // The disc that it looks like from the point.
    const V3<double> way = from - point;
    const double away = std::sqrt(dot(way, way));
    if (away > light.radius) {
      V3<double> a{}, b{};
      const V3<double> axis = way * (1 / away);
      basis_of(axis, a, b);
      const DiscPoint on = quick_concentric_disc(at);
      const double sine = light.radius / away, cosine = std::sqrt(1 - sine * sine);
      // Where the cone around it touches it.
      from = from - axis * (light.radius * sine) +
             (a * on.x + b * on.y) * (light.radius * cosine);
    }
  }
  const V3<double> way = from - point;
  const double distance = std::sqrt(dot(way, way));
  if (!(distance > 0)) return {{0, 0, 0}, 0, 0};
  Arriving arrives{way * (1 / distance), distance, 1};
  const double fading =
      light.constant + light.linear * distance + light.quadratic * distance * distance;
  if (fading != 1) arrives.strength = 1 / fading;
  if (light.kind == LightKind::spot) {
    const double cosine = -dot(arrives.to_light, light.direction);
    const double span = light.cos_inner - light.cos_outer;
    if (light.linear_edge && light.outer > light.inner)
      arrives.strength *= linear_edge(light, cosine);
    else
      arrives.strength *= span > 0 ? smooth((cosine - light.cos_outer) / span)
                                   : (cosine >= light.cos_outer ? 1.0 : 0.0);
  }
  return arrives;
}

/// Whether light from there adds anything, if it arrives: clear glass shines where it mirrors the
/// light, and nowhere else. The direction is in the engine's own numbers, as for highlights later.
template <class R>
bool counts(const Batch<R>& batch, std::size_t h, const V3<R>& own, double l_n) {
  const R* const row = batch.row(h);
  const auto is_dark = [&](int column) {
    return row[column] == R(0) && row[column + 1] == R(0) && row[column + 2] == R(0);
  };
  if (batch.settings.terms.diffuse && !is_dark(kDiffuse) && l_n > 0) return true;
  if (!batch.settings.terms.specular || is_dark(kSpecular)) return false;
  const double cosine = highlight_cosine(
      batch, h,
      {static_cast<double>(own.x), static_cast<double>(own.y), static_cast<double>(own.z)});
  return cosine >= 0 && highlight_of(cosine, static_cast<double>(row[kShininess])) > 0;
}

/// The highlights of all that wait: general.highlight, kFacesAway where there is none.
template <class R>
void find_highlights(const Batch<R>& batch) {
  GeneralWorkspace<R>& general = batch.general;
  const Scratch<R>& scratch = batch.scratch;
  const auto shines = [&](std::size_t i) {
    const R* const row = batch.row(static_cast<std::size_t>(scratch.shadow_ray_hit[i]));
    return row[kSpecular] != R(0) || row[kSpecular + 1] != R(0) || row[kSpecular + 2] != R(0);
  };
  bool any = false;
  for (std::size_t i = 0; i < general.waiting && !any; ++i) any = shines(i);
  if (!any) return;
  batch.services.find_highlights(general.waiting, scratch, general.highlight.data());
  for (std::size_t i = 0; i < general.waiting; ++i) {
    if (general.highlight[i] != kUnknownHighlight || !shines(i)) continue;
    const auto h = static_cast<std::size_t>(scratch.shadow_ray_hit[i]);
    general.highlight[i] =
        highlight_of(highlight_cosine(batch, h, three(scratch.sdx, scratch.sdy, scratch.sdz, i)),
                     static_cast<double>(batch.row(h)[kShininess]));
  }
}

/// Who explains wants to know of a light's first sample what shadows leave of it, and how it shines.
template <class R>
void tell_first_sample(const Batch<R>& batch, std::size_t i) {
  const Scratch<R>& scratch = batch.scratch;
  const auto h = static_cast<std::size_t>(scratch.shadow_ray_hit[i]);
  LightSum<R>& sum = batch.general.sums[h];
  const V3<R>& filter = batch.general.filter[i];
  if (!is_zero(filter)) ++sum.lit;
  if (batch.general.of_waiting[i].sample != 0) return;
  sum.filter = filter;
  const R* const row = batch.row(h);
  const V3<R> ks{row[kSpecular], row[kSpecular + 1], row[kSpecular + 2]};
  if (is_zero(filter) || !batch.settings.terms.specular || is_zero(ks)) return;
  sum.cosine = highlight_cosine(batch, h, three(scratch.sdx, scratch.sdy, scratch.sdz, i));
  if (sum.cosine >= 0) sum.highlight = batch.general.highlight[i];
}

/// Adds what has arrived of one light to the sums of its hits.
template <class R>
void settle_light(const Batch<R>& batch) {
  const Terms& terms = batch.settings.terms;
  GeneralWorkspace<R>& general = batch.general;
  trace_waiting(batch);
  if (terms.specular) find_highlights(batch);
  for (std::size_t i = 0; i < general.waiting; ++i) {
    if (general.listener != nullptr) tell_first_sample(batch, i);
    const V3<R>& filter = general.filter[i];
    if (is_zero(filter)) continue;
    const Waiting<R>& one = general.of_waiting[i];
    const auto h = static_cast<std::size_t>(batch.scratch.shadow_ray_hit[i]);
    LightTerms<R>& sum = general.lit[h];
    const V3<R> radiance = one.radiance * filter;
    const R* const row = batch.row(h);
    if (terms.diffuse)
      sum.diffuse = sum.diffuse + radiance * V3<R>{row[kDiffuse], row[kDiffuse + 1], row[kDiffuse + 2]} *
                                      one.l_n;
    const V3<R> ks{row[kSpecular], row[kSpecular + 1], row[kSpecular + 2]};
    if (!terms.specular || is_zero(ks) || general.highlight[i] == kFacesAway) continue;
    sum.specular = sum.specular + radiance * ks * static_cast<R>(general.highlight[i]);
  }
  general.waiting = 0;
  general.of_waiting.clear();
}

/// Lets a sample's shadow ray wait; its direction is in the engine's own numbers.
template <class R>
void add_waiting(const Batch<R>& batch, std::size_t h, const V3<R>& to_light, double distance,
                 const Waiting<R>& one) {
  GeneralWorkspace<R>& general = batch.general;
  Scratch<R>& scratch = batch.scratch;
  const std::size_t i = general.waiting++;
  scratch.sdx[i] = to_light.x, scratch.sdy[i] = to_light.y, scratch.sdz[i] = to_light.z;
  scratch.sdistance[i] = static_cast<R>(std::fmin(distance, kFarthest));
  scratch.shadow_ray_hit[i] = static_cast<std::int32_t>(h);
  general.of_waiting.push_back(one);
  if (general.waiting == general.shadow_room) settle_light(batch);
}

/// All samples of a light, hit by hit.
template <class R>
void add_samples(const Batch<R>& batch, std::int32_t index) {
  const OpticalLight& light = batch.optics().lights[index];
  const V3<R>& color = batch.scene.lights[index].color;
  GeneralWorkspace<R>& general = batch.general;
  for (std::size_t h = 0; h < batch.hit_count(); ++h) {
    const RayState<R>& ray = batch.ray_of(h);
    const V3<double> point = batch.point(h), normal = batch.normal(h);
    const bool is_surface = light.kind >= LightKind::rectangle;
    const Sobol2 points(
        is_surface ? hash(ray.key, static_cast<std::uint32_t>(index), 0x11u) : 0u);
    const std::int32_t samples = general.lit[h].samples = samples_for(light.samples, ray);
    for (std::int32_t s = 0; s < samples; ++s) {
      const Point2 at = is_surface
                            ? points[ray.sample * static_cast<std::uint32_t>(light.samples) +
                                     static_cast<std::uint32_t>(s)]
                            : Point2{0.5, 0.5};
      const Arriving arrives = arriving(light, point, at);
      const double l_n = dot(arrives.to_light, normal);
      const V3<R> radiance = color * static_cast<R>(arrives.strength);
      if (general.listener != nullptr) {
        LightSum<R>& sum = general.sums[h];
        if (s == 0)
          sum.to_light = arrives.to_light, sum.distance = arrives.distance, sum.l_n = l_n,
          sum.radiance = radiance;
        if (l_n >= 0) ++sum.facing;
      }
      if (!(l_n >= 0) || is_zero(radiance)) continue;
      const V3<R> to_light = narrowed<R>(arrives.to_light);
      // Whoever explains wants to know of all of them.
      if (general.listener != nullptr || counts(batch, h, to_light, l_n))
        add_waiting(batch, h, to_light, arrives.distance, {s, static_cast<R>(l_n), radiance});
    }
  }
}

/// Adds one light to the local light of all hits.
template <class R>
void add_light(const Batch<R>& batch, std::int32_t index) {
  GeneralWorkspace<R>& general = batch.general;
  Listener<R>* const listener = general.listener;
  general.lit.assign(batch.hit_count(), LightTerms<R>{});
  if (listener != nullptr) general.sums.assign(batch.hit_count(), LightSum<R>{});
  add_samples(batch, index);
  settle_light(batch);
  for (std::size_t h = 0; h < batch.hit_count(); ++h) {
    LightTerms<R>& sum = general.lit[h];
    const R mean = R(1) / static_cast<R>(sum.samples);
    if (sum.samples > 1) sum.diffuse = sum.diffuse * mean, sum.specular = sum.specular * mean;
    HitArrays<R>& hits = batch.level.hits;
    const V3<R> local = V3<R>{hits.r[h], hits.g[h], hits.b[h]} + sum.diffuse + sum.specular;
    hits.r[h] = local.x, hits.g[h] = local.y, hits.b[h] = local.z;
    if (listener == nullptr) continue;
    LightSum<R>& told = general.sums[h];
    told.diffuse = sum.diffuse, told.specular = sum.specular, told.samples = sum.samples;
  }
  if (listener != nullptr) listener->at_light(index, batch.level, general.sums.data());
}

}  // namespace

template <class R>
void light_hits(const Batch<R>& batch) {
  const Terms& terms = batch.settings.terms;
  GeneralWorkspace<R>& general = batch.general;
  const bool occluded = batch.optics().occlusion_samples > 0 && terms.ambient &&
                        terms.shadows && !terms.silhouette;
  general.waiting = 0;
  general.of_waiting.clear();
  find_shadow_origins(batch);
  if (occluded) find_occlusion(batch);
  batch.services.hits->start_light(batch.scene, terms, batch.level, batch.scratch);
  const bool dims = batch.optics().occlusion_samples > 0 && terms.ambient && !terms.silhouette;
  for (std::size_t h = 0; h < batch.hit_count() && dims; ++h) {
    HitArrays<R>& hits = batch.level.hits;
    const V3<R> local = V3<R>{hits.r[h], hits.g[h], hits.b[h]} *
                        (occluded ? general.occlusion[h]
                                  : narrowed<R>(batch.optics().occlusion_color));
    hits.r[h] = local.x, hits.g[h] = local.y, hits.b[h] = local.z;
  }
  if (general.listener != nullptr)
    general.listener->at_hits(batch.level, batch.scratch, general,
                              occluded ? general.occlusion.data() : nullptr);
  if (terms.silhouette || !(terms.diffuse || terms.specular)) return;
  for (std::int32_t i = 0; i < batch.scene.light_count; ++i) {
    // Who explains goes hit by hit.
    if (!batch.listens() && batch.optics().lights[i].kind < LightKind::rectangle)
      add_single_light(batch, i);
    else
      add_light(batch, i);
  }
}

#define ZRAKA_FOR(R) template void light_hits(const Batch<R>&);
ZRAKA_FOR(float)
ZRAKA_FOR(double)
#undef ZRAKA_FOR

}  // namespace zraka::general
