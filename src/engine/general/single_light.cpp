// SPDX-License-Identifier: Apache-2.0
// Local light of lights that are no surfaces, at all hits of a batch together: what lanes compute
// (HitServices), and hit by hit only what they leave open. To the bits of lights.cpp.
#include "engine/general/lights.hpp"
#include "scene/reals.hpp"

namespace zraka::general {
namespace {

/// What lanes know too little of.
template <class R>
void find_unknown_shines(const Batch<R>& batch) {
  const Scratch<R>& scratch = batch.scratch;
  std::vector<double>& highlights = batch.general.highlight;
  for (std::size_t h = 0; h < batch.hit_count(); ++h)
    if (highlights[h] == kUnknownHighlight)
      highlights[h] =
          highlight_of(highlight_cosine(batch, h, three(scratch.lx, scratch.ly, scratch.lz, h)),
                       static_cast<double>(batch.row(h)[kShininess]));
}

/// Lets shadow rays wait whose ways have to be followed, and follows them: general.filter.
template <class R>
void follow(const Batch<R>& batch, const std::int32_t* hits, std::size_t n) {
  GeneralWorkspace<R>& general = batch.general;
  Scratch<R>& scratch = batch.scratch;
  for (std::size_t i = 0; i < n; ++i) {
    const auto h = static_cast<std::size_t>(hits[i]);
    scratch.shadow_ray_hit[i] = hits[i];
    scratch.sdx[i] = scratch.lx[h], scratch.sdy[i] = scratch.ly[h], scratch.sdz[i] = scratch.lz[h];
    // Lists name hits in their order: none is written over that is still to come.
    scratch.sdistance[i] = scratch.sdistance[h];
  }
  general.waiting = n;
  general.filter.assign(n, V3<R>{R(1), R(1), R(1)});
  follow_waiting(batch);
}

/// Of the first n hits in the list, which ones the light reaches: scratch.lit. Those whose ways
/// have to be followed wait afterwards.
template <class R>
void trace_listed(const Batch<R>& batch, std::size_t n) {
  Scratch<R>& scratch = batch.scratch;
  std::vector<std::int32_t>& blocked = batch.general.blocked_hits;
  const auto drop = [&](const FrozenScene<R>& scene) {
    return batch.services.drop_blocked(scene, n, scratch, blocked.data());
  };
  batch.counts.shadow += n;
  const Unfollowed<R> scenes(batch);
  if (scenes.dark != nullptr) n = drop(*scenes.dark);
  if (n == 0 || scenes.decide()) return;
  const std::size_t left = drop(*scenes.asked);
  std::size_t followed = n - left;
  if (batch.optics().absorbing && may_be_passed(batch)) {
    for (std::size_t i = 0; i < left; ++i) {
      const std::int32_t hit = scratch.shadow_ray_hit[i];
      if (batch.general.in_absorber[static_cast<std::size_t>(hit)] == 0) continue;
      scratch.lit[hit] = R(0);
      blocked[followed++] = hit;
    }
    std::sort(blocked.begin(), blocked.begin() + static_cast<std::ptrdiff_t>(followed));
  }
  if (followed > 0) follow(batch, blocked.data(), followed);
}

/// Adds what has come through what is transparent.
template <class R>
void add_followed(const Batch<R>& batch, const V3<R>& color) {
  const Terms& terms = batch.settings.terms;
  GeneralWorkspace<R>& general = batch.general;
  HitArrays<R>& hits = batch.level.hits;
  for (std::size_t i = 0; i < general.waiting; ++i) {
    const V3<R>& filter = general.filter[i];
    if (is_zero(filter)) continue;
    const auto h = static_cast<std::size_t>(batch.scratch.shadow_ray_hit[i]);
    const V3<R> radiance = color * batch.scratch.strength[h] * filter;
    const R* const row = batch.row(h);
    V3<R> local{hits.r[h], hits.g[h], hits.b[h]};
    if (terms.diffuse)
      local = local + radiance * V3<R>{row[kDiffuse], row[kDiffuse + 1], row[kDiffuse + 2]} *
                          static_cast<R>(general.l_n[h]);
    const V3<R> ks{row[kSpecular], row[kSpecular + 1], row[kSpecular + 2]};
    if (terms.specular && !is_zero(ks) && general.highlight[h] != kFacesAway)
      local = local + radiance * ks * static_cast<R>(general.highlight[h]);
    hits.r[h] = local.x, hits.g[h] = local.y, hits.b[h] = local.z;
  }
  general.waiting = 0;
}

}  // namespace

template <class R>
void add_single_light(const Batch<R>& batch, std::int32_t index) {
  const OpticalLight& light = batch.optics().lights[index];
  const V3<R>& color = batch.scene.lights[index].color;
  const Terms& terms = batch.settings.terms;
  const HitServices<R>& services = *batch.services.hits;
  GeneralWorkspace<R>& general = batch.general;
  const std::size_t n = batch.hit_count();
  const ArrivingLight arriving{general.distance.data(), general.strength.data(), general.l_n.data(),
                               general.cosine.data(), general.highlight.data()};
  batch.services.find_arriving(light, n, batch.scratch, arriving);
  if (light.kind == LightKind::spot && light.linear_edge_counts())
    for (std::size_t h = 0; h < n; ++h)
      if (general.l_n[h] >= 0) general.strength[h] *= linear_edge(light, general.cosine[h]);
  if (services.find_shines(terms, n, batch.scratch, arriving)) find_unknown_shines(batch);
  const std::size_t listed = services.list_facing(color, terms, n, batch.scratch, arriving);
  if (terms.shadows && listed > 0) trace_listed(batch, listed);
  services.add_arriving(color, terms, batch.level, batch.scratch, arriving);
  add_followed(batch, color);
}

#define ZRAKA_FOR(R) template void add_single_light(const Batch<R>&, std::int32_t);
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka::general
