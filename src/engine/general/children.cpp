// SPDX-License-Identifier: Apache-2.0
// Children of the general engine's hits: the shares by Fresnel, the directions by Snell, one for
// each wavelength where a body is dispersive; and what is not worth tracing (sheet 8.3).
#include "engine/coefficients.hpp"
#include "engine/general/steps.hpp"
#include "materials/dispersion.hpp"
#include "sampling/hash.hpp"
#include "scene/reals.hpp"

namespace zraka::general {

double fresnel_exact(double cosine, double eta) {
  const double sine2 = eta * eta * (1 - cosine * cosine);
  if (!(sine2 < 1)) return 1;
  const double other = std::sqrt(1 - sine2);
  // Divided by n2: r across = (n1·cosα - n2·cosβ)/(n1·cosα + n2·cosβ), r along likewise.
  const double across = (eta * cosine - other) / (eta * cosine + other);
  const double along = (cosine - eta * other) / (cosine + eta * other);
  return 0.5 * (across * across + along * along);
}

double fresnel_schlick(double cosine, double eta) {
  double c = cosine;
  if (eta > 1) {
    const double sine2 = eta * eta * (1 - cosine * cosine);
    if (!(sine2 < 1)) return 1;
    c = std::sqrt(1 - sine2);
  }
  const double straight = (eta - 1) / (eta + 1), f0 = straight * straight;
  const double m = 1 - c, m2 = m * m;
  return f0 + (1 - f0) * (m2 * m2 * m);
}

namespace {

/// Snell's law at a hit, for one wavelength.
struct Bend {
  double n1, n2, ratio, quarter_d, fresnel;
  bool total() const { return !(quarter_d >= 0); }
};

double index_of(const OpticalMaterial* materials, std::int32_t material, double um) {
  if (material < 0) return 1;
  const OpticalMaterial& m = materials[material];
  return m.is_dispersive() && um > 0 ? refractive_index(m.dispersion, m.ior, um) : m.ior;
}

/// `um` is 0 for white light.
template <class R>
Bend bend_at(const Batch<R>& batch, std::size_t h, double cosine, double um) {
  const FrozenOptics& optics = batch.optics();
  const OpticalMaterial* const materials = optics.materials;
  const OpticalMaterial& material = batch.material(h);
  const std::int32_t own = batch.scratch.material[h];
  const bool from_inside = batch.from_inside(h);
  Bend bend{1, 1, 1, 0, 0};
  if (optics.nested && !optics.index_is_ratio && batch.hits[h].enclosing) {
    Inside with = batch.inside_of(h), without = with;
    with.enter({batch.hits[h].body, own});
    without.leave(batch.hits[h].body);
    const double n_with = index_of(materials, medium_of(with, materials), um);
    const double n_without = index_of(materials, medium_of(without, materials), um);
    bend.n1 = from_inside ? n_with : n_without;
    bend.n2 = from_inside ? n_without : n_with;
  } else {
    const double n = index_of(materials, own, um);
    // The lab's ni is n1/n2 on entry.
    const bool dense = from_inside != optics.index_is_ratio;
    bend.n1 = dense ? n : 1;
    bend.n2 = dense ? 1 : n;
  }
  bend.ratio = bend.n1 / bend.n2;
  bend.quarter_d = bend.ratio * bend.ratio * cosine * cosine - bend.ratio * bend.ratio + 1;
  if (material.fresnel == Fresnel::exact)
    bend.fresnel = fresnel_exact(std::fabs(cosine), bend.ratio);
  if (material.fresnel == Fresnel::schlick)
    bend.fresnel = fresnel_schlick(std::fabs(cosine), bend.ratio);
  return bend;
}

/// Appends a child, if it is worth it; its index among the hit's, or -1.
template <class R>
class Spawner {
 public:
  Spawner(const Batch<R>& batch, Level<R>& next, RayState<R>* rays, Inside* insides)
      : batch_(batch), next_(next), rays_(rays), insides_(insides) {}

