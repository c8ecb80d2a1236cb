// SPDX-License-Identifier: Apache-2.0
#include "engine/general/cuts.hpp"
#include "scene/reals.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace zraka::general {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Of rays through so many surfaces nobody knows what is behind.
constexpr int kMostPasses = 4096;

bool counts(const OpticalCut& cut, bool sees_all) {
  return sees_all || !cut.eye_only;
}
bool concerns(const OpticalCut& cut, const OpticalMaterial* material, bool sees_all) {
  return counts(cut, sees_all) &&
         (cut.group == 0 || (material != nullptr && cut.group == material->cut_group));
}

/// How far it is to a cut's plane, less than 0 behind the ray; infinite along it.
double distance_to(const OpticalCut& cut, const V3<double>& origin, const V3<double>& direction) {
  const double change = dot(cut.normal, direction);
  return change == 0 ? kInfinity : (cut.distance - dot(cut.normal, origin)) / change;
}

}  // namespace

KeptPart kept_part(const FrozenOptics& optics, const OpticalMaterial* material,
                   const V3<double>& origin, const V3<double>& direction, bool sees_all) {
  KeptPart kept;
  for (std::int32_t i = 0; i < optics.cut_count; ++i) {
    const OpticalCut& cut = optics.cuts[i];
    if (!concerns(cut, material, sees_all)) continue;
    const double change = dot(cut.normal, direction);
    const double at = distance_to(cut, origin, direction);
    if (change == 0) {
      if (dot(cut.normal, origin) > cut.distance) kept.leave = -kInfinity;
    } else if (change < 0 && at > kept.enter) {
      kept.enter = at, kept.at_enter = i;
    } else if (change > 0 && at < kept.leave) {
      kept.leave = at, kept.at_leave = i;
    }
  }
  return kept;
}

bool is_cut(const FrozenOptics& optics, const OpticalMaterial& material, const V3<double>& point,
            bool sees_all) {
  return std::any_of(optics.cuts, optics.cuts + optics.cut_count, [&](const OpticalCut& cut) {
    return concerns(cut, &material, sees_all) && dot(cut.normal, point) > cut.distance;
  });
}

template <class R>
bool is_solid(const FrozenScene<R>& scene, const HitPath& path) {
  if (!has_inside(scene, path)) return false;
  const std::int32_t body = path.slot - scene.bodies.first_slot;
  return path.depth > 0 || body < 0 || body < scene.bodies.bounded || body >= scene.bodies.count;
}

template <class R>
void copy_hit(const Scratch<R>& source, std::size_t from, Scratch<R>& target, std::size_t to) {
  target.px[to] = source.px[from], target.py[to] = source.py[from], target.pz[to] = source.pz[from];
  target.nx[to] = source.nx[from], target.ny[to] = source.ny[from], target.nz[to] = source.nz[from];
  target.vx[to] = source.vx[from], target.vy[to] = source.vy[from], target.vz[to] = source.vz[from];
  target.offset[to] = source.offset[from];
  target.inside[to] = source.inside[from];
  target.mirror_side[to] = source.mirror_side[from];
  target.material[to] = source.material[from];
  target.paths[to] = source.paths[from];
}

template <class R>
CutWalks<R>::CutWalks(const FrozenScene<R>& scene, const Services<R>& services, Level<R>& level,
                      Scratch<R>& scratch, GeneralWorkspace<R>& general, const RayState<R>* rays)
    : scene_(scene),
      optics_(*scene.optics),
      services_(services),
      level_(level),
      scratch_(scratch),
      general_(general),
      rays_(rays) {
  general_.caps.resize(static_cast<std::size_t>(level.hit_count), -1);
}

