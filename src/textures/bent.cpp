// SPDX-License-Identifier: Apache-2.0
#include "textures/bent.hpp"

#include <algorithm>
#include <cmath>

#include "textures/perlin.hpp"

namespace zraka {
namespace {

/// The grain of the noise that bends, in sizes.
constexpr double kGrain = 2;
/// How many times longer it is along the axis of rings.
constexpr double kStretch = 4;

/// What a footprint sees more of where noise of about this slope bends layers.
double width_of_noise(const PreparedTexture& t, const TexturePlace& at) {
  return t.turbulence * greatest_width(at) / (kGrain * t.size);
}

}  // namespace

Bent layers_bent(const PreparedTexture& t, const TexturePlace& at) {
  Bent layer{dot(at.point, t.direction) / t.size, width_along(at, t.direction) / t.size};
  if (t.turbulence == 0) return layer;
  const double grain = kGrain * t.size;
  const Fractal fractal{t.octaves, t.seed};
  layer.at += t.turbulence * fractal.turbulence(at.point * (1 / grain), greatest_width(at) / grain);
  layer.width += width_of_noise(t, at);
  return layer;
}

Bent rings_bent(const PreparedTexture& t, const TexturePlace& at) {
  const double along = dot(at.point, t.direction);
  const V3<double> out = at.point - t.direction * along;
  const double radius = std::sqrt(dot(out, out));
  double width = greatest_width(at);
  if (radius > 0) {
    // Outwards, and as far as a ring curves away from a footprint that lies along it.
    const V3<double> outwards = out * (1 / radius);
    const double half = width_along(at, cross(t.direction, outwards)) / 2;
    width = width_along(at, outwards) + (std::sqrt(radius * radius + half * half) - radius);
  }
  // There are no rings on the other side of the axis.
  const double end = radius + width / 2, begin = std::max(radius - width / 2, 0.0);
  Bent ring{radius / t.size, width / t.size};
  if (begin == 0 && width > 0) ring = {end / 2 / t.size, end / t.size};
  if (t.turbulence == 0) return ring;
  const double grain = kGrain * t.size;
  const Fractal fractal{t.octaves, t.seed};
  const V3<double> stretched = out + t.direction * (along / kStretch);
  ring.at += t.turbulence * fractal(stretched * (1 / grain), greatest_width(at) / grain);
  ring.width += width_of_noise(t, at);
  return ring;
}

V3<double> finest_bent(const PreparedTexture& t) {
  const double grain = kGrain * t.size * finest_grain(t.octaves);
  const double step = (t.turbulence == 0 ? t.size : std::min(grain, t.size)) / 64;
  return {step, step, step};
}

}  // namespace zraka
