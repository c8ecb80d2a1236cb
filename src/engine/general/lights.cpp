// SPDX-License-Identifier: Apache-2.0
// Local light of the general engine: lights of all kinds, soft and transparent shadows, ambient
// occlusion.
#include <algorithm>
#include <limits>

#include "engine/coefficients.hpp"
#include "engine/general/steps.hpp"
#include "math/elementary.hpp"
#include "sampling/hash.hpp"
#include "sampling/sobol.hpp"
#include "sampling/warp.hpp"

namespace zraka::general {
namespace {

/// As far as shadow rays of no end go.
constexpr double kFarthest = 0x1p100;

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

/// Two directions at right angles to a unit vector and to each other (Duff et al. 2017, "Building
/// an Orthonormal Basis, Revisited").
void basis_of(const V3<double>& n, V3<double>& a, V3<double>& b) {
  const double sign = std::copysign(1.0, n.z);
  const double p = -1 / (sign + n.z), q = n.x * n.y * p;
  a = {1 + sign * n.x * n.x * p, sign * q, -sign * n.x};
  b = {q, sign + n.y * n.y * p, -n.y};
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
    arrives.strength *= span > 0 ? smooth((cosine - light.cos_outer) / span)
                                 : (cosine >= light.cos_outer ? 1.0 : 0.0);
  }
  return arrives;
}

/// As many samples as a ray's weight in the pixel is worth: what counts little may be noisier.
template <class R>
std::int32_t samples_for(std::int32_t of_light, const RayState<R>& ray) {
  if (of_light == 1) return 1;
  const auto most = static_cast<double>(most_size(ray.weight));
  return std::clamp(static_cast<std::int32_t>(std::ceil(of_light * std::fmin(most, 1.0))), 1,
                    of_light);
}

template <class R>
bool may_be_passed(const Batch<R>& batch) {
  return batch.settings.transparent_shadows;
}

/// A shadow ray on its way through transparent bodies.
struct Walk {
  std::size_t entry;
  V3<double> origin, direction;
  double left, walked;  ///< how far to the light, and from the hit
  Inside inside;
  /// Bodies that have taken their share, and triangles that the ray is behind.
  std::vector<std::uint64_t> passed;
};

/// The last stretch, to the light itself, may be inside of what absorbs.
template <class R>
void finish(const Batch<R>& batch, const Walk& walk, V3<R>& filter) {
  if (!batch.optics().absorbing || !may_be_passed(batch) || !(walk.left < kFarthest / 2)) return;
  const OpticalMaterial* const materials = batch.optics().materials;
  const std::int32_t medium = medium_of(walk.inside, materials);
  if (medium < 0 || !materials[medium].absorbs()) return;
  const V3<R> left = narrowed<R>(transmittance_of(materials[medium].absorption, walk.left));
  filter = filter * left;
  if (batch.general.listener != nullptr)
    batch.general.listener->at_passed({batch.general.waiting[walk.entry].hit,
                                       batch.general.waiting[walk.entry].sample,
                                       -1,
                                       nullptr,
                                       walk.walked + walk.left,
                                       {R(1), R(1), R(1)},
                                       walk.left,
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
        if (batch.scene.textures != nullptr) level.rays.width[i] = level.rays.spread[i] = R(0);
      }
      level.ray_count = level.in_batch = static_cast<std::int32_t>(n);
      level.done = 0;
      batch.services.find_hits(batch.scene, level, scratch);
      take_coefficients(batch.scene, level, scratch);
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
        const V3<R> share = may_be_passed(batch) ? refraction_of(material, row) : V3<R>{};
        walk.walked += t;
        Passed<R> passed{general.waiting[walk.entry].hit,
                         general.waiting[walk.entry].sample,
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
            passed.length = t;
            passed.transmittance = narrowed<R>(transmittance_of(materials[medium].absorption, t));
            filter = filter * passed.transmittance;
          }
        }
        const bool known =
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
        if (leaves)
          walk.inside.leave(body);
        else if (encloses)
          walk.inside.enter({body, scratch.material[h]});
        const V3<double> normal = three(scratch.nx, scratch.ny, scratch.nz, h);
        walk.origin = three(scratch.px, scratch.py, scratch.pz, h) -
                      normal * static_cast<double>(scratch.offset[h]);
        walk.left -= t;
        going_on.push_back(std::move(walk));
      }
    }
    walks.swap(going_on);
  }
  // Nothing is known of what lies behind so many.
  for (const Walk& walk : walks) general.filter[walk.entry] = {R(0), R(0), R(0)};
}

