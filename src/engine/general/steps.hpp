// SPDX-License-Identifier: Apache-2.0
// The steps of the general engine, and what they share.
#pragma once

#include <cmath>

#include "engine/general/general.hpp"

namespace zraka::general {

template <class R>
V3<double> three(const R* x, const R* y, const R* z, std::size_t i) {
  return {static_cast<double>(x[i]), static_cast<double>(y[i]), static_cast<double>(z[i])};
}
template <class R>
V3<R> narrowed(const V3<double>& v) {
  return {static_cast<R>(v.x), static_cast<R>(v.y), static_cast<R>(v.z)};
}
template <class T>
bool is_zero(const V3<T>& v) {
  return v.x == T(0) && v.y == T(0) && v.z == T(0);
}
template <class T>
T most_of(const V3<T>& v) {
  const T more = v.x > v.y ? v.x : v.y;
  return more > v.z ? more : v.z;
}
/// The same of the magnitudes: parts of split light may be below 0.
template <class T>
T most_size(const V3<T>& v) {
  return most_of(V3<T>{std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}
inline V3<double> unit(const V3<double>& v) {
  return v * (1 / std::sqrt(dot(v, v)));
}

/// A tile's batch: what every step takes.
template <class R>
struct Batch {
  const FrozenScene<R>& scene;
  const TraceSettings& settings;
  const Services<R>& services;
  Level<R>& level;
  Scratch<R>& scratch;
  GeneralWorkspace<R>& general;
  RayCounts& counts;
  RayState<R>* rays;  ///< of the level
  HitState<R>* hits;
  FoldColumns<R>& columns;
  Inside* insides;  ///< of the rays; nullptr where there are no media

  const FrozenOptics& optics() const { return *scene.optics; }
  std::size_t hit_count() const { return static_cast<std::size_t>(level.hit_count); }
  RayState<R>& ray_of(std::size_t h) const { return rays[level.done + level.hits.ray[h]]; }
  Inside& inside_of(std::size_t h) const { return insides[level.done + level.hits.ray[h]]; }
  bool has_media() const { return insides != nullptr; }
  bool listens() const { return general.listener != nullptr; }
  /// HitState::cap.
  std::int32_t cap_of(std::size_t h) const { return general.caps.empty() ? -1 : general.caps[h]; }
  V3<R> transmittance_of(std::size_t h) const {
    const auto& t = columns.transmittance;
    return {t[0][h], t[1][h], t[2][h]};
  }
  const R* row(std::size_t h) const {
    return scratch.coefficients + std::ptrdiff_t{scratch.row[h]} * kMaterialReals;
  }
  const OpticalMaterial& material(std::size_t h) const {
    return optics().materials[scratch.material[h]];
  }
  V3<double> point(std::size_t h) const { return three(scratch.px, scratch.py, scratch.pz, h); }
  V3<double> normal(std::size_t h) const { return three(scratch.nx, scratch.ny, scratch.nz, h); }
  V3<double> view(std::size_t h) const { return three(scratch.vx, scratch.vy, scratch.vz, h); }
  /// Whether a texture bends its normal.
  bool is_bent(std::size_t h) const {
    return scene.textures != nullptr && scratch.smooth_x != nullptr &&
           scene.textures->of_material[scratch.material[h]].normals.kind != NormalUse::Kind::none;
  }
  /// The normal before a texture bends it, on the viewer's side: rays leave the surface along it.
  V3<double> smooth_normal(std::size_t h) const {
    if (!is_bent(h)) return normal(h);
    return three(scratch.smooth_x, scratch.smooth_y, scratch.smooth_z, h);
  }
  double offset(std::size_t h) const { return static_cast<double>(scratch.offset[h]); }
  bool from_inside(std::size_t h) const { return scratch.inside[h] > R(0); }
};

/// In place of a way to a hit that has not been written, where there are no groups: all that what
/// follows asks of it.
inline void start_path(std::int32_t slot, HitPath& path) {
  path.group = nullptr;
  path.slot = slot;
  path.depth = 0;
}

/// Which body a hit belongs to: a shape of the scene; of a group where it stands; all triangles of
/// one material in a group, which are one mesh.
template <class R>
std::uint64_t body_of(const FrozenScene<R>& scene, const HitPath& path, std::int32_t material);

/// Whether what has been hit has an inside that rays can be in: closed bodies, half-spaces, and
/// triangles of a group, which are a mesh. Sheets have none, and loose triangles are sheets.
template <class R>
bool has_inside(const FrozenScene<R>& scene, const HitPath& path);

/// Triangles that are no part of a group, which may be sheets or make a body together.
template <class R>
bool is_loose_triangle(const FrozenScene<R>& scene, const HitPath& path);

/// The material whose inside counts: that of the highest priority, of equal ones the last entered;
/// -1: none.
std::int32_t medium_of(const Inside& inside, const OpticalMaterial* materials);

/// exp(-a·d) for each channel.
V3<double> transmittance_of(const V3<double>& absorption, double distance);

/// What fog leaves of light after a length; 1 without fog.
double clear_share(const OpticalFog& fog, double length);
/// Where that is e to the power of something, what that is.
double fog_exponent(const OpticalFog& fog, double length);
inline bool has_exponent(const OpticalFog& fog) {
  return fog.kind == Fog::Kind::exponential || fog.kind == Fog::Kind::squared;
}

/// What is left of light on the ways to all hits, through what rays are inside of.
template <class R>
void pass_media(const Batch<R>& batch);
/// What fog leaves of the colours of all hits.
template <class R>
void pass_fog(const Batch<R>& batch);

/// k2 of a hit: the texture's, or the material's.
template <class R>
V3<R> refraction_of(const OpticalMaterial& material, const R* row) {
  if (material.textured_k2) return {row[kRefraction], row[kRefraction], row[kRefraction]};
  return narrowed<R>(material.k2);
}
template <class R>
V3<R> reflection_of(const OpticalMaterial& material, const R* row) {
  if (material.textured_k1) return {row[kReflection], row[kReflection], row[kReflection]};
  return narrowed<R>(material.k1);
}

/// Whether something goes in where a ray hits the material.
inline bool lets_in(const OpticalMaterial& material) {
  return !is_zero(material.k2) || material.textured_k2;
}

/// I = ambient + each light's terms: level.hits.r, g and b.
template <class R>
void light_hits(const Batch<R>& batch);

/// Children of the hits that may have some, into the next level.
template <class R>
void spawn(const Batch<R>& batch, Level<R>& next, RayState<R>* next_rays, Inside* next_insides);

}  // namespace zraka::general
