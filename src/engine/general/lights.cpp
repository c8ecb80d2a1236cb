// SPDX-License-Identifier: Apache-2.0
// Local light of the general engine: lights of all kinds.
#include "engine/general/lights.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "sampling/hash.hpp"
#include "sampling/sobol.hpp"
#include "sampling/warp.hpp"
#include "scene/reals.hpp"

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

/// What light may add at a hit, as far as it depends on its material.
struct Response {
  bool diffuse, specular;
};

template <class R>
Response response_at(const Batch<R>& batch, std::size_t h) {
  const R* const row = batch.row(h);
  const auto is_dark = [&](int column) {
    return row[column] == R(0) && row[column + 1] == R(0) && row[column + 2] == R(0);
  };
  return {batch.settings.terms.diffuse && !is_dark(kDiffuse),
          batch.settings.terms.specular && !is_dark(kSpecular)};
}

/// The highlights of all that wait, kFacesAway where there is none.
template <class R>
void find_highlights(const Batch<R>& batch) {
  GeneralWorkspace<R>& general = batch.general;
  std::vector<double>& highlights = general.of_waiting.highlight;
  const Scratch<R>& scratch = batch.scratch;
  const auto shines = [&](std::size_t h) {
    const R* const row = batch.row(h);
    return row[kSpecular] != R(0) || row[kSpecular + 1] != R(0) || row[kSpecular + 2] != R(0);
  };
  bool any = false;
  for (std::size_t h = 0; h < batch.hit_count() && !any; ++h) any = shines(h);
  if (!any) return;
  batch.services.find_highlights(general.waiting, scratch, highlights.data());
  // All or nearly all are known: counting is a loop of lanes.
  std::size_t unknown = 0;
  for (std::size_t i = 0; i < general.waiting; ++i)
    unknown += highlights[i] == kUnknownHighlight ? 1 : 0;
  if (unknown == 0) return;
  for (std::size_t i = 0; i < general.waiting; ++i) {
    const auto h = static_cast<std::size_t>(scratch.shadow_ray_hit[i]);
    if (highlights[i] != kUnknownHighlight || !shines(h)) continue;
    highlights[i] =
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
  if (batch.general.of_waiting.sample[i] != 0) return;
  sum.filter = filter;
  const R* const row = batch.row(h);
  const V3<R> ks{row[kSpecular], row[kSpecular + 1], row[kSpecular + 2]};
  if (is_zero(filter) || !batch.settings.terms.specular || is_zero(ks)) return;
  sum.cosine = highlight_cosine(batch, h, three(scratch.sdx, scratch.sdy, scratch.sdz, i));
  if (sum.cosine >= 0) sum.highlight = batch.general.of_waiting.highlight[i];
}

/// Lets those wait no longer that would add nothing: clear glass shines where it mirrors the light,
/// and nowhere else.
template <class R>
void drop_dull(const Batch<R>& batch) {
  GeneralWorkspace<R>& general = batch.general;
  std::size_t left = 0;
  for (std::size_t i = 0; i < general.waiting; ++i) {
    const auto h = static_cast<std::size_t>(batch.scratch.shadow_ray_hit[i]);
    const bool diffuse = general.of_waiting.l_n[i] > 0 && response_at(batch, h).diffuse;
    if (!diffuse && !(general.of_waiting.highlight[i] > 0)) continue;
    move_waiting(batch, i, left++);
  }
  general.waiting = left;
}

/// Adds what has arrived of the light to the sums of its hits.
template <class R>
void add_arrived(const Batch<R>& batch, const V3<R>& color) {
  const Terms& terms = batch.settings.terms;
  GeneralWorkspace<R>& general = batch.general;
  const Waiting<R>& waiting = general.of_waiting;
  const std::int32_t* const hit = batch.scratch.shadow_ray_hit;
  const bool filtered = !general.filter.empty();
  const std::int32_t* const blocked = general.maybe_blocked ? batch.scratch.blocked : nullptr;
  for (std::size_t i = 0; i < general.waiting;) {
    const std::int32_t h = hit[i];
    const R* const row = batch.row(static_cast<std::size_t>(h));
    const V3<R> kd{row[kDiffuse], row[kDiffuse + 1], row[kDiffuse + 2]};
    const V3<R> ks{row[kSpecular], row[kSpecular + 1], row[kSpecular + 2]};
    const bool shines = terms.specular && !is_zero(ks);
    LightTerms<R>& of_hit = general.lit[static_cast<std::size_t>(h)];
    LightTerms<R> sum = of_hit;
    for (; i < general.waiting && hit[i] == h; ++i) {
      if (blocked != nullptr && blocked[i] != 0) continue;
      V3<R> radiance = color * waiting.strength[i];
      if (filtered) {
        if (is_zero(general.filter[i])) continue;
        radiance = radiance * general.filter[i];
      }
      if (terms.diffuse) sum.diffuse = sum.diffuse + radiance * kd * static_cast<R>(waiting.l_n[i]);
      if (!shines || waiting.highlight[i] == kFacesAway) continue;
      sum.specular = sum.specular + radiance * ks * static_cast<R>(waiting.highlight[i]);
    }
    of_hit = sum;
  }
}

/// Traces the shadow rays of a light that wait, and adds what arrives.
template <class R>
void settle_light(const Batch<R>& batch, std::int32_t index) {
  GeneralWorkspace<R>& general = batch.general;
  if (general.by_highlight) {
    find_highlights(batch);
    drop_dull(batch);
  }
  trace_waiting(batch, Order::as_listed);
  if (batch.settings.terms.specular && !general.by_highlight) find_highlights(batch);
  if (general.listener != nullptr)
    for (std::size_t i = 0; i < general.waiting; ++i) tell_first_sample(batch, i);
  add_arrived(batch, batch.scene.lights[index].color);
  general.waiting = 0;
  general.by_highlight = false;
}

/// Whether a sample has to wait for its shadow ray. What arrives along the surface, or where it is
/// black, shines at most.
template <class R>
bool must_wait(GeneralWorkspace<R>& general, const Response& response, double l_n,
               const V3<R>& radiance) {
  if (!(l_n >= 0) || is_zero(radiance)) return false;
  if (general.listener != nullptr) return true;  // who explains wants to know of all of them
  if (response.diffuse && l_n > 0) return true;
  if (response.specular) general.by_highlight = true;
  return response.specular;
}

/// Lets a sample's shadow ray wait; its direction is in the engine's own numbers.
template <class R>
void add_waiting(const Batch<R>& batch, std::size_t h, const V3<R>& to_light, double distance,
                 double l_n, R strength, std::int32_t sample) {
  GeneralWorkspace<R>& general = batch.general;
  Scratch<R>& scratch = batch.scratch;
  const std::size_t i = general.waiting++;
  scratch.sdx[i] = to_light.x, scratch.sdy[i] = to_light.y, scratch.sdz[i] = to_light.z;
  scratch.sdistance[i] = static_cast<R>(std::fmin(distance, kFarthest));
  scratch.shadow_ray_hit[i] = static_cast<std::int32_t>(h);
  general.of_waiting.l_n[i] = l_n;
  general.of_waiting.strength[i] = strength;
  general.of_waiting.sample[i] = sample;
}

/// Whether of samples that have been drawn each comes from above with some radiance. A loop that
/// the compiler makes lanes of.
template <class R>
bool all_useful(const Batch<R>& batch, std::size_t first, std::size_t last, R brightness) {
  const Waiting<R>& waiting = batch.general.of_waiting;
  const R* const strength = waiting.strength.data();
  const double* const l_n = waiting.l_n.data();
  std::int32_t useless = 0;
  for (std::size_t i = first; i < last; ++i) useless += brightness * strength[i] > R(0) ? 0 : 1;
  std::int64_t below = 0;
  for (std::size_t i = first; i < last; ++i) below += l_n[i] > 0 ? 0 : 1;
  return useless == 0 && below == 0;
}

/// Draws n samples that stand behind what waits, and lets those of them wait that have to.
template <class R>
void draw_samples(const Batch<R>& batch, std::int32_t index, std::size_t n) {
  const V3<R>& color = batch.scene.lights[index].color;
  GeneralWorkspace<R>& general = batch.general;
  Waiting<R>& waiting = general.of_waiting;
  Scratch<R>& scratch = batch.scratch;
  const std::size_t at = general.waiting, end = at + n;
  batch.services.sample_light(
      batch.optics().lights[index],
      {waiting.shuffle.data() + at, waiting.u.data() + at, waiting.v.data() + at,
       waiting.number.data() + at},
      scratch.shadow_ray_hit + at, n, scratch,
      {scratch.sdx + at, scratch.sdy + at, scratch.sdz + at, scratch.sdistance + at,
       waiting.strength.data() + at, waiting.l_n.data() + at});
  for (std::size_t i = at; i < end;) {
    const std::int32_t h = scratch.shadow_ray_hit[i];
    const Response response = response_at(batch, static_cast<std::size_t>(h));
    std::size_t last = i + 1;
    while (last < end && scratch.shadow_ray_hit[last] == h) ++last;
    if (response.diffuse && i == general.waiting && all_useful(batch, i, last, most_size(color))) {
      general.waiting = i = last;
      continue;
    }
    for (; i < last; ++i) {
      if (!must_wait(general, response, waiting.l_n[i], color * waiting.strength[i])) continue;
      if (i != general.waiting) move_waiting(batch, i, general.waiting);
      ++general.waiting;
    }
  }
}

/// All samples of a light that is a surface.
template <class R>
void add_samples(const Batch<R>& batch, std::int32_t index) {
  const OpticalLight& light = batch.optics().lights[index];
  GeneralWorkspace<R>& general = batch.general;
  Waiting<R>& waiting = general.of_waiting;
  const std::size_t room = general.shadow_room;
  std::size_t undrawn = 0;
  const auto draw = [&] {
    draw_samples(batch, index, undrawn);
    undrawn = 0;
    if (general.waiting > room / 2) settle_light(batch, index);
  };
  for (std::size_t h = 0; h < batch.hit_count(); ++h) {
    const RayState<R>& ray = batch.ray_of(h);
    const std::int32_t samples = general.lit[h].samples = samples_for(light.samples, ray);
    const Response response = response_at(batch, h);
    if (!response.diffuse && !response.specular) continue;
    const Sobol2 points(hash(ray.key, static_cast<std::uint32_t>(index), 0x11u));
    std::uint32_t number = ray.sample * static_cast<std::uint32_t>(light.samples);
    for (auto left = static_cast<std::size_t>(samples); left > 0;) {
      const std::size_t at = general.waiting + undrawn, n = std::min(left, room - at);
      std::fill_n(batch.scratch.shadow_ray_hit + at, n, static_cast<std::int32_t>(h));
      std::fill_n(waiting.shuffle.data() + at, n, points.shuffle);
      std::fill_n(waiting.u.data() + at, n, points.scramble_u);
      std::fill_n(waiting.v.data() + at, n, points.scramble_v);
      std::iota(waiting.number.data() + at, waiting.number.data() + at + n, number);
      number += static_cast<std::uint32_t>(n);
      undrawn += n;
      left -= n;
      if (at + n == room) draw();
    }
  }
  draw();
}

/// The same of any light, one by one, for who explains.
template <class R>
void tell_samples(const Batch<R>& batch, std::int32_t index) {
  const OpticalLight& light = batch.optics().lights[index];
  const V3<R>& color = batch.scene.lights[index].color;
  GeneralWorkspace<R>& general = batch.general;
  const bool is_surface = light.kind >= LightKind::rectangle;
  for (std::size_t h = 0; h < batch.hit_count(); ++h) {
    const RayState<R>& ray = batch.ray_of(h);
    const V3<double> point = batch.point(h), normal = batch.normal(h);
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
      const R strength = static_cast<R>(arrives.strength);
      const V3<R> radiance = color * strength;
      LightSum<R>& sum = general.sums[h];
      if (s == 0)
        sum.to_light = arrives.to_light, sum.distance = arrives.distance, sum.l_n = l_n,
        sum.radiance = radiance;
      if (l_n >= 0) ++sum.facing;
      if (!must_wait(general, response_at(batch, h), l_n, radiance)) continue;
      add_waiting(batch, h, narrowed<R>(arrives.to_light), arrives.distance, l_n, strength, s);
      if (general.waiting == general.shadow_room) settle_light(batch, index);
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
  if (listener != nullptr)
    tell_samples(batch, index);
  else
    add_samples(batch, index);
  settle_light(batch, index);
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
  general.by_highlight = false;
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
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka::general