/// Which of 96 parts of all directions one is in: sides of a cube, each of 4 by 4 squares.
template <class R>
std::size_t part_of(const V3<R>& d) {
  const R x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
  const auto fourth = [](R at, R most) {
    const auto q = static_cast<std::int32_t>((at / most + R(1)) * R(2));
    return static_cast<std::size_t>(std::clamp(q, 0, 3));
  };
  if (x >= y && x >= z) return (d.x < 0 ? 0 : 16) + 4 * fourth(d.y, x) + fourth(d.z, x);
  if (y >= z) return (d.y < 0 ? 32 : 48) + 4 * fourth(d.x, y) + fourth(d.z, y);
  return (d.z < 0 ? 64 : 80) + 4 * fourth(d.x, z) + fourth(d.y, z);
}

/// Rays that go the same way go together: they ask the same boxes. What comes of each is its own,
/// whatever the order.
template <class R>
void order_by_direction(GeneralWorkspace<R>& general) {
  const std::size_t n = general.waiting.size();
  std::int32_t start[97] = {};
  for (const Waiting<R>& one : general.waiting) ++start[part_of(one.direction) + 1];
  for (std::size_t p = 1; p < 97; ++p) start[p] += start[p - 1];
  general.order.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    general.order[static_cast<std::size_t>(start[part_of(general.waiting[i].direction)]++)] =
        static_cast<std::int32_t>(i);
}

/// Whether a shadow ray begins inside of what absorbs.
template <class R>
bool starts_in_absorber(const Batch<R>& batch, std::size_t entry) {
  if (!batch.optics().absorbing || !may_be_passed(batch)) return false;
  const auto hit = static_cast<std::size_t>(batch.general.waiting[entry].hit);
  const std::int32_t medium = medium_of(batch.ray_of(hit).inside, batch.optics().materials);
  return medium >= 0 && batch.optics().materials[medium].absorbs();
}

/// What shadows leave of all that wait: general.filter.
template <class R>
void trace_waiting(const Batch<R>& batch) {
  GeneralWorkspace<R>& general = batch.general;
  Scratch<R>& scratch = batch.scratch;
  const std::size_t n = general.waiting.size();
  general.filter.assign(n, V3<R>{R(1), R(1), R(1)});
  if (n == 0 || !batch.settings.terms.shadows) return;
  batch.counts.shadow += n;
  order_by_direction(general);
  for (std::size_t i = 0; i < n; ++i) {
    const Waiting<R>& one = general.waiting[static_cast<std::size_t>(general.order[i])];
    scratch.sox[i] = one.origin.x, scratch.soy[i] = one.origin.y, scratch.soz[i] = one.origin.z;
    scratch.sdx[i] = one.direction.x, scratch.sdy[i] = one.direction.y;
    scratch.sdz[i] = one.direction.z;
    scratch.sdistance[i] = one.distance;
  }
  batch.services.find_blocked(batch.scene, n, scratch);
  std::vector<Walk> walks;
  for (std::size_t i = 0; i < n; ++i) {
    const auto entry = static_cast<std::size_t>(general.order[i]);
    if (scratch.blocked[i] == 0 && !starts_in_absorber(batch, entry)) continue;
    if (!may_be_passed(batch)) {
      general.filter[entry] = {R(0), R(0), R(0)};
      // Whoever explains wants to know what the light is blocked by.
      if (general.listener == nullptr) continue;
    }
    const auto hit = static_cast<std::size_t>(general.waiting[entry].hit);
    Walk walk{entry,
              three(scratch.sox, scratch.soy, scratch.soz, i),
              three(scratch.sdx, scratch.sdy, scratch.sdz, i),
              static_cast<double>(scratch.sdistance[i]),
              0,
              {},
              {}};
    // On the side that the viewer sees.
    if (batch.optics().absorbing) walk.inside = batch.ray_of(hit).inside;
    walks.push_back(std::move(walk));
  }
  walk_through(batch, walks);
}

