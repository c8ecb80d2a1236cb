// SPDX-License-Identifier: Apache-2.0
// Children of the general engine's hits: the shares by Fresnel, the directions by Snell, one for
// each wavelength where a body is dispersive; and what is not worth tracing (sheet 8.3).
#include <algorithm>
#include <utility>

#include "engine/coefficients.hpp"
#include "engine/general/steps.hpp"
#include "materials/dispersion.hpp"
#include "sampling/hash.hpp"
#include "scene/reals.hpp"

namespace zraka::general {

namespace {

double index_of(const OpticalMaterial* materials, std::int32_t material, double um) {
  if (material < 0) return 1;
  const OpticalMaterial& m = materials[material];
  return m.is_dispersive() && um > 0 ? refractive_index(m.dispersion, m.ior, um) : m.ior;
}

/// Finds the children of hits, of some at a time: lanes say how light bends there, then each hit
/// what its children count, and lanes where these go.
template <class R>
class Spawner {
 public:
  Spawner(const Batch<R>& batch, Level<R>& next, RayState<R>* rays, Inside* insides,
          bool names_children)
      : batch_(batch),
        next_(next),
        rays_(rays),
        insides_(insides),
        of_(batch.general.spawning),
        named_{names_children ? batch.level.hits.reflected : nullptr,
               names_children ? batch.level.hits.refracted : nullptr} {}

  void spawn_all() {
    const std::vector<std::int32_t>& parents = batch_.columns.parents;
    const int most_ways = std::max(1, batch_.settings.wavelengths.count);
    for (std::size_t first = 0; first < parents.size();) {
      std::size_t end = first;
      int bends = 0;
      for (; end < parents.size() && bends + most_ways <= Spawning::kMost &&
             end - first < Spawning::kMost;
           ++end)
        add_bends(static_cast<std::size_t>(parents[end]), bends);
      spawn_of(parents.data() + first, end - first, bends);
      first = end;
    }
  }

 private:
  /// What hits of one material have in common.
  struct Surface {
    const OpticalMaterial* material;
    V3<R> k1, k2, reflection, refraction;  ///< the latter without what a stage leaves out
    bool has_children, refracts, by_fresnel, splits;
  };
  /// A child that may be worth it.
  struct Part {
    V3<R> share;
    int bend;  ///< -1: it is reflected
    std::int32_t wavelength;
  };

  const Surface& surface_at(std::size_t h) {
    const std::int32_t material = batch_.scratch.material[h];
    if (material != known_material_) learn_surface(h, material);
    return surface_;
  }

  void learn_surface(std::size_t h, std::int32_t number) {
    const OpticalMaterial& material = batch_.optics().materials[number];
    const Terms& terms = batch_.settings.terms;
    Surface& s = surface_;
    s.material = &material;
    s.k1 = reflection_of(material, batch_.row(h));
    s.k2 = refraction_of(material, batch_.row(h));
    s.reflection = terms.reflection ? s.k1 : V3<R>{};
    s.refraction = terms.refraction ? s.k2 : V3<R>{};
    s.has_children = batch_.listens() || !is_zero(s.k1) || !is_zero(s.k2);
    s.refracts = !is_zero(s.refraction);
    s.by_fresnel = material.fresnel != Fresnel::off;
    s.splits = material.is_dispersive() && batch_.settings.wavelengths.count > 1;
    // Where textures say what goes on, each hit has its own.
    known_material_ = material.textured_k1 || material.textured_k2 ? -1 : number;
  }

  double index_at(std::int32_t material, std::int32_t wavelength) {
    const OpticalMaterial* const materials = batch_.optics().materials;
    if (material < 0 || wavelength < 0 || !materials[material].is_dispersive())
      return index_of(materials, material, 0);
    const Wavelengths& waves = batch_.settings.wavelengths;
    if (material != indexed_) {
      std::fill_n(indices_, waves.count, -1.0);
      indexed_ = material;
    }
    double& index = indices_[wavelength];
    if (!(index >= 0)) index = index_of(materials, material, waves.um[wavelength]);
    return index;
  }

  int ways_of(const Surface& surface, std::int32_t wavelength) const {
    if (!surface.refracts) return 0;
    return surface.splits && wavelength < 0 ? batch_.settings.wavelengths.count : 1;
  }