  bool add(std::size_t h, RayKind kind, const V3<R>& share, const V3<double>& direction,
           std::int32_t wavelength) {
    HitState<R>& hit = batch_.hits[h];
    const RayState<R>& parent = batch_.ray_of(h);
    const V3<R> seen =
        batch_.has_media() ? parent.weight * batch_.transmittance_of(h) : parent.weight;
    const V3<R> weight = seen * share;
    const TraceSettings& settings = batch_.settings;
    const V3<R>& counts = settings.cut_by_share ? share : weight;
    if (settings.min_contribution > 0 &&
        static_cast<double>(most_size(counts)) * settings.brightest < settings.min_contribution) {
      const auto brightest = static_cast<R>(settings.brightest);
      hit.missing = hit.missing +
                    V3<R>{std::fabs(share.x), std::fabs(share.y), std::fabs(share.z)} * brightest;
      ++batch_.counts.cut;
      return false;
    }
    const auto at = static_cast<std::size_t>(next_.ray_count++);
    const double side =
        kind == RayKind::reflected ? static_cast<double>(batch_.scratch.mirror_side[h]) : -1;
    const V3<double> origin = batch_.point(h) + batch_.smooth_normal(h) * (side * batch_.offset(h));
    const V3<double> way = unit(direction);
    next_.rays.ox[at] = static_cast<R>(origin.x), next_.rays.oy[at] = static_cast<R>(origin.y);
    next_.rays.oz[at] = static_cast<R>(origin.z), next_.rays.dx[at] = static_cast<R>(way.x);
    next_.rays.dy[at] = static_cast<R>(way.y), next_.rays.dz[at] = static_cast<R>(way.z);
    RayState<R>& ray = rays_[at];
    ray.share = share;
    ray.weight = weight;
    ray.cut = R(0);
    if (batch_.general.draws)
      ray.key = hash(parent.key, static_cast<std::uint32_t>(hit.child_count) + 1u);
    ray.sample = parent.sample;
    ray.wavelength = wavelength;
    ray.kind = kind;
    // What is seen of a cap for the eye only is as if all rays knew of it.
    ray.sees_cuts = hit.cap >= 0 && batch_.optics().cuts[hit.cap].eye_only;
    if (batch_.has_media()) {
      Inside& inside = insides_[at] = batch_.inside_of(h);
      if (kind == RayKind::refracted && hit.enclosing) {
        if (batch_.from_inside(h))
          inside.leave(hit.body);
        else
          inside.enter({hit.body, batch_.scratch.material[h]});
      }
    }
    ++hit.child_count;
    kind == RayKind::reflected ? ++batch_.counts.reflected : ++batch_.counts.refracted;
    return true;
  }

