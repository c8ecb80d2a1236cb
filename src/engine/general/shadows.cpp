// SPDX-License-Identifier: Apache-2.0
#include "engine/general/shadows.hpp"

#include "engine/coefficients.hpp"
#include "engine/general/cuts.hpp"

namespace zraka::general {
namespace {

/// A shadow ray on its way through transparent bodies.
struct Walk {
  std::size_t entry;
  V3<double> origin, direction;
  double left, walked;  ///< how far to the light, and from the hit
  Inside inside;
  /// Bodies that have taken their share, and triangles that the ray is behind.
  std::vector<std::uint64_t> passed;
  // Where there are cuts.
  V3<double> start{};
  bool sees_cuts = false;  ///< those for the eye only, too: it comes from a cap of such a one
  std::vector<std::pair<std::uint64_t, double>> entered{};  ///< bodies, and how far from the hit
};

/// How much of a stretch of a shadow ray's way is in what is left of a material.
double length_in(const FrozenOptics& optics, std::int32_t material, const Walk& walk, double from,
                 double to) {
  if (optics.cut_count == 0) return to - from;
  const KeptPart kept =
      kept_part(optics, &optics.materials[material], walk.start, walk.direction, walk.sees_cuts);
  return std::fmax(0, std::fmin(to, kept.leave) - std::fmax(from, kept.enter));
}

/// Of a surface that is cut away, whether the ray has come through what is left of its body, in by
/// one cap and out by another.
bool has_crossed_caps(const FrozenOptics& optics, const OpticalMaterial& material,
                      std::uint64_t body, bool leaves, Walk& walk) {
  if (!leaves) {
    walk.entered.push_back({body, walk.walked});
    return false;
  }
  double since = -std::numeric_limits<double>::infinity();
  for (const auto& [entered, at] : walk.entered)
    if (entered == body) since = at;
  std::erase_if(walk.entered, [&](const auto& entered) { return entered.first == body; });
  const KeptPart kept = kept_part(optics, &material, walk.start, walk.direction, walk.sees_cuts);
  return since < kept.enter && kept.enter > 0 && kept.enter < std::fmin(kept.leave, walk.walked) &&
         optics.cuts[kept.at_enter].caps;
}

/// Moves a ray from what is cut away to where something is left; false if it never gets there.
bool skip_cut(const FrozenOptics& optics, Walk& walk) {
  const KeptPart all = kept_part(optics, nullptr, walk.start, walk.direction, walk.sees_cuts);
  // Behind them, bodies may end that it has come through between two cuts.
  const bool between = std::any_of(optics.cuts, optics.cuts + optics.cut_count, [&](const auto& c) {
    return dot(c.normal, walk.start) > c.distance && dot(c.normal, walk.direction) < 0;
  });
  const double beyond = between && optics.has_caps ? optics.largest_body : 0;
  if (all.is_empty() || walk.walked > all.leave + beyond) return false;
  if (!(walk.walked < all.enter)) return true;
  walk.left -= all.enter - walk.walked;
  walk.walked = all.enter;
  walk.origin = walk.start + walk.direction * all.enter;
  walk.inside = {};
  return walk.left > 0;
}

/// The last stretch, to the light itself, may be inside of what absorbs.
template <class R>
void finish(const Batch<R>& batch, const Walk& walk, V3<R>& filter) {
  if (!batch.optics().absorbing || !may_be_passed(batch) || !(walk.left < kFarthest / 2)) return;
  const OpticalMaterial* const materials = batch.optics().materials;
  const std::int32_t medium = medium_of(walk.inside, materials);
  if (medium < 0 || !materials[medium].absorbs()) return;
  const double length =
      length_in(batch.optics(), medium, walk, walk.walked, walk.walked + walk.left);
  const V3<R> left = narrowed<R>(transmittance_of(materials[medium].absorption, length));
  filter = filter * left;
  if (batch.general.listener != nullptr)
    batch.general.listener->at_passed({batch.scratch.shadow_ray_hit[walk.entry],
                                       batch.general.of_waiting[walk.entry].sample,
                                       -1,
                                       nullptr,
                                       walk.walked + walk.left,
                                       {R(1), R(1), R(1)},
                                       length,
                                       left});
}

/// What bodies on the way leave of the light, in the order of distance: each body takes its share
/// once, and what absorbs by the length inside (sheet 8.4).
template <class R>
void walk_through(const Batch<R>& batch, std::vector<Walk>& walks) {
  constexpr int kMostSurfaces = 1024;
  GeneralWorkspace<R>& general = batch.general;
  Level<R>& level = general.through;
  Scratch<R>& scratch = general.through_scratch;
  const OpticalMaterial* const materials = batch.optics().materials;
  const auto room = static_cast<std::size_t>(general.room);
  const bool has_cuts = batch.optics().cut_count > 0;
  for (int surface = 0; !walks.empty() && surface < kMostSurfaces; ++surface) {
    std::vector<Walk> going_on;
    for (std::size_t first = 0; first < walks.size(); first += room) {
      const std::size_t n = std::min(walks.size() - first, room);
      for (std::size_t i = 0; i < n; ++i) {
        const Walk& walk = walks[first + i];
        level.rays.ox[i] = static_cast<R>(walk.origin.x);
        level.rays.oy[i] = static_cast<R>(walk.origin.y);
        level.rays.oz[i] = static_cast<R>(walk.origin.z);
        level.rays.dx[i] = static_cast<R>(walk.direction.x);
        level.rays.dy[i] = static_cast<R>(walk.direction.y);
        level.rays.dz[i] = static_cast<R>(walk.direction.z);
        if (batch.scene.textures != nullptr)
          level.rays.width[i] = level.rays.spread[i] = level.rays.travelled[i] = R(0);
      }
      level.ray_count = level.in_batch = static_cast<std::int32_t>(n);
      level.done = 0;
      batch.services.find_hits(batch.scene, level, scratch);
      if (batch.optics().textured_passing) {
        take_coefficients(batch.scene, level, scratch);
      } else {
        scratch.coefficients = batch.scene.materials;
        scratch.row = scratch.material;
      }
      // In the order of the shadow rays, whatever the order of what they hit.
      std::vector<std::int32_t> hit_of(n, -1);
      for (std::int32_t h = 0; h < level.hit_count; ++h)
        hit_of[static_cast<std::size_t>(level.hits.ray[h])] = h;
      for (std::size_t i = 0; i < n; ++i) {
        Walk& walk = walks[first + i];
        V3<R>& filter = general.filter[walk.entry];
        const auto t = hit_of[i] < 0 ? kFarthest : static_cast<double>(scratch.t[i]);
        if (!(t < walk.left)) {
          finish(batch, walk, filter);
          continue;
        }
        const auto h = static_cast<std::size_t>(hit_of[i]);
        const OpticalMaterial& material = materials[scratch.material[h]];
        const R* const row = scratch.coefficients + std::ptrdiff_t{scratch.row[h]} * kMaterialReals;
        const bool leaves = scratch.inside[h] > R(0);
        const std::uint64_t body = body_of(batch.scene, scratch.paths[h], scratch.material[h]);
        const V3<R> share = !material.casts_shadow ? V3<R>{R(1), R(1), R(1)}
                            : may_be_passed(batch) ? refraction_of(material, row)
                                                   : V3<R>{};
        walk.walked += t;
        Passed<R> passed{batch.scratch.shadow_ray_hit[walk.entry],
                         general.of_waiting[walk.entry].sample,
                         scratch.slot[i],
                         &scratch.paths[h],
                         walk.walked,
                         share,
                         0,
                         {R(1), R(1), R(1)}};
        // What it has come through.
        const bool encloses = has_inside(batch.scene, scratch.paths[h]);
        if (encloses && leaves && !is_zero(share)) walk.inside.enter({body, scratch.material[h]});
        if (batch.optics().absorbing) {
          const std::int32_t medium = medium_of(walk.inside, materials);
          if (medium >= 0 && materials[medium].absorbs()) {
            passed.length = length_in(batch.optics(), medium, walk, walk.walked - t, walk.walked);
            passed.transmittance =
                narrowed<R>(transmittance_of(materials[medium].absorption, passed.length));
            filter = filter * passed.transmittance;
          }
        }
        const auto go_on = [&] {
          if (leaves)
            walk.inside.leave(body);
          else if (encloses)
            walk.inside.enter({body, scratch.material[h]});
          const V3<double> normal = three(scratch.nx, scratch.ny, scratch.nz, h);
          walk.origin = three(scratch.px, scratch.py, scratch.pz, h) -
                        normal * static_cast<double>(scratch.offset[h]);
          walk.left -= t;
        };
        if (has_cuts) {
          const FrozenOptics& optics = batch.optics();
          const bool crossed = optics.has_caps && is_solid(batch.scene, scratch.paths[h]) &&
                               has_crossed_caps(optics, material, body, leaves, walk);
          if (!crossed && is_cut(optics, material, three(scratch.px, scratch.py, scratch.pz, h),
                                 walk.sees_cuts)) {
            go_on();
            if (skip_cut(optics, walk))
              going_on.push_back(std::move(walk));
            else
              finish(batch, walk, filter);
            continue;
          }
        }
        const bool known =
            !batch.settings.filter_surfaces &&
            std::find(walk.passed.begin(), walk.passed.end(), body) != walk.passed.end();
        const bool loose = is_loose_triangle(batch.scene, scratch.paths[h]);
        if (!known || is_zero(share)) {  // what is opaque stops it, wherever in a body
          filter = filter * share;
          walk.passed.push_back(body);
        } else {
          passed.share = {R(1), R(1), R(1)};
        }
        // Loose triangles: sheets one behind the other, or the two sides of one body.
        if (loose && leaves) std::erase(walk.passed, body);
        if (loose && !leaves && known) {
          filter = filter * share;
          passed.share = share;
        }
        if (general.listener != nullptr) general.listener->at_passed(passed);
        if (is_zero(filter)) continue;
        go_on();
        going_on.push_back(std::move(walk));
      }
    }
    walks.swap(going_on);
  }
  // Nothing is known of what lies behind so many.
  for (const Walk& walk : walks) general.filter[walk.entry] = {R(0), R(0), R(0)};
}

/// Whether a shadow ray begins inside of what absorbs.
template <class R>
bool starts_in_absorber(const Batch<R>& batch, std::size_t entry) {
  if (!batch.optics().absorbing || !may_be_passed(batch)) return false;
  const auto hit = static_cast<std::size_t>(batch.scratch.shadow_ray_hit[entry]);
  const std::int32_t medium = medium_of(batch.ray_of(hit).inside, batch.optics().materials);
  return medium >= 0 && batch.optics().materials[medium].absorbs();
}

}  // namespace

template <class R>
void find_shadow_origins(const Batch<R>& batch) {
  Scratch<R>& scratch = batch.scratch;
  for (std::size_t h = 0; h < batch.hit_count(); ++h) {
    const V3<R> from = narrowed<R>(batch.point(h) + batch.smooth_normal(h) * batch.offset(h));
    scratch.sox[h] = from.x, scratch.soy[h] = from.y, scratch.soz[h] = from.z;
  }
}

template <class R>
void find_blocked(const Batch<R>& batch) {
  batch.counts.shadow += batch.general.waiting;
  batch.services.find_blocked(batch.scene, batch.general.waiting, batch.scratch);
}

template <class R>
void trace_waiting(const Batch<R>& batch) {
  GeneralWorkspace<R>& general = batch.general;
  const Scratch<R>& scratch = batch.scratch;
  general.filter.assign(general.waiting, V3<R>{R(1), R(1), R(1)});
  if (general.waiting == 0 || !batch.settings.terms.shadows) return;
  find_blocked(batch);
  std::vector<Walk> walks;
  for (std::size_t entry = 0; entry < general.waiting; ++entry) {
    if (scratch.blocked[entry] == 0 && !starts_in_absorber(batch, entry)) continue;
    if (!may_go_on(batch)) {
      general.filter[entry] = {R(0), R(0), R(0)};
      // Whoever explains wants to know what the light is blocked by.
      if (general.listener == nullptr) continue;
    }
    const auto hit = static_cast<std::size_t>(scratch.shadow_ray_hit[entry]);
    Walk walk{entry,
              three(scratch.sox, scratch.soy, scratch.soz, hit),
              three(scratch.sdx, scratch.sdy, scratch.sdz, entry),
              static_cast<double>(scratch.sdistance[entry]),
              0,
              {},
              {}};
    walk.start = walk.origin;
    const std::int32_t cap = batch.hits[hit].cap;
    walk.sees_cuts = cap >= 0 && batch.optics().cuts[cap].eye_only;
    // On the side that the viewer sees.
    if (batch.optics().absorbing) walk.inside = batch.ray_of(hit).inside;
    walks.push_back(std::move(walk));
  }
  walk_through(batch, walks);
}

#define ZRAKA_FOR(R)                                  \
  template void find_shadow_origins(const Batch<R>&); \
  template void find_blocked(const Batch<R>&);        \
  template void trace_waiting(const Batch<R>&);
ZRAKA_FOR(float)
ZRAKA_FOR(double)
#undef ZRAKA_FOR

}  // namespace zraka::general