  /// A hit's bends; they are known after the service has been called.
  void add_bends(std::size_t h, int& bends) {
    const Surface& surface = surface_at(h);
    if (!surface.refracts) return;
    const std::int32_t wavelength = surface.splits ? batch_.ray_of(h).wavelength : -1;
    const int ways = ways_of(surface, wavelength);
    const FrozenOptics& optics = batch_.optics();
    const std::int32_t own = batch_.scratch.material[h];
    const bool from_inside = batch_.from_inside(h);
    std::int32_t in_front = from_inside ? own : -1, behind = from_inside ? -1 : own;
    if (optics.nested && !optics.index_is_ratio && batch_.hits[h].enclosing) {
      Inside with = batch_.inside_of(h), without = with;
      with.enter({batch_.hits[h].body, own});
      without.leave(batch_.hits[h].body);
      in_front = medium_of(from_inside ? with : without, optics.materials);
      behind = medium_of(from_inside ? without : with, optics.materials);
    } else if (optics.index_is_ratio) {
      std::swap(in_front, behind);  // the lab's ni is n1/n2 on entry
    }
    for (int i = 0; i < ways; ++i, ++bends) {
      const std::int32_t of = ways > 1 ? i : batch_.ray_of(h).wavelength;
      of_.hit[bends] = static_cast<std::int32_t>(h);
      of_.n1[bends] = index_at(in_front, of), of_.n2[bends] = index_at(behind, of);
      of_.by[bends] = static_cast<double>(surface.material->fresnel);
    }
  }

  /// Children of n parents, which have so many bends.
  void spawn_of(const std::int32_t* parents, std::size_t n, int bends) {
    const HitServices<R>& services = *batch_.services.hits;
    if (bends > 0)
      services.find_bends(static_cast<std::size_t>(bends), batch_.scratch,
                          {of_.hit, of_.n1, of_.n2, of_.by, of_.ratio, of_.quarter_d, of_.fresnel});
    const auto first = static_cast<std::size_t>(next_.ray_count);
    int bend = 0, children = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const auto h = static_cast<std::size_t>(parents[i]);
      if (const Surface& surface = surface_at(h); surface.has_children)
        spawn_at(h, surface, bend, children);
    }
    if (children > 0)
      services.aim_children(static_cast<std::size_t>(children), batch_.scratch,
                            {of_.child_hit, of_.child_ratio, of_.child_quarter_d}, first,
                            next_.rays);
  }

  bool is_total(int bend) const { return !(of_.quarter_d[bend] >= 0); }

  ZRAKA_INLINE void spawn_at(std::size_t h, const Surface& surface, int& bend, int& children) {
    const TraceSettings& settings = batch_.settings;
    const RayState<R>& ray = batch_.ray_of(h);
    const int first = bend, ways = ways_of(surface, ray.wavelength);
    bend += ways;
    V3<R> reflection = surface.reflection;
    Part parts[kMaxWavelengths + 1];
    int count = 1;  // the first is reflected
    for (int i = 0; i < ways; ++i) {
      V3<R> share = surface.refraction;
      if (ways > 1)
        share = share * V3<R>{static_cast<R>(settings.wavelengths.weight[i][0]),
                              static_cast<R>(settings.wavelengths.weight[i][1]),
                              static_cast<R>(settings.wavelengths.weight[i][2])};
      if (is_total(first + i)) {
        if (settings.mirror_when_total || surface.by_fresnel) reflection = reflection + share;
        continue;
      }
      if (surface.by_fresnel) {
        const auto f = static_cast<R>(of_.fresnel[first + i]);
        reflection = reflection + share * f;
        share = share * (R(1) - f);
      }
      parts[count++] = {share, first + i, ways > 1 ? i : ray.wavelength};
    }
    // A stage without reflection has none that refraction brings, either.
    if (!settings.terms.reflection && !settings.mirror_when_total) reflection = V3<R>{};
    parts[0] = {reflection, -1, ray.wavelength};
    add_parts(h, ray, parts, count, children);
    if (batch_.listens()) tell(h, surface, first, ways, parts, count);
  }

  /// Appends those that are worth it.
  ZRAKA_INLINE void add_parts(std::size_t h, const RayState<R>& parent, const Part* parts,
                              int count, int& children) {
    HitState<R>& hit = batch_.hits[h];
    const bool media = batch_.has_media(), draws = batch_.general.draws;
    const bool cuts = batch_.settings.min_contribution > 0;
    const V3<R> seen = media ? parent.weight * batch_.transmittance_of(h) : parent.weight;
    // What is seen of a cap for the eye only is as if all rays knew of it.
    const bool sees_cuts = hit.cap >= 0 && batch_.optics().cuts[hit.cap].eye_only;
    const std::int32_t first = next_.ray_count;
    std::int32_t at = first;
    for (int i = 0; i < count; ++i) {
      const Part& part = parts[i];
      if (is_zero(part.share)) continue;
      const V3<R> weight = seen * part.share;
      const bool enters = part.bend >= 0;
      if (cuts && is_cut(hit, part.share, weight, enters)) continue;
      of_.child_hit[children] = static_cast<std::int32_t>(h);
      of_.child_ratio[children] = enters ? of_.ratio[part.bend] : 0;
      of_.child_quarter_d[children] = enters ? of_.quarter_d[part.bend] : -1;
      ++children;
      RayState<R>& ray = rays_[at];
      ray.share = part.share;
      ray.weight = weight;
      ray.cut = R(0);
      if (draws) ray.key = hash(parent.key, static_cast<std::uint32_t>(at - first) + 1u);
      ray.sample = parent.sample;
      ray.wavelength = part.wavelength;
      ray.kind = enters ? RayKind::refracted : RayKind::reflected;
      ray.sees_cuts = sees_cuts;
      if (media) enter_media(h, hit, enters, insides_[at]);
      if (named_[enters] != nullptr) named_[enters][h] = at;
      ++(enters ? batch_.counts.refracted : batch_.counts.reflected);
      ++at;
    }
    hit.first_child = first;
    hit.child_count = at - first;
    next_.ray_count = at;
  }