template <class R>
typename CutWalks<R>::Walk CutWalks<R>::walk_of(std::size_t h) const {
  const auto of = static_cast<std::size_t>(level_.hits.ray[h]);
  const std::size_t ray = static_cast<std::size_t>(level_.done) + of;
  Walk walk{h,
            of,
            three(level_.rays.ox, level_.rays.oy, level_.rays.oz, ray),
            three(level_.rays.dx, level_.rays.dy, level_.rays.dz, ray),
            {},
            rays_ == nullptr || rays_[ray].sees_cuts};
  walk.at = static_cast<double>(scratch_.t[of]);
  return walk;
}

template <class R>
void CutWalks<R>::add_hit(std::size_t h) {
  if (optics_.cut_count == 0) return;
  Walk walk = walk_of(h);
  meet(walk, scratch_, h, scratch_.slot[walk.ray]);
  if (goes_on(walk)) walks_.push_back(std::move(walk));
}

template <class R>
void CutWalks<R>::add_onward(std::size_t h) {
  Walk walk = walk_of(h);
  walk.passed = walk.at;
  walk.origin =
      three(scratch_.px, scratch_.py, scratch_.pz, h) -
      three(scratch_.nx, scratch_.ny, scratch_.nz, h) * static_cast<double>(scratch_.offset[h]);
  general_.caps[h] = -1;
  walks_.push_back(std::move(walk));
}

/// Whether what comes behind may matter. If not, its ray has what is nearest.
template <class R>
bool CutWalks<R>::goes_on(Walk& walk) const {
  const KeptPart all = kept_part(optics_, nullptr, walk.start, walk.direction, walk.sees_all);
  if (walk.nearest == kInfinity) {
    const double last = std::fmax(all.leave, 0.0) + (optics_.has_caps ? optics_.largest_body : 0);
    if (all.is_empty() || walk.at > last) {
      scratch_.slot[walk.ray] = -1;
      return false;
    }
  } else {
    // Bodies that have a cap before that, or a better one there.
    constexpr double kMargin = 1.001;  // of roundings
    double last = -kInfinity;
    for (std::int32_t i = 0; i < optics_.cut_count; ++i) {
      const OpticalCut& cut = optics_.cuts[i];
      if (!cut.caps || !counts(cut, walk.sees_all)) continue;
      const double at = distance_to(cut, walk.start, walk.direction);
      if (!(at > walk.passed) || at > walk.nearest) continue;
      const double size = walk.is_cap && at == walk.nearest
                              ? std::fmin(walk.size, optics_.largest_body)
                              : optics_.largest_body;
      last = std::fmax(last, at + size * kMargin);
    }
    if (!(walk.at < last)) return false;
  }
  if (walk.at < all.enter) {
    walk.origin = walk.start + walk.direction * all.enter;
    walk.at = all.enter;
  }
  return true;
}

template <class R>
void CutWalks<R>::meet(Walk& walk, const Scratch<R>& found, std::size_t i, std::int32_t slot) {
  const V3<double> point = three(found.px, found.py, found.pz, i);
  const OpticalMaterial& material = optics_.materials[found.material[i]];
  walk.origin =
      point - three(found.nx, found.ny, found.nz, i) * static_cast<double>(found.offset[i]);
  const bool solid = optics_.has_caps && is_solid(scene_, found.paths[i]);
  if (walk.at < walk.nearest && !is_cut(optics_, material, point, walk.sees_all)) {
    walk.nearest = walk.at;
    walk.is_cap = false;
    general_.caps[walk.h] = -1;
    if (&found != &scratch_) {
      // The first hit is the cap's as well, whose numbers are not those that change here.
      copy_hit(found, i, scratch_, walk.h);
      scratch_.t[walk.ray] = static_cast<R>(walk.at);
      scratch_.slot[walk.ray] = slot;
    }
  }
  if (solid) meet_solid(walk, found, i, slot);
}

