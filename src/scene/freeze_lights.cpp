// SPDX-License-Identifier: Apache-2.0
#include "scene/freeze_lights.hpp"

#include <algorithm>
#include <cmath>

#include "math/elementary.hpp"
#include "scene/freeze_optics.hpp"
#include "scene/narrow.hpp"
#include "scene/reals.hpp"

namespace zraka {
namespace {

/// So far away that the direction there is the same all over the scene.
constexpr double kFarAwayLight = 0x1p+40;

/// A light from farther than that: nearer, where squares stay finite.
Vec3 brought_near(const Vec3& light) {
  const double away = std::max({std::fabs(light.x), std::fabs(light.y), std::fabs(light.z)});
  return away > kFarAwayLight ? Vec3{light.x / away * kFarAwayLight, light.y / away * kFarAwayLight,
                                     light.z / away * kFarAwayLight}
                              : light;
}

/// Where a light stands in the engine's frame, a directional one far away.
Vec3 place_of(const Light& light, const Frame& frame) {
  if (light.kind != LightKind::directional) return brought_near(frame.point(light.position));
  const Vec3& d = light.direction;
  const double most = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
  const Vec3 way{-d.x / most, -d.y / most, -d.z / most};
  const double far = kFarAwayLight / std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
  return {way.x * far, way.y * far, way.z * far};
}

template <class R>
FrozenFading<R> freeze_fading(const OpticalLight& light) {
  FrozenFading<R> out{};
  out.any = true;
  out.constant = narrow<R>(light.constant);
  out.linear = narrow<R>(light.linear);
  out.quadratic = narrow<R>(light.quadratic);
  out.has_cone = light.kind == LightKind::spot;
  if (!out.has_cone) return out;
  const V3<double>& axis = light.direction;
  out.axis = {narrow<R>(axis.x), narrow<R>(axis.y), narrow<R>(axis.z)};
  const auto chord_square = [](double angle) {
    const double half = 2 * elementary::sin(angle / 2);
    return half * half;
  };
  const double inner = chord_square(light.inner), outer = chord_square(light.outer);
  out.inner_square = narrow<R>(inner), out.outer_square = narrow<R>(outer);
  out.linear_edge = light.linear_edge_counts();
  out.outer = narrow<R>(light.outer);
  out.slope = narrow<R>(1 / (out.linear_edge ? light.outer - light.inner : outer - inner));
  return out;
}

}  // namespace

bool fades(const Light& light) {
  return light.kind == LightKind::spot ||
         (light.kind == LightKind::point && light.attenuation != Vec3{1, 0, 0});
}

template <class R>
FrozenLight<R> freeze_lean_light(const Light& light, const Frame& frame) {
  return {narrow<R>(place_of(light, frame)), narrow<R>(light.color),
          fades(light) ? freeze_fading<R>(freeze_light(light, frame)) : FrozenFading<R>{}};
}

#define ZRAKA_FOR(R) template FrozenLight<R> freeze_lean_light<R>(const Light&, const Frame&);
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka
