// SPDX-License-Identifier: Apache-2.0
// From Tachyon's surfaces to materials, once the shader and all else is known:
// C·(ambient + diffuse·light) + highlight + mirror·reflected + (1 - opacity)·what is behind.
#include <algorithm>
#include <cmath>

#include "formats/painted.hpp"
#include "formats/tachyon_reader.hpp"

namespace zraka {
namespace {

Color scaled(const Color& c, double s) {
  return {c.r * s, c.g * s, c.b * s};
}

}  // namespace

/// The pattern times a factor gives a coefficient.
void TachyonReader::add_texture(Material& material, Coefficient coefficient, const Texture& pattern,
                                double factor) {
  if (!(factor > 0)) return;
  Texture t = pattern;
  if (t.kind == TextureKind::image && factor != 1) {
    std::shared_ptr<const Image>& image = scaled_images_[{pattern.image.get(), factor}];
    if (image == nullptr) {
      Image copy = *pattern.image;
      for (float& value : copy.pixels) value *= static_cast<float>(factor);
      image = std::make_shared<const Image>(std::move(copy));
    }
    t.image = image;
  }
  for (Color& color : t.colors) color = scaled(color, factor);
  material.textures.push_back({coefficient, static_cast<std::uint32_t>(scene_.textures.size())});
  scene_.textures.push_back(std::move(t));
}

/// What the lights' colours are on average: METAL's highlight does not have them, so they are
/// divided by.
Color TachyonReader::mean_light() const {
  Color sum;
  for (const Light& light : scene_.lights)
    sum = {sum.r + light.color.r, sum.g + light.color.g, sum.b + light.color.b};
  const double n = static_cast<double>(scene_.lights.size());
  const auto mean = [&](double s) { return s > 0 ? s / n : 1.0; };
  return {mean(sum.r), mean(sum.g), mean(sum.b)};
}

Material TachyonReader::material_from(const TachyonSurface& s) {
  Material m;
  m.highlight = settings_.highlight.value_or(Highlight::blinn);
  double ambient = s.ambient, diffuse = s.diffuse, highlight = s.highlight, mirror = s.mirror;
  double through = 1 - s.opacity;
  if (settings_.no_highlight) highlight = 0;
  if (s.opacity < 1 && trans_vmd_) {
    ambient *= s.opacity, diffuse *= s.opacity;
    highlight *= s.opacity, mirror *= s.opacity;
  }
  if (s.opacity < 1 && !shadow_filter_) m.casts_shadow = false;
  if (s.shines != 0) m.casts_shadow = false;
  // Light from all around is as much as what falls on a surface straight.
  if (scene_.ambient_occlusion.samples > 0 && s.shines == 0) ambient += diffuse;
  if (mode_ >= TachyonMode::low) ambient = 1, diffuse = highlight = mirror = through = 0;
  const Color color = mode_ == TachyonMode::lowest ? Color{1, 1, 1} : Color{s.r, s.g, s.b};
  m.ambient = scaled(color, ambient);
  m.diffuse = scaled(color, diffuse);
  const Color c = scaled(color, highlight), light = mean_light();
  m.specular = s.metal != 0 ? Color{c.r / light.r, c.g / light.g, c.b / light.b}
                            : Color{highlight, highlight, highlight};
  m.shininess = s.shininess;
  m.cut_group = static_cast<std::uint32_t>(s.cut);
  m.reflection = mirror;
  m.refraction = through;
  if (s.pattern > 0 && mode_ != TachyonMode::lowest) {
    const Texture pattern = patterns_[static_cast<std::size_t>(s.pattern) - 1];
    add_texture(m, Coefficient::ambient, pattern, ambient);
    add_texture(m, Coefficient::diffuse, pattern, diffuse);
    if (s.metal != 0)
      add_texture(m, Coefficient::specular, pattern, 3 * highlight / (light.r + light.g + light.b));
  }
  return m;
}

void TachyonReader::paint() {
  for (Painted& painted : painted_) {
    scene_.smooth_triangle_uvs.resize(scene_.smooth_triangles.size());
    patterns_.push_back(
        painted_texture(painted.colors, [&](std::size_t i, const CornerUvs& corners) {
          scene_.smooth_triangle_uvs[painted.triangles[i]] = corners;
        }));
    std::vector<float>().swap(painted.colors);
    surfaces_[painted.material].pattern = static_cast<double>(patterns_.size());
  }
}

void TachyonReader::set_materials() {
  mode_ = settings_.mode.value_or(mode_);
  shadow_filter_ = settings_.shadow_filter.value_or(shadow_filter_);
  trans_vmd_ = trans_vmd_ || settings_.trans_vmd;
  if (settings_.skylight) {
    // As bright as asked for, and lights the weaker.
    const double sky = *settings_.skylight;
    scene_.ambient_occlusion.color = {sky, sky, sky};
    if (scene_.ambient_occlusion.samples == 0) scene_.ambient_occlusion.samples = 16;
  }
  if (settings_.skylight_samples && scene_.ambient_occlusion.samples > 0)
    scene_.ambient_occlusion.samples = *settings_.skylight_samples;
  if (mode_ != TachyonMode::full) scene_.ambient_occlusion.samples = 0;
  if (scene_.ambient_occlusion.samples == 0) scene_.ambient_occlusion = {};
  paint();
  scene_.materials.reserve(surfaces_.size());
  for (const TachyonSurface& surface : surfaces_)
    scene_.materials.push_back(material_from(surface));
  for (const auto& [name, surface] : names_) {
    const auto found = materials_.find(surface);
    if (found != materials_.end()) scene_.material_names[found->second] = name;
  }
}

void TachyonReader::set_defaults() {
  const double scale = light_scale_ * settings_.light_scale;
  for (Light& light : scene_.lights) light.color = scaled(light.color, scale);
  scene_.ambient_light = {1, 1, 1};
  scene_.fog.planar = fog_vmd_ || settings_.fog_vmd;
  if (mode_ >= TachyonMode::low) scene_.fog = {};
  if (mode_ == TachyonMode::lowest) scene_.background = {}, scene_.sky = {};
  RenderDefaults& defaults = scene_.defaults;
  defaults.profile = ProfileName::tachyon;
  // A ray of depth 1 has no children.
  defaults.max_depth =
      static_cast<int>(std::clamp(depth_ - 1, 0.0, static_cast<double>(kMaxDepth)));
  const bool transparent = std::any_of(surfaces_.begin(), surfaces_.end(),
                                       [](const TachyonSurface& s) { return s.opacity < 1; });
  defaults.shadows = mode_ != TachyonMode::full      ? Shadows::off
                     : transparent && shadow_filter_ ? Shadows::transparent
                                                     : Shadows::opaque;
  defaults.sampling.count =
      static_cast<int>(std::clamp(samples_ + 1, 1.0, static_cast<double>(kMaxSamples)));
}

}  // namespace zraka