template <class R>
void CutWalks<R>::meet_solid(Walk& walk, const Scratch<R>& found, std::size_t i,
                             std::int32_t slot) {
  const std::uint64_t body = body_of(scene_, found.paths[i], found.material[i]);
  if (!(found.inside[i] > R(0))) {
    walk.entered.push_back({body, walk.at});
    return;
  }
  double since = -kInfinity;
  for (const Entered& entered : walk.entered)
    if (entered.body == body) since = entered.at;
  std::erase_if(walk.entered, [&](const Entered& entered) { return entered.body == body; });
  const OpticalMaterial& material = optics_.materials[found.material[i]];
  const KeptPart kept = kept_part(optics_, &material, walk.start, walk.direction, walk.sees_all);
  const double first = std::fmax(std::fmax(since, kept.enter), walk.passed);
  const double last = std::fmin(walk.at, kept.leave);
  if (!(first < last)) return;
  if (first == kept.enter && optics_.cuts[kept.at_enter].caps)
    take_cap(walk, found, i, slot, kept.at_enter, first, true);
  else if (last == kept.leave && optics_.cuts[kept.at_leave].caps)
    take_cap(walk, found, i, slot, kept.at_leave, last, false);
}

template <class R>
void CutWalks<R>::take_cap(Walk& walk, const Scratch<R>& found, std::size_t i, std::int32_t slot,
                           std::int32_t cut, double at, bool enters) {
  const int priority = optics_.materials[found.material[i]].priority;
  const double size = size_of(found.paths[i]);
  const std::int64_t id = id_of(found.paths[i]);
  if (at > walk.nearest) return;
  if (at == walk.nearest && walk.is_cap &&
      std::tuple(-priority, size, id) >= std::tuple(-walk.priority, walk.size, walk.id))
    return;
  walk.nearest = at;
  walk.is_cap = true;
  walk.priority = priority;
  walk.size = size;
  walk.id = id;
  general_.caps[walk.h] = cut;
  Scratch<R>& s = scratch_;
  if (&found != &s) copy_hit(found, i, s, walk.h);
  const V3<double> point = walk.start + walk.direction * at;
  const V3<double> normal = optics_.cuts[cut].normal * (enters ? 1.0 : -1.0);
  s.px[walk.h] = static_cast<R>(point.x), s.py[walk.h] = static_cast<R>(point.y);
  s.pz[walk.h] = static_cast<R>(point.z);
  s.nx[walk.h] = static_cast<R>(normal.x), s.ny[walk.h] = static_cast<R>(normal.y);
  s.nz[walk.h] = static_cast<R>(normal.z);
  s.inside[walk.h] = enters ? R(0) : R(1);
  s.mirror_side[walk.h] = R(1);
  s.t[walk.ray] = static_cast<R>(at);
  s.slot[walk.ray] = slot;
}

/// Bodies in groups are as large as what stands in the scene.
template <class R>
double CutWalks<R>::size_of(const HitPath& path) const {
  const auto& bodies = scene_.bodies;
  const auto radius = [&](const auto& spheres) {
    return 2 * static_cast<double>(spheres.column[3][path.slot - spheres.first_slot]);
  };
  const auto is_in = [&](const auto& shapes) {
    return path.slot >= shapes.first_slot && path.slot < shapes.first_slot + shapes.count;
  };
  if (path.depth == 0 && is_in(scene_.spheres)) return radius(scene_.spheres);
  if (path.depth == 0 && is_in(scene_.anchored_spheres)) return radius(scene_.anchored_spheres);
  return static_cast<double>(optics_.body_sizes[id_of(path) - bodies.first_id]);
}

template <class R>
std::int64_t CutWalks<R>::id_of(const HitPath& path) const {
  const auto& bodies = scene_.bodies;
  if (path.depth > 0) return bodies.id[path.instance[0]];
#define ZRAKA_IF(Type, plural)                                      \
  if (const std::int32_t at = path.slot - scene_.plural.first_slot; \
      at >= 0 && at < scene_.plural.count)                          \
    return scene_.plural.id[at];
  ZRAKA_KINDS(ZRAKA_IF)
#undef ZRAKA_IF
  return bodies.first_id;
}

