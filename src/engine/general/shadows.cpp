// SPDX-License-Identifier: Apache-2.0
#include "engine/general/shadows.hpp"

#include "engine/coefficients.hpp"
#include "engine/general/cuts.hpp"
#include "scene/reals.hpp"

namespace zraka::general {
namespace {

/// How much of a stretch of a shadow ray's way is in what is left of a material.
double length_in(const FrozenOptics& optics, std::int32_t material, const WalkHistory& history,
                 double from, double to) {
  if (optics.cut_count == 0) return to - from;
  const KeptPart kept = kept_part(optics, &optics.materials[material], history.start,
                                  history.direction, history.sees_cuts);
  return std::fmax(0, std::fmin(to, kept.leave) - std::fmax(from, kept.enter));
}

/// Of a surface that is cut away, whether the ray has come through what is left of its body, in by
/// one cap and out by another.
bool has_crossed_caps(const FrozenOptics& optics, const OpticalMaterial& material,
                      std::uint64_t body, bool leaves, double walked, WalkHistory& history) {
  if (!leaves) {
    history.entered.push_back({body, walked});
    return false;
  }
  double since = -std::numeric_limits<double>::infinity();
  for (const auto& [entered, at] : history.entered)
    if (entered == body) since = at;
  std::erase_if(history.entered, [&](const auto& entered) { return entered.first == body; });
  const KeptPart kept =
      kept_part(optics, &material, history.start, history.direction, history.sees_cuts);
  return since < kept.enter && kept.enter > 0 && kept.enter < std::fmin(kept.leave, walked) &&
         optics.cuts[kept.at_enter].caps;
}

/// Moves a ray from what is cut away to where something is left; false if it never gets there.
template <class R>
bool skip_cut(const FrozenOptics& optics, Walk<R>& walk, WalkHistory& history) {
  const KeptPart all =
      kept_part(optics, nullptr, history.start, history.direction, history.sees_cuts);
  // Behind them, bodies may end that it has come through between two cuts.
  const bool between = std::any_of(optics.cuts, optics.cuts + optics.cut_count, [&](const auto& c) {
    return dot(c.normal, history.start) > c.distance && dot(c.normal, history.direction) < 0;
  });
  const double beyond = between && optics.has_caps ? optics.largest_body : 0;
  if (all.is_empty() || walk.walked > all.leave + beyond) return false;
  if (!(walk.walked < all.enter)) return true;
  walk.left -= all.enter - walk.walked;
  walk.walked = all.enter;
  walk.origin = narrowed<R>(history.start + history.direction * all.enter);
  history.inside = {};
  return walk.left > 0;
}

/// Whether more has to be known of a walk than where it is.
template <class R>
bool keeps_history(const Batch<R>& batch) {
  return !batch.settings.filter_surfaces || batch.optics().absorbing ||
         batch.optics().cut_count > 0;
}

/// The last stretch, to the light itself, may be inside of what absorbs.
template <class R>
void finish(const Batch<R>& batch, const Walk<R>& walk, const WalkHistory& history) {
  if (!batch.optics().absorbing || !may_be_passed(batch) || !(walk.left < kFarthest / 2)) return;
  const OpticalMaterial* const materials = batch.optics().materials;
  const std::int32_t medium = medium_of(history.inside, materials);
  if (medium < 0 || !materials[medium].absorbs()) return;
  const double length =
      length_in(batch.optics(), medium, history, walk.walked, walk.walked + walk.left);
  const V3<R> left = narrowed<R>(transmittance_of(materials[medium].absorption, length));
  V3<R>& filter = batch.general.filter[walk.entry];
  filter = filter * left;
  if (batch.general.listener != nullptr)
    batch.general.listener->at_passed({batch.scratch.shadow_ray_hit[walk.entry],
                                       batch.general.of_waiting.sample[walk.entry],
                                       -1,
                                       nullptr,
                                       walk.walked + walk.left,
                                       {R(1), R(1), R(1)},
                                       length,
                                       left});
}

/// A walk meets hit h of general.through_scratch at distance t: whether it goes on behind it. The
/// history is written only where keeps_history() says so.
template <class R>
bool meet(const Batch<R>& batch, std::size_t h, std::int32_t slot, double t, Walk<R>& walk,
          WalkHistory& history) {
  const FrozenOptics& optics = batch.optics();
  const OpticalMaterial* const materials = optics.materials;
  GeneralWorkspace<R>& general = batch.general;
  const Scratch<R>& scratch = general.through_scratch;
  V3<R>& filter = general.filter[walk.entry];
  const OpticalMaterial& material = materials[scratch.material[h]];
  const R* const row = scratch.coefficients + std::ptrdiff_t{scratch.row[h]} * kMaterialReals;
  const V3<R> share = !material.casts_shadow ? V3<R>{R(1), R(1), R(1)}
                      : may_be_passed(batch) ? refraction_of(material, row)
                                             : V3<R>{};
  walk.walked += t;
  Passed<R> passed{batch.scratch.shadow_ray_hit[walk.entry],
                   general.of_waiting.sample[walk.entry],
                   slot,
                   &scratch.paths[h],
                   walk.walked,
                   share,
                   0,
                   {R(1), R(1), R(1)}};
  const bool keeps = keeps_history(batch);
  const bool leaves = scratch.inside[h] > R(0);
  const bool encloses = keeps && has_inside(batch.scene, scratch.paths[h]);
  const std::uint64_t body =
      keeps ? body_of(batch.scene, scratch.paths[h], scratch.material[h]) : 0;
  const auto go_on = [&] {
    if (keeps && leaves)
      history.inside.leave(body);
    else if (encloses)
      history.inside.enter({body, scratch.material[h]});
    const V3<double> normal = three(scratch.nx, scratch.ny, scratch.nz, h);
    walk.origin = narrowed<R>(three(scratch.px, scratch.py, scratch.pz, h) -
                              normal * static_cast<double>(scratch.offset[h]));
    walk.left -= t;
  };
  // What it has come through.
  if (encloses && leaves && !is_zero(share)) history.inside.enter({body, scratch.material[h]});
  if (optics.absorbing) {
    const std::int32_t medium = medium_of(history.inside, materials);
    if (medium >= 0 && materials[medium].absorbs()) {
      passed.length = length_in(optics, medium, history, walk.walked - t, walk.walked);
      passed.transmittance =
          narrowed<R>(transmittance_of(materials[medium].absorption, passed.length));
      filter = filter * passed.transmittance;
    }
  }
  if (optics.cut_count > 0) {
    const bool crossed = optics.has_caps && is_solid(batch.scene, scratch.paths[h]) &&
                         has_crossed_caps(optics, material, body, leaves, walk.walked, history);
    if (!crossed && is_cut(optics, material, three(scratch.px, scratch.py, scratch.pz, h),
                           history.sees_cuts)) {
      go_on();
      if (skip_cut(optics, walk, history)) return true;
      finish(batch, walk, history);
      return false;
    }
  }
  if (batch.settings.filter_surfaces) {
    filter = filter * share;
  } else {
    std::vector<std::uint64_t>& known_bodies = history.passed;
    const bool known =
        std::find(known_bodies.begin(), known_bodies.end(), body) != known_bodies.end();
    const bool loose = is_loose_triangle(batch.scene, scratch.paths[h]);
    if (!known || is_zero(share)) {  // what is opaque stops it, wherever in a body
      filter = filter * share;
      known_bodies.push_back(body);
    } else {
      passed.share = {R(1), R(1), R(1)};
    }
    // Loose triangles: sheets one behind the other, or the two sides of one body.
    if (loose && leaves) std::erase(known_bodies, body);
    if (loose && !leaves && known) {
      filter = filter * share;
      passed.share = share;
    }
  }
  if (general.listener != nullptr) general.listener->at_passed(passed);
  if (is_zero(filter)) return false;
  go_on();
  return true;
}

/// The next hits of n walks from number `first` on.
template <class R>
void find_next(const Batch<R>& batch, std::size_t first, std::size_t n) {
  GeneralWorkspace<R>& general = batch.general;
  Level<R>& level = general.through;
  Scratch<R>& scratch = general.through_scratch;
  for (std::size_t i = 0; i < n; ++i) {
    const Walk<R>& walk = general.walks[first + i];
    level.rays.ox[i] = walk.origin.x;
    level.rays.oy[i] = walk.origin.y;
    level.rays.oz[i] = walk.origin.z;
    level.rays.dx[i] = batch.scratch.sdx[walk.entry];
    level.rays.dy[i] = batch.scratch.sdy[walk.entry];
    level.rays.dz[i] = batch.scratch.sdz[walk.entry];
    if (batch.scene.textures != nullptr)
      level.rays.width[i] = level.rays.spread[i] = level.rays.travelled[i] = R(0);
  }
  level.ray_count = level.in_batch = static_cast<std::int32_t>(n);
  level.done = 0;
  Scratch<R> found = scratch;
  const bool asks_ways = batch.listens() || batch.optics().textured_passing ||
                         (keeps_history(batch) && general.has_groups);
  if (!asks_ways) found.paths = nullptr;
  batch.services.find_hits(batch.scene, level, found);
  for (std::int32_t h = 0; h < level.hit_count && keeps_history(batch) && !asks_ways; ++h)
    start_path(found.slot[level.hits.ray[h]], scratch.paths[h]);
  if (batch.optics().textured_passing) {
    take_coefficients(batch.scene, level, scratch, batch.services.color_hits);
  } else {
    scratch.coefficients = batch.scene.materials;
    scratch.row = scratch.material;
  }
  general.hit_of_walk.assign(n, -1);
  for (std::int32_t h = 0; h < level.hit_count; ++h)
    general.hit_of_walk[static_cast<std::size_t>(level.hits.ray[h])] = h;
}

/// What bodies on the way of general.walks leave of the light, in the order of distance: each body
/// takes its share once, and what absorbs by the length inside (sheet 8.4).
template <class R>
void walk_through(const Batch<R>& batch) {
  constexpr int kMostSurfaces = 1024;
  GeneralWorkspace<R>& general = batch.general;
  const Scratch<R>& scratch = general.through_scratch;
  std::vector<Walk<R>>& walks = general.walks;
  const auto room = static_cast<std::size_t>(general.room);
  const bool keeps = keeps_history(batch);
  WalkHistory none;
  for (int surface = 0; !walks.empty() && surface < kMostSurfaces; ++surface) {
    std::size_t going_on = 0;  // these come first, in the order of the shadow rays
    for (std::size_t first = 0; first < walks.size(); first += room) {
      const std::size_t n = std::min(walks.size() - first, room);
      find_next(batch, first, n);
      for (std::size_t i = 0; i < n; ++i) {
        Walk<R> walk = walks[first + i];
        WalkHistory& history = keeps ? general.histories[first + i] : none;
        const std::int32_t hit = general.hit_of_walk[i];
        const auto t = hit < 0 ? kFarthest : static_cast<double>(scratch.t[i]);
        if (!(t < walk.left)) {
          finish(batch, walk, history);
          continue;
        }
        if (!meet(batch, static_cast<std::size_t>(hit), scratch.slot[i], t, walk, history))
          continue;
        if (batch.settings.filter_first_only) continue;
        walks[going_on] = walk;
        if (keeps && going_on != first + i) std::swap(general.histories[going_on], history);
        ++going_on;
      }
    }
    walks.resize(going_on);
  }
  // Nothing is known of what lies behind so many.
  for (const Walk<R>& walk : walks) general.filter[walk.entry] = {R(0), R(0), R(0)};
}

template <class R>
void start_walk(const Batch<R>& batch, std::size_t entry) {
  GeneralWorkspace<R>& general = batch.general;
  const Scratch<R>& scratch = batch.scratch;
  const auto hit = static_cast<std::size_t>(scratch.shadow_ray_hit[entry]);
  general.walks.push_back({{scratch.sox[hit], scratch.soy[hit], scratch.soz[hit]},
                           entry,
                           static_cast<double>(scratch.sdistance[entry]),
                           0});
  if (!keeps_history(batch)) return;
  const std::size_t number = general.walks.size() - 1;
  if (general.histories.size() <= number) general.histories.resize(number + 1);
  WalkHistory& history = general.histories[number];
  // On the side that the viewer sees.
  history.inside = batch.optics().absorbing ? batch.inside_of(hit) : Inside();
  history.passed.clear();
  history.entered.clear();
  history.start = three(scratch.sox, scratch.soy, scratch.soz, hit);
  history.direction = three(scratch.sdx, scratch.sdy, scratch.sdz, entry);
  const std::int32_t cap = batch.cap_of(hit);
  history.sees_cuts = cap >= 0 && batch.optics().cuts[cap].eye_only;
}

}  // namespace

template <class R>
void find_shadow_origins(const Batch<R>& batch) {
  Scratch<R>& scratch = batch.scratch;
  batch.services.hits->start_shadow_rays(batch.hit_count(), scratch);
  if (batch.scene.textures == nullptr || scratch.smooth_x == nullptr) return;
  for (std::size_t h = 0; h < batch.hit_count(); ++h) {
    if (!batch.is_bent(h)) continue;
    const V3<R> from = narrowed<R>(batch.point(h) + batch.smooth_normal(h) * batch.offset(h));
    scratch.sox[h] = from.x, scratch.soy[h] = from.y, scratch.soz[h] = from.z;
  }
}

template <class R>
void follow_waiting(const Batch<R>& batch) {
  batch.general.walks.clear();
  for (std::size_t entry = 0; entry < batch.general.waiting; ++entry) start_walk(batch, entry);
  walk_through(batch);
}

namespace {

/// Lets those wait no longer that are blocked.
template <class R>
void drop_blocked(const Batch<R>& batch) {
  GeneralWorkspace<R>& general = batch.general;
  std::size_t left = 0;
  for (std::size_t i = 0; i < general.waiting; ++i) {
    move_waiting(batch, i, left);
    left += batch.scratch.blocked[i] == 0 ? 1 : 0;
  }
  general.waiting = left;
}

/// Which of all that wait a scene blocks.
template <class R>
void find_blocked(const Batch<R>& batch, const FrozenScene<R>& scene, Order order) {
  const auto find = order == Order::as_listed ? batch.services.find_blocked_as_listed
                                              : batch.services.find_blocked;
  find(scene, batch.general.waiting, batch.scratch);
}

/// Follows the ways of those that a scene blocks, and finds what is left of them: general.filter.
template <class R>
void follow_blocked(const Batch<R>& batch, const FrozenScene<R>& scene, Order order) {
  GeneralWorkspace<R>& general = batch.general;
  find_blocked(batch, scene, order);
  general.walks.clear();
  for (std::size_t entry = 0; entry < general.waiting; ++entry)
    if (batch.scratch.blocked[entry] != 0 ||
        starts_in_absorber(batch,
                           static_cast<std::size_t>(batch.scratch.shadow_ray_hit[entry])))
      start_walk(batch, entry);
  walk_through(batch);
}

}  // namespace

template <class R>
void trace_waiting(const Batch<R>& batch, Order order) {
  GeneralWorkspace<R>& general = batch.general;
  const Scratch<R>& scratch = batch.scratch;
  general.filter.clear();
  general.maybe_blocked = false;
  const bool listens = batch.listens();
  const auto fill = [&] { general.filter.assign(general.waiting, V3<R>{R(1), R(1), R(1)}); };
  if (listens) fill();
  if (general.waiting == 0 || !batch.settings.terms.shadows) return;
  batch.counts.shadow += general.waiting;
  const Unfollowed<R> scenes(batch);
  if (!listens) {
    if (scenes.dark != nullptr) {
      find_blocked(batch, *scenes.dark, order);
      general.maybe_blocked = scenes.decide();
      if (general.maybe_blocked) return;
      drop_blocked(batch);
    }
    fill();
    follow_blocked(batch, *scenes.asked, order);
    return;
  }
  // Who explains wants to know of all ways; what they come to is the same.
  follow_blocked(batch, batch.scene, order);
  const auto set = [&](const FrozenScene<R>* scene, bool blocked, R left) {
    if (scene == nullptr) return;
    find_blocked(batch, *scene, order);
    for (std::size_t i = 0; i < general.waiting; ++i)
      if ((scratch.blocked[i] != 0) == blocked) general.filter[i] = {left, left, left};
  };
  set(scenes.lit, false, R(1));
  set(scenes.dark, true, R(0));
}

#define ZRAKA_FOR(R)                                  \
  template void find_shadow_origins(const Batch<R>&); \
  template void follow_waiting(const Batch<R>&);      \
  template void trace_waiting(const Batch<R>&, Order);
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka::general
