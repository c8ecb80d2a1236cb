// SPDX-License-Identifier: Apache-2.0
// The frame of Tachyon's scenes: camera, shader, surroundings and lights. Its camera is
// left-handed; the scene stays as it is, and a FRUSTUM whose left and right are swapped turns the
// picture round.
#include "formats/tachyon_output.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <zraka/render.hpp>

#include "formats/plain_material.hpp"
#include "formats/vectors.hpp"

namespace zraka {
namespace {

constexpr double kExact = 1e-9;
constexpr double kRadians = 3.14159265358979323846 / 180;

bool are_square(const Vec3& a, const Vec3& b) {
  return std::fabs(dot(a, b)) <= kExact * length(a) * length(b);
}

tl::unexpected<Diagnostics> refuse(const std::string& what, const char* hint) {
  return failure("", "Tachyon cannot say " + what, hint);
}

}  // namespace

TachyonWriter::TachyonWriter(const Scene& scene)
    : scene_(scene), used_(used_materials(scene)), shines_(scene.materials.size()) {}

Result<void> TachyonWriter::write_camera() {
  const Camera c = with_central_rays(scene_);
  if (c.kind == CameraKind::fisheye)
    return refuse("what this scene's camera is: it knows perspective, orthographic and panorama",
                  "Tachyon's own fisheye is a panorama");
  const Vec3 to_window = c.window_center - c.eye;
  const bool is_panorama = c.kind == CameraKind::panorama;
  if (!is_panorama && !are_square(c.window_right, c.window_up))
    return refuse("what this scene's window is: its sides are askew", "");
  // Upright, and looking at the window at right angles; right is where Tachyon has it.
  const Vec3 facing = unit(cross(c.window_right, c.window_up));
  const Vec3 view = is_panorama ? unit(to_window) : facing * (dot(facing, to_window) < 0 ? -1 : 1);
  const Vec3 across = unit(cross(c.window_up, view)), up = cross(view, across);
  const double away = dot(to_window, view), way = dot(across, c.window_right) < 0 ? -1 : 1;
  double width = length(c.window_right) * way, height = length(c.window_up), x = 0, y = 0;
  if (is_panorama) {
    width = c.longitude_deg * kRadians * way, height = c.latitude_deg * kRadians;
    y = c.latitude_middle_deg * kRadians;
  } else if (c.kind == CameraKind::orthographic) {
    if (!are_square(to_window, c.window_right) || !are_square(to_window, c.window_up))
      return refuse("where this scene's window is: parallel rays go through it aslant", "");
  } else {
    if (!(away > 0)) return refuse("where this scene's window is: the eye is in its plane", "");
    x = dot(to_window, across) / away, y = dot(to_window, up) / away;
    width /= away, height /= away;
  }
  const Sampling& sampling = scene_.defaults.sampling;
  const double count = sampling.kind == Sampling::Kind::grid
                           ? static_cast<double>(sampling.count) * sampling.count
                           : sampling.count;
  const bool has_lens = c.aperture > 0 && c.kind == CameraKind::pinhole;
  losses_.count("the camera's lens, which wants samples of pixels", has_lens && count <= 1);
  put("CAMERA\n  PROJECTION ");
  if (has_lens && count > 1)
    put("PERSPECTIVE_DOF FOCALLENGTH {} APERTURE {}", c.focus_distance,
        c.aperture / std::sqrt(std::fabs(width * height)));
  else
    put("{}", is_panorama                          ? "FISHEYE"
              : c.kind == CameraKind::orthographic ? "ORTHOGRAPHIC"
                                                   : "PERSPECTIVE");
  put("\n  ZOOM 1 ASPECTRATIO 1 ANTIALIASING {} RAYDEPTH {}\n  ", count - 1,
      scene_.defaults.max_depth + 1);
  put_value("CENTER", c.eye);
  put_value("VIEWDIR", view);
  put_value("UPDIR", up);
  // Its rays go through the upper right corners of pixels.
  const double left = x - width / 2 - width / 2 / scene_.resolution.width;
  const double bottom = y - height / 2 - height / 2 / scene_.resolution.height;
  put("\n  FRUSTUM {} {} {} {}\nEND_CAMERA\n", left, left + width, bottom, bottom + height);
  return {};
}

void TachyonWriter::write_shader() {
  const auto is_clear = [](const Material& m) {
    return std::any_of(
               m.textures.begin(), m.textures.end(),
               [](const TextureUse& use) { return use.coefficient == Coefficient::refraction; }) ||
           m.refraction.most() > 0;
  };
  std::uint64_t dark = 0, light = 0;
  for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
    const Material& m = scene_.materials[i];
    if (!used_[i]) continue;
    if (is_clear(m))
      ++(m.casts_shadow ? dark : light);
    else
      losses_.count("materials: that they cast no shadow", !m.casts_shadow && !shines_[i]);
  }
  const Shadows shadows = scene_.defaults.shadows;
  const bool filter = dark > 0 || light == 0;
  put("SHADER_MODE {} {}\n", shadows == Shadows::off ? "MEDIUM" : "FULL",
      filter ? "SHADOW_FILTER_ON" : "SHADOW_FILTER_OFF");
  if (shadows != Shadows::off) {
    losses_.count("materials: that what is transparent throws a full shadow",
                  shadows == Shadows::opaque ? dark : 0);
    losses_.count("materials: that they cast no shadow", filter ? light : 0);
  }
  if (scene_.fog.kind != Fog::Kind::none && scene_.fog.planar) put("  FOG_VMD\n");
  const AmbientOcclusion& occlusion = scene_.ambient_occlusion;
  if (occlusion.samples > 0) {
    put("  AMBIENT_OCCLUSION ");
    put_value("AMBIENT_COLOR", occlusion_color_);
    put("RESCALE_DIRECT 1 SAMPLES {}\n", occlusion.samples);
    losses_.count("the distance of ambient occlusion", occlusion.distance > 0);
  }
  put("END_SHADER_MODE\n");
}

