// SPDX-License-Identifier: Apache-2.0
#include "engine/general/general.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "engine/coefficients.hpp"
#include "engine/general/cuts.hpp"
#include "engine/general/sky.hpp"
#include "sampling/hash.hpp"
#include "scene/reals.hpp"

namespace zraka::general {
namespace {

/// Whether the medium is the same before and behind a hit: then the surface is none for light, and
/// `inside` becomes what the ray is inside of behind it.
template <class R>
bool passes_unseen(const Batch<R>& batch, std::size_t h, Inside& inside) {
  const OpticalMaterial* const materials = batch.optics().materials;
  const OpticalMaterial& material = batch.material(h);
  if (!lets_in(material)) return false;  // nothing goes in there
  if (!has_inside(batch.scene, batch.scratch.paths[h])) return false;
  const std::uint64_t body =
      body_of(batch.scene, batch.scratch.paths[h], batch.scratch.material[h]);
  Inside with = inside, without = inside;
  with.enter({body, batch.scratch.material[h]});
  without.leave(body);
  const std::int32_t a = medium_of(with, materials), b = medium_of(without, materials);
  if (a != b) return false;
  inside = batch.from_inside(h) ? without : with;
  return true;
}

/// Lets rays go on through what is cut away, and through surfaces that another body's inside hides
/// where bodies have priorities.
template <class R>
void pass_hidden_surfaces(const Batch<R>& batch) {
  constexpr int kMostPassed = 64;
  CutWalks<R> walks(batch.scene, batch.services, batch.level, batch.scratch, batch.general,
                    batch.rays);
  std::vector<std::size_t> hidden(batch.hit_count());
  std::iota(hidden.begin(), hidden.end(), std::size_t{0});
  for (const std::size_t h : hidden) walks.add_hit(h);
  walks.run();
  for (int pass = 0; batch.optics().nested && !hidden.empty() && pass < kMostPassed; ++pass) {
    std::erase_if(hidden, [&](std::size_t h) {
      return batch.scratch.slot[batch.level.hits.ray[h]] < 0 ||
             !passes_unseen(batch, h, batch.inside_of(h));
    });
    for (const std::size_t h : hidden) walks.add_onward(h);
    walks.run();
  }
  drop_lost_hits(batch.level, batch.scratch, batch.general.caps);
}

/// All that the fold adds up. Zeroing the rest of a hit's state, which only listeners read, takes
/// longer.
template <class R>
void forget_children(HitState<R>& hit) {
  hit.missing = hit.beyond_reflected = hit.beyond_refracted = {R(0), R(0), R(0)};
  hit.first_child = hit.child_count = 0;
}

/// What rays bring that hit nothing: the sky's colour, which find_hits() knows where it is plain.
template <class R>
void find_sky(const Batch<R>& batch) {
  Level<R>& level = batch.level;
  const bool plain = batch.optics().sky.kind == Sky::Kind::flat;
  if (plain && batch.optics().fog.kind == Fog::Kind::none) return;
  for (std::int32_t i = 0; i < level.in_batch; ++i) {
    const std::int32_t ray = level.done + i;
    if (batch.scratch.slot[i] >= 0) continue;
    const auto at = static_cast<std::size_t>(ray);
    const V3<R> color =
        plain ? batch.scene.background
              : sky_color(batch.scene, three(level.rays.dx, level.rays.dy, level.rays.dz, at));
    const R clear = clear_share_of(batch, at, std::numeric_limits<double>::infinity());
    const V3<R> seen = through_fog(batch.optics().fog, clear, color);
    level.rays.r[ray] = seen.x, level.rays.g[ray] = seen.y, level.rays.b[ray] = seen.z;
  }
}

/// What a hit's state begins with.
template <class R>
void start_state(const Batch<R>& batch, std::size_t h) {
  HitState<R>& hit = batch.hits[h];
  if (batch.listens()) hit = {};
  forget_children(hit);
  hit.body = 0;
  hit.enclosing = false;
  if (batch.listens() || (batch.has_media() && lets_in(batch.material(h)))) {
    hit.body = body_of(batch.scene, batch.scratch.paths[h], batch.scratch.material[h]);
    hit.enclosing = has_inside(batch.scene, batch.scratch.paths[h]);
  }
  hit.material = batch.scratch.material[h];
  hit.cap = batch.cap_of(h);
}

/// Nearest hits, surfaces, and what rays come through; what hits nothing has the sky's colour.
template <class R>
void find_hits(const Batch<R>& batch) {
  Level<R>& level = batch.level;
  const bool may_go_through = batch.optics().nested || batch.optics().cut_count > 0;
  Scratch<R> found = batch.scratch;
  // The ways to hits take long to write.
  const bool asks_ways = (batch.has_media() && batch.general.has_groups) || may_go_through ||
                         batch.listens() || batch.scene.textures != nullptr;
  if (!asks_ways) found.paths = nullptr;
  batch.services.find_hits(batch.scene, level, found);
  for (std::size_t h = 0; h < batch.hit_count() && batch.has_media() && !asks_ways; ++h)
    if (lets_in(batch.material(h)))
      start_path(found.slot[level.hits.ray[h]], batch.scratch.paths[h]);
  batch.general.caps.clear();
  if (may_go_through) pass_hidden_surfaces(batch);
  batch.counts.hits += batch.hit_count();
  find_sky(batch);

  batch.columns.parents.clear();
  for (std::size_t h = 0; h < batch.hit_count() && batch.listens(); ++h) {
    start_state(batch, h);
    batch.hits[h].medium = -1;
    batch.hits[h].transmittance = {R(1), R(1), R(1)};
    batch.hits[h].clear = R(1);
    batch.columns.parents.push_back(static_cast<std::int32_t>(h));
  }
  if (batch.has_media()) pass_media(batch);
  if (batch.optics().fog.kind != Fog::Kind::none) pass_fog(batch);
}

/// Those hits whose material has children at all. Listeners have been given all.
template <class R>
void choose_parents(const Batch<R>& batch) {
  if (batch.listens()) return;
  const OpticalMaterial* const materials = batch.optics().materials;
  for (std::size_t h = 0; h < batch.hit_count(); ++h) {
    if (!materials[batch.scratch.material[h]].has_children) continue;
    start_state(batch, h);
    batch.columns.parents.push_back(static_cast<std::int32_t>(h));
  }
}

/// local + Σ share·Cchild, of a hit that may have children.
template <class R>
V3<R> sum_at(const Batch<R>& batch, std::size_t h, const Level<R>* next,
             const RayState<R>* next_rays) {
  const Level<R>& level = batch.level;
  HitState<R>& hit = batch.hits[h];
  V3<R> color{level.hits.r[h], level.hits.g[h], level.hits.b[h]};
  R cut = most_of(hit.missing);
  if (batch.settings.sky_beyond) color = color + hit.beyond_reflected + hit.beyond_refracted;
  if (next != nullptr)
    for (std::int32_t c = hit.first_child; c < hit.first_child + hit.child_count; ++c) {
      const V3<R> brought{next->rays.r[c], next->rays.g[c], next->rays.b[c]};
      color = color + next_rays[c].share * brought;
      cut += most_size(next_rays[c].share) * next_rays[c].cut;
    }
  batch.ray_of(h).cut = cut;
  return color;
}

/// C = T·(local + Σ share·Cchild).
template <class R>
void fold(const Batch<R>& batch, const Level<R>* next, const RayState<R>* next_rays) {
  Level<R>& level = batch.level;
  const Scratch<R>& scratch = batch.scratch;
  V3<R*> sums{level.hits.r, level.hits.g, level.hits.b};
  if (batch.listens()) {  // which ask for the local light then
    sums = {scratch.px, scratch.py, scratch.pz};
    std::copy_n(level.hits.r, batch.hit_count(), sums.x);
    std::copy_n(level.hits.g, batch.hit_count(), sums.y);
    std::copy_n(level.hits.b, batch.hit_count(), sums.z);
  }
  for (const std::int32_t parent : batch.columns.parents) {
    const auto h = static_cast<std::size_t>(parent);
    const V3<R> sum = sum_at(batch, h, next, next_rays);
    if (batch.listens()) batch.hits[h].sum = sum;
    sums.x[h] = sum.x, sums.y[h] = sum.y, sums.z[h] = sum.z;
  }
  const auto column = [](const std::vector<R>& of) { return of.empty() ? nullptr : of.data(); };
  const auto& t = batch.columns.transmittance;
  batch.services.hits->bring_back(
      {sums.x, sums.y, sums.z, {column(t[0]), column(t[1]), column(t[2])},
       column(batch.columns.clear), narrowed<R>(batch.optics().fog.color)},
      batch.settings.clamp_levels, level);
  level.done += level.in_batch;
  if (batch.general.listener != nullptr) batch.general.listener->at_fold(level, batch.general);
  level.in_batch = 0;
}

template <class R>
void trace_batch(const Batch<R>& batch, std::int32_t size, Level<R>* next, RayState<R>* next_rays,
                 Inside* next_insides) {
  Level<R>& level = batch.level;
  level.in_batch = std::min(level.ray_count - level.done, size);
  find_hits(batch);
  take_coefficients(batch.scene, level, batch.scratch, batch.services.color_hits);
  light_hits(batch);
  const Terms& terms = batch.settings.terms;
  if (terms.silhouette || !(terms.reflection || terms.refraction)) return;
  if (next == nullptr && !batch.settings.sky_beyond) return;
  choose_parents(batch);
  if (next == nullptr) return find_sky_beyond(batch);
  spawn(batch, *next, next_rays, next_insides);
  if (batch.general.listener != nullptr)
    batch.general.listener->at_children(level, *next, batch.general);
}

/// The bodies that the eye is inside of: those that a ray from there leaves before it comes in.
template <class R>
Inside inside_of_eye(const FrozenScene<R>& scene, const Services<R>& services,
                     GeneralWorkspace<R>& general) {
  constexpr int kMostSurfaces = 1000;
  Inside inside;
  if (!has_media(*scene.optics)) return inside;
  Level<R>& level = general.through;
  Scratch<R>& scratch = general.through_scratch;
  const V3<double> way = unit({0.3511, 0.7413, 0.5719});  // along no axis
  const V3<double> eye{static_cast<double>(scene.camera.eye.x),
                       static_cast<double>(scene.camera.eye.y),
                       static_cast<double>(scene.camera.eye.z)};
  V3<R> from = scene.camera.eye;
  std::vector<std::uint64_t> met;
  for (int surface = 0; surface < kMostSurfaces; ++surface) {
    level.rays.ox[0] = from.x, level.rays.oy[0] = from.y, level.rays.oz[0] = from.z;
    level.rays.dx[0] = static_cast<R>(way.x), level.rays.dy[0] = static_cast<R>(way.y);
    level.rays.dz[0] = static_cast<R>(way.z);
    level.ray_count = level.in_batch = 1;
    level.done = 0;
    services.find_hits(scene, level, scratch);
    if (level.hit_count == 0) break;
    const std::int32_t material = scratch.material[0];
    const std::uint64_t body = body_of(scene, scratch.paths[0], material);
    const bool known = std::find(met.begin(), met.end(), body) != met.end();
    const OpticalMaterial& m = scene.optics->materials[material];
    if (!known && scratch.inside[0] > R(0) && has_inside(scene, scratch.paths[0]) &&
        lets_in(m) && !is_cut(*scene.optics, m, eye, true))
      inside.enter({body, material});
    met.push_back(body);
    from = narrowed<R>(three(scratch.px, scratch.py, scratch.pz, 0) -
                       three(scratch.nx, scratch.ny, scratch.nz, 0) *
                           static_cast<double>(scratch.offset[0]));
  }
  // The outermost is left last: it has been entered first.
  std::reverse(inside.list, inside.list + inside.count);
  return inside;
}

/// What the rays of level 0 carry.
template <class R>
void start_rays(const TraceSettings& settings, const Workspace<R>& workspace,
                GeneralWorkspace<R>& general) {
  const std::int32_t n = workspace.levels[0].ray_count;
  for (std::int32_t i = 0; i < n; ++i) {
    const CameraSample& from = workspace.samples[i];
    RayState<R>& ray = general.rays[0][static_cast<std::size_t>(i)];
    ray.share = ray.weight = {R(1), R(1), R(1)};
    ray.cut = R(0);
    ray.key = general.draws ? hash(settings.seed, static_cast<std::uint32_t>(from.x),
                                   static_cast<std::uint32_t>(from.y))
                            : 0;
    ray.sample = from.number;
    ray.wavelength = -1;
    ray.kind = RayKind::camera;
    ray.sees_cuts = true;
  }
  if (!general.insides.empty()) std::fill_n(general.insides[0].begin(), n, general.at_eye);
}

}  // namespace

int most_children(const TraceSettings& settings) {
  return 1 + std::max(1, settings.wavelengths.count);
}

template <class R>
void trace_rays(const FrozenScene<R>& scene, const TraceSettings& settings,
                const Services<R>& services, Workspace<R>& workspace, GeneralWorkspace<R>& general,
                RayCounts& counts) {
  if (!general.knows_eye) {
    general.at_eye = inside_of_eye(scene, services, general);
    general.knows_eye = true;
  }
  Level<R>& top = workspace.levels[0];
  top.done = 0;
  counts.camera += static_cast<std::uint64_t>(top.ray_count);
  start_rays(settings, workspace, general);
  const bool media = has_media(*scene.optics);
  const auto insides_at = [&](int depth) {
    return media ? general.insides[static_cast<std::size_t>(depth)].data() : nullptr;
  };
  const auto batch_at = [&](int depth) {
    const auto d = static_cast<std::size_t>(depth);
    return Batch<R>{scene,   settings,
                    services, workspace.levels[depth],
                    workspace.scratch, general,
                    counts,   general.rays[d].data(),
                    general.hits[d].data(), general.columns[d],
                    insides_at(depth)};
  };
  for (int depth = 0;;) {
    const Batch<R> batch = batch_at(depth);
    Level<R>& level = batch.level;
    if (level.done < level.ray_count) {
      Level<R>* const next = depth < settings.max_depth ? &level + 1 : nullptr;
      RayState<R>* const next_rays =
          next == nullptr ? nullptr : general.rays[static_cast<std::size_t>(depth) + 1].data();
      if (next != nullptr) next->ray_count = next->done = 0;
      trace_batch(batch, workspace.batch, next, next_rays,
                  next == nullptr ? nullptr : insides_at(depth + 1));
      const bool goes_on = general.listener == nullptr || !general.listener->stop;
      if (next != nullptr && next->ray_count > 0 && goes_on)
        ++depth;  // the children first
      else
        fold(batch, static_cast<const Level<R>*>(nullptr), static_cast<const RayState<R>*>(nullptr));
    } else if (depth > 0) {
      --depth;  // all the children's colours are known
      fold(batch_at(depth), &workspace.levels[depth + 1],
           general.rays[static_cast<std::size_t>(depth) + 1].data());
    } else {
      return;
    }
  }
}

#define ZRAKA_FOR(R)                                                                          \
  template void trace_rays(const FrozenScene<R>&, const TraceSettings&, const Services<R>&,   \
                           Workspace<R>&, GeneralWorkspace<R>&, RayCounts&);
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka::general