  bool is_cut(HitState<R>& hit, const V3<R>& share, const V3<R>& weight, bool enters) const {
    const TraceSettings& settings = batch_.settings;
    const V3<R>& counts = settings.cut_by_share ? share : weight;
    if (!(static_cast<double>(most_size(counts)) * settings.brightest < settings.min_contribution))
      return false;
    const auto brightest = static_cast<R>(settings.brightest);
    hit.missing =
        hit.missing + V3<R>{std::fabs(share.x), std::fabs(share.y), std::fabs(share.z)} * brightest;
    ++batch_.counts.cut;
    (enters ? hit.refracted_cut : hit.reflected_cut) = true;
    return true;
  }

  ZRAKA_INLINE void enter_media(std::size_t h, const HitState<R>& hit, bool enters,
                                Inside& inside) const {
    inside = batch_.inside_of(h);
    if (!enters || !hit.enclosing) return;
    if (batch_.from_inside(h))
      inside.leave(hit.body);
    else
      inside.enter({hit.body, batch_.scratch.material[h]});
  }

  /// What explanations say of a hit, of its middle wavelength where it has several.
  void tell(std::size_t h, const Surface& surface, int first, int ways, const Part* parts,
            int count) const {
    HitState<R>& hit = batch_.hits[h];
    hit.k1 = surface.k1, hit.k2 = surface.k2;
    hit.cosine = std::fabs(dot(batch_.view(h), batch_.normal(h)));
    hit.ratio = hit.n1 = hit.n2 = 1;
    hit.refracts = ways > 0;
    hit.split = ways > 1;
    hit.reflection = parts[0].share;
    hit.refraction = {};
    for (int i = 1; i < count; ++i) hit.refraction = hit.refraction + parts[i].share;
    if (ways == 0) return;
    const int bend = first + ways / 2;
    hit.n1 = of_.n1[bend], hit.n2 = of_.n2[bend];
    hit.ratio = of_.ratio[bend], hit.quarter_d = of_.quarter_d[bend];
    hit.fresnel = of_.fresnel[bend];
    hit.total = is_total(bend);
  }

  const Batch<R>& batch_;
  Level<R>& next_;
  RayState<R>* rays_;
  Inside* insides_;
  Spawning& of_;
  std::int32_t* named_[2];  ///< HitArrays::reflected and refracted; nullptr: nobody asks
  std::int32_t known_material_ = -1;
  Surface surface_;
  // The indices that are known of a material, by wavelength; -1: not yet.
  std::int32_t indexed_ = -1;
  double indices_[kMaxWavelengths];
};

/// Lanes take the normals of all hits from where those are kept that textures have bent.
template <class R>
void keep_other_normals(const Batch<R>& batch) {
  const Scratch<R>& scratch = batch.scratch;
  if (scratch.smooth_x == nullptr) return;
  for (const std::int32_t parent : batch.columns.parents) {
    const auto h = static_cast<std::size_t>(parent);
    if (batch.is_bent(h)) continue;
    scratch.smooth_x[h] = scratch.nx[h];
    scratch.smooth_y[h] = scratch.ny[h];
    scratch.smooth_z[h] = scratch.nz[h];
  }
}

}  // namespace

template <class R>
void spawn(const Batch<R>& batch, Level<R>& next, RayState<R>* next_rays, Inside* next_insides) {
  const HitArrays<R>& hits = batch.level.hits;
  const bool names_children = batch.listens() || batch.scene.textures != nullptr;
  if (names_children) {
    std::fill_n(hits.reflected, batch.hit_count(), -1);
    std::fill_n(hits.refracted, batch.hit_count(), -1);
  }
  keep_other_normals(batch);
  Spawner<R>(batch, next, next_rays, next_insides, names_children).spawn_all();
  if (batch.scene.textures == nullptr) return;
  spread_cones(batch.level, batch.scratch, next);
  // All wavelengths have the cone of the last.
  for (const std::int32_t h : batch.columns.parents) {
    const HitState<R>& hit = batch.hits[h];
    const std::int32_t of = hits.refracted[h];
    for (std::int32_t c = hit.first_child; c < of; ++c)
      if (next_rays[c].kind == RayKind::refracted)
        next.rays.width[c] = next.rays.width[of], next.rays.spread[c] = next.rays.spread[of],
        next.rays.travelled[c] = next.rays.travelled[of];
  }
}

#define ZRAKA_FOR(R) template void spawn(const Batch<R>&, Level<R>&, RayState<R>*, Inside*);
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka::general