 private:
  const Batch<R>& batch_;
  Level<R>& next_;
  RayState<R>* rays_;
  Inside* insides_;
};

template <class R>
void spawn_at(const Batch<R>& batch, std::size_t h, Spawner<R>& spawner, Level<R>& next) {
  const Terms& terms = batch.settings.terms;
  const TraceSettings& settings = batch.settings;
  const OpticalMaterial& material = batch.material(h);
  const RayState<R>& ray = batch.ray_of(h);
  HitState<R>& hit = batch.hits[h];
  hit.first_child = next.ray_count;
  hit.k1 = reflection_of(material, batch.row(h));
  hit.k2 = refraction_of(material, batch.row(h));
  V3<R> reflection = terms.reflection ? hit.k1 : V3<R>{};
  const V3<R> refraction = terms.refraction ? hit.k2 : V3<R>{};
  const V3<double> normal = batch.normal(h), view = batch.view(h);
  // A blended or bent normal may look past the viewer; that of refraction does not.
  const double seen = dot(view, normal), cosine = std::fabs(seen);
  const V3<double> turned = seen < 0 ? -normal : normal;
  hit.cosine = cosine;
  hit.ratio = hit.n1 = hit.n2 = 1;
  hit.refracts = !is_zero(refraction);
  const Wavelengths& waves = settings.wavelengths;
  const bool split =
      hit.refracts && ray.wavelength < 0 && material.is_dispersive() && waves.count > 1;
  hit.split = split;

  // The parts of the light that go in, each with its share.
  struct Part {
    Bend bend;
    V3<R> share;
    std::int32_t wavelength;
  };
  Part parts[kMaxWavelengths];
  int count = 0;
  if (hit.refracts) {
    const int ways = split ? waves.count : 1;
    for (int i = 0; i < ways; ++i) {
      const std::int32_t wavelength = split ? i : ray.wavelength;
      const Bend bend = bend_at(batch, h, cosine, wavelength < 0 ? 0.0 : waves.um[wavelength]);
      V3<R> share = refraction;
      if (split)
        share =
            share * V3<R>{static_cast<R>(waves.weight[i][0]), static_cast<R>(waves.weight[i][1]),
                          static_cast<R>(waves.weight[i][2])};
      if (i == ways / 2) {
        hit.ratio = bend.ratio, hit.quarter_d = bend.quarter_d, hit.fresnel = bend.fresnel;
        hit.n1 = bend.n1, hit.n2 = bend.n2;
        hit.total = bend.total();
      }
      const bool by_fresnel = material.fresnel != Fresnel::off;
      if (bend.total()) {
        if (settings.mirror_when_total || by_fresnel) reflection = reflection + share;
        continue;
      }
      if (by_fresnel) {
        const auto f = static_cast<R>(bend.fresnel);
        reflection = reflection + share * f;
        share = share * (R(1) - f);
      }
      parts[count++] = {bend, share, wavelength};
    }
  }
  // A stage without reflection has none that refraction brings, either.
  if (!terms.reflection && !settings.mirror_when_total) reflection = V3<R>{};
  hit.reflection = reflection;
  if (!is_zero(reflection))
    hit.reflected_cut = !spawner.add(h, RayKind::reflected, reflection,
                                     normal * (2 * seen) - view, ray.wavelength);
  hit.refraction = {};
  for (int i = 0; i < count; ++i) {
    const Part& part = parts[i];
    hit.refraction = hit.refraction + part.share;
    const double a = std::sqrt(part.bend.quarter_d) - part.bend.ratio * cosine;
    if (!is_zero(part.share) &&
        !spawner.add(h, RayKind::refracted, part.share, -(turned * a) - view * part.bend.ratio,
                     part.wavelength))
      hit.refracted_cut = true;
  }
}

}  // namespace

template <class R>
void spawn(const Batch<R>& batch, Level<R>& next, RayState<R>* next_rays, Inside* next_insides) {
  Spawner<R> spawner(batch, next, next_rays, next_insides);
  HitArrays<R>& hits = batch.level.hits;
  const bool names_children = batch.listens() || batch.scene.textures != nullptr;
  if (names_children) {
    std::fill_n(hits.reflected, batch.hit_count(), -1);
    std::fill_n(hits.refracted, batch.hit_count(), -1);
  }
  for (const std::int32_t parent : batch.columns.parents) {
    const auto h = static_cast<std::size_t>(parent);
    HitState<R>& hit = batch.hits[h];
    const OpticalMaterial& material = batch.material(h);
    if (!batch.listens() && is_zero(reflection_of(material, batch.row(h))) &&
        is_zero(refraction_of(material, batch.row(h))))
      continue;
    spawn_at(batch, h, spawner, next);
    if (!names_children) continue;
    for (std::int32_t c = hit.first_child; c < hit.first_child + hit.child_count; ++c)
      (next_rays[c].kind == RayKind::reflected ? hits.reflected : hits.refracted)[h] = c;
  }
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