/// Where the shadow rays of a hit begin.
template <class R>
V3<R> shadow_origin(const Batch<R>& batch, std::size_t h) {
  return narrowed<R>(batch.point(h) + batch.smooth_normal(h) * batch.offset(h));
}

/// cosine^n; what is below 2^-40 is nothing: ln x ≤ x - 1.
double highlight_of(double cosine, double shininess) {
  if ((1 - cosine) * shininess > 27.73) return 0;
  return elementary::pow(std::fmin(cosine, 1.0), shininess);
}

/// R·V, or N·H.
template <class R>
double highlight_cosine(const Batch<R>& batch, std::size_t h, const V3<double>& to_light) {
  const V3<double> n = batch.normal(h), v = batch.view(h);
  if (batch.material(h).highlight == Highlight::phong)
    return dot(n * (2 * dot(n, to_light)) - to_light, v);
  const V3<double> half = to_light + v;
  const double length = std::sqrt(dot(half, half));
  return length > 0 ? dot(n, half) / length : 0;
}

/// Whether light from there adds anything, if it arrives: clear glass shines where it mirrors the
/// light, and nowhere else.
template <class R>
bool counts(const Batch<R>& batch, std::size_t h, const V3<double>& to_light, double l_n) {
  const R* const row = batch.row(h);
  const auto is_dark = [&](int column) {
    return row[column] == R(0) && row[column + 1] == R(0) && row[column + 2] == R(0);
  };
  if (batch.settings.terms.diffuse && !is_dark(kDiffuse) && l_n > 0) return true;
  if (!batch.settings.terms.specular || is_dark(kSpecular)) return false;
  // As it is computed later, from the direction in the engine's own numbers.
  const V3<R> own = narrowed<R>(to_light);
  const double cosine = highlight_cosine(
      batch, h,
      {static_cast<double>(own.x), static_cast<double>(own.y), static_cast<double>(own.z)});
  return cosine >= 0 && highlight_of(cosine, static_cast<double>(row[kShininess])) > 0;
}

/// Adds what has arrived of one light to the sums of its hits.
template <class R>
void settle_light(const Batch<R>& batch) {
  trace_waiting(batch);
  GeneralWorkspace<R>& general = batch.general;
  for (std::size_t i = 0; i < general.waiting.size(); ++i) {
    const Waiting<R>& one = general.waiting[i];
    const auto h = static_cast<std::size_t>(one.hit);
    LightSum<R>& sum = general.sums[h];
    const V3<R>& filter = general.filter[i];
    if (one.sample == 0) sum.filter = filter;
    if (is_zero(filter)) continue;
    ++sum.lit;
    const V3<R> radiance = one.radiance * filter;
    const R* const row = batch.row(h);
    if (batch.settings.terms.diffuse)
      sum.diffuse = sum.diffuse + radiance * V3<R>{row[kDiffuse], row[kDiffuse + 1], row[kDiffuse + 2]} *
                                      one.l_n;
    const V3<R> ks{row[kSpecular], row[kSpecular + 1], row[kSpecular + 2]};
    if (!batch.settings.terms.specular || is_zero(ks)) continue;
    const double cosine =
        highlight_cosine(batch, h,
                         {static_cast<double>(one.direction.x), static_cast<double>(one.direction.y),
                          static_cast<double>(one.direction.z)});
    if (!(cosine >= 0)) {
      if (one.sample == 0) sum.cosine = cosine;
      continue;
    }
    const double highlight = highlight_of(cosine, static_cast<double>(row[kShininess]));
    if (one.sample == 0) sum.cosine = cosine, sum.highlight = highlight;
    sum.specular = sum.specular + radiance * ks * static_cast<R>(highlight);
  }
  general.waiting.clear();
}

