// SPDX-License-Identifier: Apache-2.0
// What is behind everything, and the fog before it.
#pragma once

#include <limits>

#include "engine/general/steps.hpp"
#include "math/elementary.hpp"
#include "textures/texture_set.hpp"

namespace zraka::general {

/// What a ray brings that hits nothing.
template <class R>
V3<R> sky_color(const FrozenScene<R>& scene, const V3<double>& direction) {
  const OpticalSky& sky = scene.optics->sky;
  if (sky.kind == Sky::Kind::gradient) {
    const double span = sky.high - sky.low, above = dot(direction, sky.up) - sky.low;
    const double height = span != 0 ? std::fmin(std::fmax(above / span, 0.0), 1.0) : 0.5;
    return narrowed<R>(sky.bottom * (1 - height) + sky.top * height);
  }
  if (sky.kind == Sky::Kind::image) {
    constexpr double kPi = 3.14159265358979323846;
    TexturePoint at;
    at.u = 0.5 + elementary::atan2(dot(direction, sky.right), dot(direction, sky.middle)) / (2 * kPi);
    at.v = 0.5 +
           elementary::asin(std::fmin(std::fmax(dot(direction, sky.up), -1.0), 1.0)) / kPi;
    at.v_ends = true;
    return narrowed<R>(scene.textures->set->value(sky.texture, at));
  }
  return scene.background;
}

/// How long a ray is for fog.
template <class R>
double length_in_fog(const Batch<R>& batch, std::size_t ray, double length) {
  const OpticalFog& fog = batch.optics().fog;
  if (!fog.planar || batch.rays[ray].kind != RayKind::camera) return length;
  return length *
         dot(three(batch.level.rays.dx, batch.level.rays.dy, batch.level.rays.dz, ray), fog.ahead);
}

/// What fog leaves of the colour of a ray that is so long; infinite: it hits nothing.
template <class R>
R clear_share_of(const Batch<R>& batch, std::size_t ray, double length) {
  const OpticalFog& fog = batch.optics().fog;
  if (fog.kind == Fog::Kind::none) return R(1);
  if (fog.planar && !(length < std::numeric_limits<double>::infinity())) return R(1);
  return static_cast<R>(clear_share(fog, length_in_fog(batch, ray, length)));
}

template <class R>
V3<R> through_fog(const OpticalFog& fog, R clear, const V3<R>& color) {
  return clear == R(1) ? color : color * clear + narrowed<R>(fog.color) * (R(1) - clear);
}

/// What rays bring that are too deep to be traced: the sky's colour.
template <class R>
void find_sky_beyond(const Batch<R>& batch) {
  const Terms& terms = batch.settings.terms;
  for (const std::int32_t parent : batch.columns.parents) {
    const auto h = static_cast<std::size_t>(parent);
    const OpticalMaterial& material = batch.material(h);
    const V3<double> normal = batch.normal(h), view = batch.view(h);
    HitState<R>& hit = batch.hits[h];
    if (terms.reflection)
      hit.beyond_reflected = reflection_of(material, batch.row(h)) *
                             sky_color(batch.scene, normal * (2 * dot(view, normal)) - view);
    if (terms.refraction)
      hit.beyond_refracted =
          refraction_of(material, batch.row(h)) * sky_color(batch.scene, -view);
  }
}

}  // namespace zraka::general
