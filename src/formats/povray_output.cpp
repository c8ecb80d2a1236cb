// SPDX-License-Identifier: Apache-2.0
// The frame of POV-Ray's scenes: settings, camera, surroundings and lights. The camera's vectors
// say where pixels' rays go, whatever the hand, so all stays where it is.
#include "formats/povray_output.hpp"

#include <algorithm>
#include <cmath>
#include <zraka/render.hpp>

#include "formats/plain_material.hpp"
#include "formats/vectors.hpp"

namespace zraka {
namespace {

/// What the sky is like at a height between straight down, 0, and straight up, 1.
double height_of(double sine) {
  return std::clamp((sine + 1) / 2, 0.0, 1.0);
}

}  // namespace

void PovrayWriter::write_settings() {
  constexpr int kMostLevels = 256;
  const RenderDefaults& defaults = scene_.defaults;
  put("#version 3.7;\n// {}x{}: povray +W{} +H{}\n", scene_.resolution.width,
      scene_.resolution.height, scene_.resolution.width, scene_.resolution.height);
  put("global_settings {{ assumed_gamma 1 max_trace_level {} adc_bailout {} ambient_light {} }}\n",
      std::clamp(defaults.max_depth + 1, 1, kMostLevels), defaults.min_contribution,
      words(scene_.ambient_light));
}

void PovrayWriter::write_camera() {
  const Camera c = with_central_rays(scene_);
  const Vec3 to_window = c.window_center - c.eye;
  const double aspect = static_cast<double>(scene_.resolution.width) / scene_.resolution.height;
  const double handedness = dot(cross(c.window_right, c.window_up), to_window) < 0 ? -1 : 1;
  std::string kind = "perspective";
  Vec3 right = c.window_right, up = c.window_up;
  switch (c.kind) {
    case CameraKind::pinhole:
      break;
    case CameraKind::orthographic:
      kind = "orthographic";
      break;
    case CameraKind::fisheye:
      kind = fmt::format("fisheye angle {}", std::min(c.fov_deg, 360.0));
      right = unit(right) * aspect, up = unit(up);
      losses_.count("the corners of the fisheye's picture, which stay dark", 1);
      break;
    case CameraKind::panorama:
      kind = fmt::format("spherical angle {} {}", c.longitude_deg, c.latitude_deg);
      losses_.count("how far up the panorama's middle is", c.latitude_middle_deg != 0);
      // It turns the view as in a left-handed space.
      right = unit(right) * handedness, up = unit(up) * handedness;
      break;
  }
  put("camera {{ {} location {} direction {} right {} up {}", kind, words(c.eye), words(to_window),
      words(right), words(up));
  if (c.kind == CameraKind::pinhole && c.aperture > 0) {
    const Vec3 facing = unit(cross(c.window_right, c.window_up));
    const double way = dot(facing, to_window) < 0 ? -1 : 1;
    put(" aperture {} focal_point {} blur_samples {} confidence 0.99 variance 0", c.aperture,
        words(c.eye + facing * (c.focus_distance * way)),
        std::max(scene_.defaults.sampling.count, 4));
  }
  put(" }}\n");
}

void PovrayWriter::write_surroundings() {
  losses_.count("cuts", scene_.cuts.size());
  const Sky& sky = scene_.sky;
  const Color background =
      sky.kind == Sky::Kind::image ? mean_of(scene_.textures[sky.texture]) : scene_.background;
  put("background {{ {} }}\n", words(background));
  losses_.count("the sky's picture", sky.kind == Sky::Kind::image);
  losses_.count("ambient occlusion", scene_.ambient_occlusion.samples > 0);
  // A little more than from one pole to the other, for a gradient begins anew at its end.
  if (sky.kind == Sky::Kind::gradient) {
    const bool rises = sky.low < sky.high;
    put("sky_sphere {{ pigment {{ gradient {} color_map {{ [{} {}] [{} {}] }} scale 2.0002 "
        "translate {} }} }}\n",
        words(unit(sky.up)), height_of(std::min(sky.low, sky.high)),
        words(rises ? sky.bottom : sky.top), height_of(std::max(sky.low, sky.high)),
        words(rises ? sky.top : sky.bottom), words(unit(sky.up) * -1.0001));
  }
  const Fog& fog = scene_.fog;
  const bool is_plain = fog.kind == Fog::Kind::exponential && fog.start == 0 && !fog.planar;
  if (is_plain && fog.density > 0)
    put("fog {{ fog_type 1 distance {} {} }}\n", 1 / fog.density, words(fog.color));
  losses_.count("fog", fog.kind != Fog::Kind::none && !is_plain);
}

/// POV-Ray's light at the distance d is 2/(1 + (d/fade_distance)^fade_power) of its colour.
void PovrayWriter::write_fading(const Light& light, Color& color) {
  const Vec3& a = light.attenuation;
  const bool is_linear = a.y > 0 && a.z == 0, is_square = a.z > 0 && a.y == 0;
  if (a.y == 0 && a.z == 0) {
    if (a.x > 0) color = color * (1 / a.x);
    return;
  }
  if (!is_linear && !is_square) {
    losses_.count("lights: attenuation", 1);
    return;
  }
  // Without a constant it begins to fade so near that it makes no difference.
  constexpr double kNear = 1e-4;
  const double power = is_square ? 2 : 1, slope = is_square ? a.z : a.y;
  const double constant = a.x > 0 ? a.x : slope * std::pow(kNear, power);
  color = color * (1 / (2 * constant));
  put("fade_power {} fade_distance {} ", power,
      is_square ? std::sqrt(constant / slope) : constant / slope);
}

void PovrayWriter::write_light(const Light& light) {
  const bool is_directional = light.kind == LightKind::directional;
  // Far enough that it makes no difference to a byte.
  constexpr double kSunDistance = 1e6;
  Vec3 from = is_directional ? unit(light.direction) * -kSunDistance : light.position;
  if (light.kind == LightKind::rectangle) from = from + (light.edge_u + light.edge_v) * 0.5;
  Color color = light.color;
  std::string own;
  std::swap(own, text_);
  if (!is_directional) write_fading(light, color);
  if (is_directional) put("parallel point_at <0,0,0> ");
  if (light.kind == LightKind::spot) {
    put("spotlight radius {} falloff {} tightness 0 point_at {} ", light.inner_deg, light.outer_deg,
        words(light.position + light.direction));
    losses_.count("lights: the linear edge of spots", light.linear_edge);
  }
  if (light.is_surface()) {
    Vec3 u = light.edge_u, v = light.edge_v;
    if (light.kind != LightKind::rectangle) {
      const Vec3 axis = light.kind == LightKind::disc ? light.normal : Vec3{0, 1, 0};
      u = any_across(axis) * (2 * light.radius);
      v = unit(cross(axis, u)) * (2 * light.radius);
    }
    const int side = std::max(2, static_cast<int>(std::lround(std::sqrt(light.samples))));
    put("area_light {}, {}, {}, {} {}", words(u), words(v), side, side,
        light.kind == LightKind::rectangle ? ""
        : light.kind == LightKind::disc    ? "circular "
                                           : "circular orient ");
  }
  if (scene_.defaults.shadows == Shadows::off) put("shadowless ");
  std::swap(own, text_);
  put("light_source {{ {}, {} {}}}\n", words(from), words(color), own);
}

Result<WrittenScene> PovrayWriter::write() {
  write_settings();
  write_camera();
  write_surroundings();
  for (const Light& light : scene_.lights) write_light(light);
  for (std::uint32_t i = 0; i < scene_.materials.size(); ++i)
    if (used_[i]) write_material(i);
  write_groups();
  write_shapes(scene_);
  losses_.count("names", scene_.names.size());
  RenderDefaults held;
  held.max_depth = scene_.defaults.max_depth;
  held.min_contribution = scene_.defaults.min_contribution;
  held.shadows = scene_.defaults.shadows;
  losses_.defaults(scene_, held);
  return WrittenScene{std::move(text_), losses_.diagnostics("POV-Ray")};
}

Result<WrittenScene> write_povray(const Scene& scene) {
  return PovrayWriter(scene).write();
}

}  // namespace zraka