/// All samples of one light at all hits.
template <class R>
void add_light(const Batch<R>& batch, std::int32_t index) {
  const OpticalLight& light = batch.optics().lights[index];
  const V3<R>& color = batch.scene.lights[index].color;
  GeneralWorkspace<R>& general = batch.general;
  general.sums.assign(batch.hit_count(), LightSum<R>{});
  for (std::size_t h = 0; h < batch.hit_count(); ++h) {
    const RayState<R>& ray = batch.ray_of(h);
    const V3<double> point = batch.point(h), normal = batch.normal(h);
    const V3<R> origin = shadow_origin(batch, h);
    const bool is_surface = light.kind >= LightKind::rectangle;
    const Sobol2 points(
        is_surface ? hash(ray.key, static_cast<std::uint32_t>(index), 0x11u) : 0u);
    const std::int32_t samples = general.sums[h].samples = samples_for(light.samples, ray);
    for (std::int32_t s = 0; s < samples; ++s) {
      const Point2 at = is_surface
                            ? points[ray.sample * static_cast<std::uint32_t>(light.samples) +
                                     static_cast<std::uint32_t>(s)]
                            : Point2{0.5, 0.5};
      const Arriving arrives = arriving(light, point, at);
      const double l_n = dot(arrives.to_light, normal);
      const V3<R> radiance = color * static_cast<R>(arrives.strength);
      LightSum<R>& sum = general.sums[h];
      if (s == 0)
        sum.to_light = arrives.to_light, sum.distance = arrives.distance, sum.l_n = l_n,
        sum.radiance = radiance;
      if (!(l_n >= 0)) continue;
      ++sum.facing;
      if (is_zero(radiance)) continue;
      // Whoever explains wants to know of all of them.
      if (general.listener == nullptr && !counts(batch, h, arrives.to_light, l_n)) continue;
      general.waiting.push_back(
          {static_cast<std::int32_t>(h), s, origin, narrowed<R>(arrives.to_light),
           static_cast<R>(std::fmin(arrives.distance, kFarthest)), static_cast<R>(l_n), radiance});
      if (general.waiting.size() == general.shadow_room) settle_light(batch);
    }
  }
  settle_light(batch);
  for (std::size_t h = 0; h < batch.hit_count(); ++h) {
    LightSum<R>& sum = general.sums[h];
    const R mean = R(1) / static_cast<R>(sum.samples);
    if (sum.samples > 1) sum.diffuse = sum.diffuse * mean, sum.specular = sum.specular * mean;
    HitArrays<R>& hits = batch.level.hits;
    const V3<R> local = V3<R>{hits.r[h], hits.g[h], hits.b[h]} + sum.diffuse + sum.specular;
    hits.r[h] = local.x, hits.g[h] = local.y, hits.b[h] = local.z;
  }
  if (general.listener != nullptr)
    general.listener->at_light(index, batch.level, general.sums.data());
}