/// Each to the next surface.
template <class R>
void CutWalks<R>::follow(const std::vector<Walk*>& walks, std::vector<Walk*>& still) {
  Level<R>& through = general_.through;
  Scratch<R>& found = general_.through_scratch;
  for (std::size_t i = 0; i < walks.size(); ++i) {
    const V3<R> from = narrowed<R>(walks[i]->origin), way = narrowed<R>(walks[i]->direction);
    through.rays.ox[i] = from.x, through.rays.oy[i] = from.y, through.rays.oz[i] = from.z;
    through.rays.dx[i] = way.x, through.rays.dy[i] = way.y, through.rays.dz[i] = way.z;
  }
  through.ray_count = through.in_batch = static_cast<std::int32_t>(walks.size());
  through.done = 0;
  services_.find_hits(scene_, through, found);
  std::vector<bool> meets(walks.size(), false);
  for (std::size_t i = 0; i < static_cast<std::size_t>(through.hit_count); ++i) {
    const auto ray = static_cast<std::size_t>(through.hits.ray[i]);
    meets[ray] = true;
    Walk& walk = *walks[ray];
    walk.at = static_cast<double>(static_cast<R>(walk.at + static_cast<double>(found.t[ray])));
    meet(walk, found, i, found.slot[ray]);
    if (goes_on(walk)) still.push_back(&walk);
  }
  for (std::size_t i = 0; i < walks.size(); ++i)
    if (!meets[i] && walks[i]->nearest == kInfinity) scratch_.slot[walks[i]->ray] = -1;
}

template <class R>
void CutWalks<R>::run() {
  std::vector<Walk*> walks, still;
  for (Walk& walk : walks_) walks.push_back(&walk);
  const auto room = static_cast<std::size_t>(general_.room);
  for (int pass = 0; !walks.empty() && pass < kMostPasses; ++pass) {
    for (std::size_t first = 0; first < walks.size(); first += room) {
      const auto from = walks.begin() + static_cast<std::ptrdiff_t>(first);
      follow({from, from + static_cast<std::ptrdiff_t>(std::min(room, walks.size() - first))},
             still);
    }
    walks.swap(still);
    still.clear();
  }
  for (const Walk* walk : walks)
    if (walk->nearest == kInfinity) scratch_.slot[walk->ray] = -1;
  walks_.clear();
}

template <class R>
void drop_lost_hits(Level<R>& level, Scratch<R>& scratch, std::vector<std::int32_t>& caps) {
  std::int32_t kept = 0;
  for (std::int32_t h = 0; h < level.hit_count; ++h) {
    if (scratch.slot[level.hits.ray[h]] < 0) continue;
    if (kept != h) {
      level.hits.ray[kept] = level.hits.ray[h];
      caps[static_cast<std::size_t>(kept)] = caps[static_cast<std::size_t>(h)];
      copy_hit(scratch, static_cast<std::size_t>(h), scratch, static_cast<std::size_t>(kept));
    }
    ++kept;
  }
  level.hit_count = kept;
}

template <class R>
void find_uncut_hits(const FrozenScene<R>& scene, const Services<R>& services, Level<R>& level,
                     Scratch<R>& scratch, GeneralWorkspace<R>& general) {
  services.find_hits(scene, level, scratch);
  general.caps.clear();
  CutWalks<R> walks(scene, services, level, scratch, general, nullptr);
  for (std::size_t h = 0; h < static_cast<std::size_t>(level.hit_count); ++h) walks.add_hit(h);
  walks.run();
  drop_lost_hits(level, scratch, general.caps);
}

#define ZRAKA_FOR(R)                                                                               \
  template bool is_solid(const FrozenScene<R>&, const HitPath&);                                   \
  template void copy_hit(const Scratch<R>&, std::size_t, Scratch<R>&, std::size_t);                \
  template class CutWalks<R>;                                                                      \
  template void drop_lost_hits(Level<R>&, Scratch<R>&, std::vector<std::int32_t>&);                \
  template void find_uncut_hits(const FrozenScene<R>&, const Services<R>&, Level<R>&, Scratch<R>&, \
                                GeneralWorkspace<R>&);
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka::general