void TachyonWriter::write_surroundings() {
  const Sky& sky = scene_.sky;
  if (sky.kind == Sky::Kind::gradient) {
    put("BACKGROUND_GRADIENT SKY_SPHERE ");
    put_value("UPDIR", unit(sky.up));
    put("TOPVAL {} BOTTOMVAL {} ", sky.high, sky.low);
    put_value("TOPCOLOR", sky.top);
    put_value("BOTTOMCOLOR", sky.bottom);
    put("\n");
  } else {
    put_value("BACKGROUND", sky.kind == Sky::Kind::image ? mean_of(scene_.textures[sky.texture])
                                                         : scene_.background);
    put("\n");
  }
  losses_.count("the sky's picture", sky.kind == Sky::Kind::image);
  const Fog& fog = scene_.fog;
  if (fog.kind == Fog::Kind::none) return;
  put("FOG {} START {} END {} DENSITY {} ",
      fog.kind == Fog::Kind::linear        ? "LINEAR"
      : fog.kind == Fog::Kind::exponential ? "EXP"
                                           : "EXP2",
      fog.start, fog.end, fog.density);
  put_value("COLOR", fog.color);
  put("\n");
}

/// Of a sphere that stands where the light is and looks like it: Tachyon's lights are seen.
double TachyonWriter::seen_radius(const Light& light) const {
  for (const auto& [sphere, material, transform] : scene_.spheres)
    if (shines_[material] && sphere.center == light.position &&
        scene_.materials[material].ambient * scene_.ambient_light == light.color)
      return sphere.radius;
  return 0;
}

void TachyonWriter::write_light(const Light& light) {
  if (light.kind == LightKind::directional) {
    put("DIRECTIONAL_LIGHT ");
    put_value("DIRECTION", unit(light.direction));
    put_value("COLOR", light.color);
    return put("\n");
  }
  const bool is_spot = light.kind == LightKind::spot;
  Vec3 from = light.position;
  if (light.kind == LightKind::rectangle) from = from + (light.edge_u + light.edge_v) * 0.5;
  put("{} ", is_spot ? "SPOTLIGHT" : "LIGHT");
  put_value("CENTER", from);
  put("RAD {} ", light.is_surface() ? 0 : seen_radius(light));
  if (is_spot) {
    put_value("DIRECTION", light.direction);
    put("FALLOFF_START {} FALLOFF_END {} ", light.inner_deg, light.outer_deg);
    losses_.count("lights: the smooth edge of spots", !light.linear_edge);
  }
  if (light.attenuation != Light{}.attenuation)
    put("ATTENUATION CONSTANT {} LINEAR {} QUADRATIC {} ", light.attenuation.x, light.attenuation.y,
        light.attenuation.z);
  put_value("COLOR", light.color);
  put("\n");
  losses_.count("lights: that highlights fade, too", light.attenuation != Light{}.attenuation);
  losses_.count("lights: the size of rectangles, discs and spheres", light.is_surface());
}

Result<WrittenScene> TachyonWriter::write() {
  for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
    const Material& m = scene_.materials[i];
    shines_[i] =
        !m.casts_shadow && m.diffuse == Color{} && m.textures.empty() && m.refraction.most() == 0;
  }
  constexpr double kMostShapes = 1e8;
  group_shapes_.assign(scene_.groups.size(), -1);
  if (const double shapes = count_shapes(scene_); shapes > kMostShapes)
    return refuse(
        fmt::format("this scene: it knows no instances, and without them there are {:.0f} "
                    "shapes",
                    shapes),
        "formats that know instances: toml, povray");
  choose_occlusion();
  put("BEGIN_SCENE\nRESOLUTION {} {}\n", scene_.resolution.width, scene_.resolution.height);
  write_shader();
  if (const Result<void> camera = write_camera(); !camera)
    return tl::make_unexpected(camera.error());
  write_surroundings();
  for (const Light& light : scene_.lights) write_light(light);
  name_materials();
  for (std::uint32_t i = 0; i < scene_.materials.size(); ++i)
    if (used_[i]) write_material(i);
  write_shapes(scene_, {});
  clip({});
  for (const Cut& cut : scene_.cuts) {
    losses_.count("cuts: the caps that close bodies", cut.caps);
    losses_.count("cuts: that they are for the eye only", cut.eye_only);
  }
  put("END_SCENE\n");
  losses_.count("names", scene_.names.size());
  RenderDefaults held{.profile = ProfileName::tachyon};
  held.max_depth = scene_.defaults.max_depth;
  held.shadows = scene_.defaults.shadows;
  held.sampling.count = scene_.defaults.sampling.count;
  losses_.defaults(scene_, held);
  return WrittenScene{std::move(text_), losses_.diagnostics("Tachyon")};
}

Result<WrittenScene> write_tachyon(const Scene& scene) {
  return TachyonWriter(scene).write();
}

}  // namespace zraka