/// How much of the ambient light reaches each hit: general.occlusion.
template <class R>
void find_occlusion(const Batch<R>& batch) {
  const FrozenOptics& optics = batch.optics();
  GeneralWorkspace<R>& general = batch.general;
  general.occlusion.assign(batch.hit_count(), V3<R>{R(0), R(0), R(0)});
  general.samples.assign(batch.hit_count(), 1);
  Listener<R>* const listener = general.listener;
  general.listener = nullptr;  // too much to tell
  const auto distance = static_cast<R>(std::fmin(optics.occlusion_distance, kFarthest));
  const auto settle = [&] {
    trace_waiting(batch);
    for (std::size_t i = 0; i < general.waiting.size(); ++i) {
      V3<R>& sum = general.occlusion[static_cast<std::size_t>(general.waiting[i].hit)];
      sum = sum + general.filter[i];
    }
    general.waiting.clear();
  };
  for (std::size_t h = 0; h < batch.hit_count(); ++h) {
    const R* const row = batch.row(h);
    if (row[kAmbient] == R(0) && row[kAmbient + 1] == R(0) && row[kAmbient + 2] == R(0)) continue;
    const RayState<R>& ray = batch.ray_of(h);
    const Sobol2 points(hash(ray.key, 0xA0u));
    const std::int32_t samples = general.samples[h] = samples_for(optics.occlusion_samples, ray);
    V3<double> a{}, b{};
    const V3<double> normal = batch.smooth_normal(h);
    const V3<R> origin = shadow_origin(batch, h);
    basis_of(normal, a, b);
    for (std::int32_t s = 0; s < samples; ++s) {
      const auto number = ray.sample * static_cast<std::uint32_t>(optics.occlusion_samples) +
                          static_cast<std::uint32_t>(s);
      const DiscPoint on = quick_concentric_disc(points[number]);
      const double up = std::sqrt(std::fmax(1 - on.x * on.x - on.y * on.y, 0.0));
      const V3<double> way = unit(a * on.x + b * on.y + normal * up);
      general.waiting.push_back(
          {static_cast<std::int32_t>(h), s, origin, narrowed<R>(way), distance, R(0), V3<R>{}});
      if (general.waiting.size() == general.shadow_room) settle();
    }
  }
  settle();
  general.listener = listener;
  const V3<R> color = narrowed<R>(optics.occlusion_color);
  for (std::size_t h = 0; h < batch.hit_count(); ++h)
    general.occlusion[h] =
        general.occlusion[h] * (R(1) / static_cast<R>(general.samples[h])) * color;
}

}  // namespace

template <class R>
void light_hits(const Batch<R>& batch) {
  const Terms& terms = batch.settings.terms;
  GeneralWorkspace<R>& general = batch.general;
  const bool occluded = batch.optics().occlusion_samples > 0 && terms.ambient &&
                        terms.shadows && !terms.silhouette;
  general.waiting.clear();
  if (occluded) find_occlusion(batch);
  for (std::size_t h = 0; h < batch.hit_count(); ++h) {
    const R plain = terms.silhouette ? R(1) : R(0);
    V3<R> local{plain, plain, plain};
    if (terms.ambient && !terms.silhouette) {
      const R* const row = batch.row(h);
      local = batch.scene.ambient_light * V3<R>{row[kAmbient], row[kAmbient + 1], row[kAmbient + 2]};
      if (occluded)
        local = local * general.occlusion[h];
      else if (batch.optics().occlusion_samples > 0)
        local = local * narrowed<R>(batch.optics().occlusion_color);
    }
    HitArrays<R>& hits = batch.level.hits;
    hits.r[h] = local.x, hits.g[h] = local.y, hits.b[h] = local.z;
  }
  if (general.listener != nullptr)
    general.listener->at_hits(batch.level, batch.scratch, general,
                              occluded ? general.occlusion.data() : nullptr);
  if (terms.silhouette || !(terms.diffuse || terms.specular)) return;
  for (std::int32_t i = 0; i < batch.scene.light_count; ++i) add_light(batch, i);
}

#define ZRAKA_FOR(R) template void light_hits(const Batch<R>&);
ZRAKA_FOR(float)
ZRAKA_FOR(double)
#undef ZRAKA_FOR

}  // namespace zraka::general
