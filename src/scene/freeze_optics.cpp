// SPDX-License-Identifier: Apache-2.0
#include "scene/freeze_optics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/elementary.hpp"
#include "shapes/bodies/body.hpp"

namespace zraka {
namespace {

V3<double> vector_of(const Color& c) {
  return {c.r, c.g, c.b};
}
V3<double> unit(const V3<double>& v) {
  const double most = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  if (!(most > 0)) return {0, 0, 1};
  const V3<double> w = v * (1 / most);
  return w * (1 / std::sqrt(dot(w, w)));
}
double most_of(const V3<double>& v) {
  return std::max({v.x, v.y, v.z});
}

bool has_optics(const Material& m) {
  return !m.reflection.is_grey() || !m.refraction.is_grey() || m.fresnel != Fresnel::off ||
         m.absorption != Color{} || m.priority != 0 ||
         m.dispersion.kind != Dispersion::Kind::none;
}

/// In the engine's frame; its numbers, like those of points, may be beyond floats.
V3<double> in_frame(const Frame& frame, const Vec3& point) {
  constexpr double kFar = 0x1p+40;
  const V3<double> p = vector_of(frame.point(point));
  const double away = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  return away > kFar ? p * (kFar / away) : p;
}

OpticalMaterial freeze_material(const Material& m, const Frame& frame) {
  const auto textured = [&](Coefficient coefficient) {
    return std::any_of(m.textures.begin(), m.textures.end(),
                       [&](const TextureUse& use) { return use.coefficient == coefficient; });
  };
  const auto counts = [](const V3<double>& v) { return !(v.x == 0 && v.y == 0 && v.z == 0); };
  const V3<double> k1 = vector_of(m.reflection), k2 = vector_of(m.refraction);
  return {.k1 = k1,
          .k2 = k2,
          .absorption = vector_of(m.absorption) * frame.world_length(1),
          .ior = m.ior,
          .dispersion = m.dispersion,
          .highlight = m.highlight,
          .fresnel = m.fresnel,
          .priority = m.priority,
          .textured_k1 = textured(Coefficient::reflection),
          .textured_k2 = textured(Coefficient::refraction),
          .has_children = counts(k1) || counts(k2) || textured(Coefficient::reflection) ||
                          textured(Coefficient::refraction),
          .casts_shadow = m.casts_shadow,
          .cut_group = m.cut_group};
}

}  // namespace

OpticalLight freeze_light(const Light& light, const Frame& frame) {
  constexpr double kDegree = 3.14159265358979323846 / 180;
  const double world = frame.world_length(1);
  OpticalLight out{};
  out.kind = light.kind;
  out.position = in_frame(frame, light.position);
  out.direction = unit(vector_of(light.direction));
  out.constant = light.attenuation.x;
  out.linear = light.attenuation.y * world;
  out.quadratic = light.attenuation.z * world * world;
  out.cos_inner = elementary::cos(light.inner_deg * kDegree);
  out.cos_outer = elementary::cos(light.outer_deg * kDegree);
  out.inner = light.inner_deg * kDegree;
  out.outer = light.outer_deg * kDegree;
  out.linear_edge = light.linear_edge;
  if (light.kind == LightKind::rectangle) {
    out.edge_u = vector_of(frame.vector(light.edge_u));
    out.edge_v = vector_of(frame.vector(light.edge_v));
  }
  if (light.kind == LightKind::disc) {
    const V3<double> n = unit(vector_of(light.normal));
    const V3<double> other = std::fabs(n.x) < 0.5 ? V3<double>{1, 0, 0} : V3<double>{0, 1, 0};
    const V3<double> a = unit(cross(n, other));
    out.edge_u = a * frame.length(light.radius);
    out.edge_v = cross(n, a) * frame.length(light.radius);
  }
  out.radius = frame.length(light.radius);
  out.samples = light.is_surface() ? light.samples : 1;
  return out;
}

namespace {

OpticalCut freeze_cut(const Cut& cut, const Frame& frame) {
  const V3<double> normal = unit(vector_of(cut.normal));
  return {normal, dot(normal, in_frame(frame, cut.point)), cut.caps, cut.eye_only, cut.group};
}

OpticalSky freeze_sky(const Scene& scene) {
  const Sky& sky = scene.sky;
  OpticalSky out{};
  out.kind = sky.kind;
  out.bottom = vector_of(sky.bottom), out.top = vector_of(sky.top);
  out.up = unit(vector_of(sky.up));
  out.low = sky.low, out.high = sky.high;
  out.texture = sky.texture;
  // Its middle is towards -z, or whatever of that is level.
  V3<double> middle{0, 0, -1};
  middle = middle - out.up * dot(middle, out.up);
  if (dot(middle, middle) < 1e-12) middle = {0, 1, 0};
  out.middle = unit(middle - out.up * dot(middle, out.up));
  out.right = cross(out.middle, out.up);
  return out;
}

}  // namespace

OpticalFog freeze_fog(const Scene& scene, const Frame& frame) {
  const Fog& fog = scene.fog;
  OpticalFog out{};
  out.kind = fog.kind;
  out.start = frame.length(fog.start), out.end = frame.length(fog.end);
  out.density = fog.density * frame.world_length(1);
  out.color = vector_of(fog.color);
  out.planar = fog.planar;
  const Camera& camera = scene.camera;
  out.ahead =
      unit(V3<double>{camera.window_center.x - camera.eye.x, camera.window_center.y - camera.eye.y,
                      camera.window_center.z - camera.eye.z});
  return out;
}

namespace {

double most_of_image(const Texture& texture) {
  double most = 1;
  if (texture.image)
    for (const float v : texture.image->pixels)
      if (std::isfinite(v)) most = std::max(most, static_cast<double>(v));
  return most;
}

/// Where there is nothing of one, there is nothing of both, however much the other is.
V3<double> product(const V3<double>& a, const V3<double>& b) {
  const auto times = [](double x, double y) { return x == 0 || y == 0 ? 0.0 : x * y; };
  return {times(a.x, b.x), times(a.y, b.y), times(a.z, b.z)};
}

/// What bounds the radiance of rays.
void find_bounds(const Scene& scene, FrozenOptics& out) {
  const auto plus = [](const V3<double>& a, const V3<double>& b) { return a + b; };
  V3<double> light{0, 0, 0};
  for (const Light& each : scene.lights) {
    // A light without a constant term is as bright as one likes close by.
    const double strongest = each.kind == LightKind::directional ? 1
                             : each.attenuation.x > 0            ? 1 / each.attenuation.x
                                                      : std::numeric_limits<double>::infinity();
    light = plus(light, product(vector_of(each.color), {strongest, strongest, strongest}));
  }
  const double most_occluded =
      scene.ambient_occlusion.samples > 0
          ? std::max(1.0, most_of(vector_of(scene.ambient_occlusion.color)))
          : 1;
  double most_texture = 1;
  for (const Texture& texture : scene.textures) {
    for (const Color& c : texture.colors)
      most_texture = std::max(most_texture, most_of(vector_of(c)));
    most_texture = std::max(most_texture, most_of_image(texture));
  }
  for (const Material& m : scene.materials) {
    const auto coefficient = [&](Coefficient which, const Color& plain) {
      for (const TextureUse& use : m.textures)
        if (use.coefficient == which) return V3<double>{most_texture, most_texture, most_texture};
      return vector_of(plain);
    };
    const V3<double> local = product(vector_of(scene.ambient_light) * most_occluded,
                                     coefficient(Coefficient::ambient, m.ambient)) +
                             product(light, coefficient(Coefficient::diffuse, m.diffuse) +
                                                coefficient(Coefficient::specular, m.specular));
    out.most_local = std::max(out.most_local, most_of(local));
    out.most_shares =
        std::max(out.most_shares, most_of(coefficient(Coefficient::reflection, m.reflection) +
                                          coefficient(Coefficient::refraction, m.refraction)));
  }
  out.most_sky = most_of(vector_of(scene.background));
  if (scene.sky.kind == Sky::Kind::gradient)
    out.most_sky = std::max(most_of(out.sky.bottom), most_of(out.sky.top));
  if (scene.sky.kind == Sky::Kind::image && scene.sky.texture < scene.textures.size())
    out.most_sky = most_of_image(scene.textures[scene.sky.texture]);
  if (scene.fog.kind != Fog::Kind::none) {
    // Light through fog is between the two.
    out.most_sky = std::max(out.most_sky, most_of(out.fog.color));
    out.most_local = std::max(out.most_local, most_of(out.fog.color));
  }
}

/// Whether any part of a whole, or a whole, throws no shadow: of those the lean engine knows not.
bool has_shadowless_wholes(const Scene& scene) {
  const auto shadowless = [&](std::uint32_t material) {
    return material < scene.materials.size() && !scene.materials[material].casts_shadow;
  };
  const auto any_in = [&](const auto& shapes) {
    return std::any_of(shapes.begin(), shapes.end(),
                       [&](const auto& shape) { return shadowless(shape.material); });
  };
  const auto any_in_group = [&](const Group& group) {
#define ZRAKA_ANY(Type, plural) any_in(group.plural) ||
    return ZRAKA_SHAPES(ZRAKA_ANY) false;
#undef ZRAKA_ANY
  };
  return any_in(scene.instances) || any_in(scene.csgs) ||
         std::any_of(scene.csgs.begin(), scene.csgs.end(),
                     [&](const auto& csg) { return any_in(csg.shape.of); }) ||
         std::any_of(scene.groups.begin(), scene.groups.end(), any_in_group);
}

}  // namespace

bool has_shadowless(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& m) { return !m.casts_shadow; });
}

