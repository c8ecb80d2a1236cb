// SPDX-License-Identifier: Apache-2.0
// What rays are inside of, and what that and fog leave of light.
#include <algorithm>

#include "engine/general/sky.hpp"
#include "math/elementary.hpp"
#include "scene/reals.hpp"

namespace zraka::general {
namespace {

bool holds(const auto& shapes, std::int32_t slot) {
  return slot >= shapes.first_slot && slot < shapes.first_slot + shapes.count;
}

/// The scene, or the group that a shape stands in.
template <class R>
const FrozenScene<R>& home_of(const FrozenScene<R>& scene, const HitPath& path) {
  return path.group == nullptr ? scene : *static_cast<const FrozenScene<R>*>(path.group);
}

}  // namespace

template <class R>
bool is_loose_triangle(const FrozenScene<R>& scene, const HitPath& path) {
  const auto is_in = [&](const auto& shapes) { return holds(shapes, path.slot); };
  return path.depth == 0 && (is_in(scene.triangles) || is_in(scene.smooth_triangles));
}

template <class R>
bool has_inside(const FrozenScene<R>& scene, const HitPath& path) {
  const FrozenScene<R>& home = home_of(scene, path);
  const auto is_in = [&](const auto& shapes) { return holds(shapes, path.slot); };
  if (is_in(home.spheres) || is_in(home.anchored_spheres)) return true;
  if (is_in(home.triangles) || is_in(home.smooth_triangles)) return path.depth > 0;
  if (!is_in(home.bodies)) return false;  // sides of cones and cylinders
  const std::int32_t body = path.slot - home.bodies.first_slot;
  switch (home.bodies.type[body]) {
    case kTypeParallelogram:
    case kTypeDisc:
      return false;
    case kTypeFrustum:  // its last number says whether it has caps
      return home.bodies.numbers[home.bodies.start[body] + kBodyNumbers + 2] > 0;
    default:
      return true;
  }
}

template <class R>
std::uint64_t body_of(const FrozenScene<R>& scene, const HitPath& path, std::int32_t material) {
  std::uint64_t key = 0;
  const auto mix = [&](std::int32_t more) {
    key = (key ^ static_cast<std::uint32_t>(more)) * 0x9E3779B97F4A7C15u;
    key ^= key >> 29;
  };
  for (std::int32_t i = 0; i < path.depth; ++i) mix(path.instance[i] + 1);
  const FrozenScene<R>& home = home_of(scene, path);
  const auto is_in = [&](const auto& shapes) { return holds(shapes, path.slot); };
  if (is_in(home.triangles) || is_in(home.smooth_triangles))
    mix(-2 - material);
  else
    mix(path.slot + 1);
  return key;
}

std::int32_t medium_of(const Inside& inside, const OpticalMaterial* materials) {
  std::int32_t best = -1;
  for (std::int32_t i = 0; i < inside.count; ++i) {
    const std::int32_t material = inside.list[i].material;
    if (best < 0 || materials[material].priority >= materials[best].priority) best = material;
  }
  return best;
}

V3<double> transmittance_of(const V3<double>& absorption, double distance) {
  const auto left = [&](double a) { return a > 0 ? elementary::exp(-a * distance) : 1.0; };
  return {left(absorption.x), left(absorption.y), left(absorption.z)};
}

namespace {

/// What the ray of a hit comes through: a material; -1: nothing.
template <class R>
std::int32_t medium_at(const Batch<R>& batch, std::size_t h) {
  Inside& inside = batch.inside_of(h);
  // What a ray leaves it has been inside of, whether or not it is known how it came in.
  if (batch.from_inside(h) && lets_in(batch.material(h)) &&
      has_inside(batch.scene, batch.scratch.paths[h])) {
    const std::int32_t material = batch.scratch.material[h];
    inside.enter({body_of(batch.scene, batch.scratch.paths[h], material), material});
  }
  return medium_of(inside, batch.optics().materials);
}

/// e to the powers of the first n of general.exponents: general.powers.
template <class R>
void find_powers(const Batch<R>& batch, std::size_t n) {
  const std::vector<double>& exponents = batch.general.exponents;
  std::vector<double>& powers = batch.general.powers;
  if (!batch.services.hits->find_exponentials(n, exponents.data(), powers.data())) return;
  for (std::size_t i = 0; i < n; ++i)
    if (powers[i] < 0) powers[i] = elementary::exp(exponents[i]);
}

/// How long the ray of a hit is.
template <class R>
double length_at(const Batch<R>& batch, std::size_t h) {
  return static_cast<double>(batch.scratch.t[batch.level.hits.ray[h]]);
}

}  // namespace

template <class R>
void pass_media(const Batch<R>& batch) {
  const OpticalMaterial* const materials = batch.optics().materials;
  GeneralWorkspace<R>& general = batch.general;
  auto& t = batch.columns.transmittance;
  for (std::vector<R>& channel : t) std::fill_n(channel.begin(), batch.hit_count(), R(1));
  general.absorbed.clear();
  double* exponent = general.exponents.data();
  for (std::size_t h = 0; h < batch.hit_count(); ++h) {
    const std::int32_t medium = medium_at(batch, h);
    if (batch.listens()) batch.hits[h].medium = medium;
    const bool absorbs = medium >= 0 && materials[medium].absorbs();
    general.in_absorber[h] = absorbs ? 1 : 0;
    if (!absorbs) continue;
    general.absorbed.push_back(static_cast<std::int32_t>(h));
    const V3<double>& absorption = materials[medium].absorption;
    const double length = length_at(batch, h);
    for (const double a : {absorption.x, absorption.y, absorption.z})
      *exponent++ = a > 0 ? -a * length : 0;  // e to that is 1
  }
  find_powers(batch, 3 * general.absorbed.size());
  const double* power = general.powers.data();
  for (const std::int32_t h : general.absorbed)
    for (std::vector<R>& channel : t)
      channel[static_cast<std::size_t>(h)] = static_cast<R>(*power++);
  for (std::size_t h = 0; h < batch.hit_count() && batch.listens(); ++h)
    batch.hits[h].transmittance = batch.transmittance_of(h);
}

template <class R>
void pass_fog(const Batch<R>& batch) {
  const OpticalFog& fog = batch.optics().fog;
  std::vector<R>& clear = batch.columns.clear;
  const auto ray_of = [&](std::size_t h) {
    return static_cast<std::size_t>(batch.level.done + batch.level.hits.ray[h]);
  };
  if (has_exponent(fog)) {
    for (std::size_t h = 0; h < batch.hit_count(); ++h)
      batch.general.exponents[h] =
          fog_exponent(fog, length_in_fog(batch, ray_of(h), length_at(batch, h)));
    find_powers(batch, batch.hit_count());
  }
  for (std::size_t h = 0; h < batch.hit_count(); ++h) {
    clear[h] = has_exponent(fog)
                   ? static_cast<R>(std::fmin(std::fmax(batch.general.powers[h], 0.0), 1.0))
                   : clear_share_of(batch, ray_of(h), length_at(batch, h));
    if (batch.listens()) batch.hits[h].clear = clear[h];
  }
}

#define ZRAKA_FOR(R)                                                                   \
  template bool is_loose_triangle(const FrozenScene<R>&, const HitPath&);              \
  template bool has_inside(const FrozenScene<R>&, const HitPath&);                     \
  template std::uint64_t body_of(const FrozenScene<R>&, const HitPath&, std::int32_t); \
  template void pass_media(const Batch<R>&);                                           \
  template void pass_fog(const Batch<R>&);
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka::general