bool has_optics(const Scene& scene) {
  return scene.ambient_occlusion.samples > 0 || scene.sky.kind != Sky::Kind::flat ||
         scene.fog.kind != Fog::Kind::none || !scene.cuts.empty() ||
         std::any_of(scene.lights.begin(), scene.lights.end(),
                     [](const Light& light) { return light.is_surface(); }) ||
         std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& m) { return has_optics(m); }) ||
         (has_shadowless(scene) && has_shadowless_wholes(scene));
}

std::unique_ptr<StoredOptics> freeze_optics(const Scene& scene, const Profile& profile,
                                            const Frame& frame) {
  auto stored = std::make_unique<StoredOptics>();
  FrozenOptics& out = stored->frozen;
  for (const Material& m : scene.materials) {
    stored->materials.push_back(freeze_material(m, frame));
    out.nested = out.nested || m.priority != 0;
    out.absorbing = out.absorbing || m.absorption != Color{};
    out.dispersive = out.dispersive || m.dispersion.kind != Dispersion::Kind::none;
    out.shadowless = out.shadowless || !m.casts_shadow;
    out.transparent = out.transparent || stored->materials.back().textured_k2 ||
                      m.refraction != Share{};
    out.textured_passing = out.textured_passing || stored->materials.back().textured_k2 ||
                           m.normals.kind != NormalUse::Kind::none;
  }
  for (const Light& light : scene.lights) stored->lights.push_back(freeze_light(light, frame));
  for (const Cut& cut : scene.cuts) {
    stored->cuts.push_back(freeze_cut(cut, frame));
    out.has_caps = out.has_caps || cut.caps;
  }
  out.cuts = stored->cuts.data();
  out.cut_count = static_cast<int>(stored->cuts.size());
  out.materials = stored->materials.data();
  out.lights = stored->lights.data();
  out.sky = freeze_sky(scene);
  out.fog = freeze_fog(scene, frame);
  out.occlusion_samples = scene.ambient_occlusion.samples;
  out.occlusion_distance = scene.ambient_occlusion.distance > 0
                               ? frame.length(scene.ambient_occlusion.distance)
                               : std::numeric_limits<double>::infinity();
  out.occlusion_color = vector_of(scene.ambient_occlusion.color);
  out.index_is_ratio = profile.index_is_ratio;
  find_bounds(scene, out);
  return stored;
}

}  // namespace zraka
