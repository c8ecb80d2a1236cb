// SPDX-License-Identifier: Apache-2.0
// From a base colour, how metallic and how rough a surface is, to shares of light: what is rough
// scatters, what is smooth mirrors. docs/gltf.md has the formulas.
#include "formats/gltf_materials.hpp"

#include <algorithm>
#include <cmath>

#include "formats/vectors.hpp"

namespace zraka {
namespace {

Color color_of(const double* values) {
  return {std::max(values[0], 0.0), std::max(values[1], 0.0), std::max(values[2], 0.0)};
}

double share(double value) {
  return std::clamp(value, 0.0, 1.0);
}

Color plus(const Color& a, const Color& b) {
  return {a.r + b.r, a.g + b.g, a.b + b.b};
}

/// The nearest pixel of an image where another of a size has one.
const float* pixel_at(const Image& image, std::uint32_t x, std::uint32_t y, std::uint32_t width,
                      std::uint32_t height) {
  const std::uint64_t column = std::uint64_t{x} * image.width / width;
  const std::uint64_t row = std::uint64_t{y} * image.height / height;
  return image.row(static_cast<std::uint32_t>(row)) + 3 * column;
}

}  // namespace

void GltfMaterials::read_rough(const Json* json, Surface& s) {
  const Json* const rough = GltfFile::member(json, "pbrMetallicRoughness");
  double base[4] = {1, 1, 1, 1};
  file_.numbers(rough, "baseColorFactor", 4, base);
  s.base = color_of(base);
  s.alpha = share(base[3]);
  s.metallic = share(file_.number(rough, "metallicFactor", 1));
  s.roughness = share(file_.number(rough, "roughnessFactor", 1));
  s.base_map = map_of(GltfFile::member(rough, "baseColorTexture"), Transfer::srgb);
  if (const std::optional<Map> map =
          map_of(GltfFile::member(rough, "metallicRoughnessTexture"), Transfer::linear)) {
    s.roughness *= mean_channel(*map, 1);
    s.metallic *= mean_channel(*map, 2);
    file_.warn("textures of roughness are taken at their mean");
  }
}

/// An older way to say it.
void GltfMaterials::read_glossy(const Json* json, Surface& s) {
  const Json* const glossy = GltfFile::extension(json, "KHR_materials_pbrSpecularGlossiness");
  if (glossy == nullptr) return;
  double diffuse[4] = {1, 1, 1, 1};
  file_.numbers(glossy, "diffuseFactor", 4, diffuse);
  s.base = color_of(diffuse);
  s.alpha = share(diffuse[3]);
  s.metallic = 0;
  s.roughness = 1 - share(file_.number(glossy, "glossinessFactor", 1));
  s.base_map = map_of(GltfFile::member(glossy, "diffuseTexture"), Transfer::srgb);
}

void GltfMaterials::read_optics(const Json* json, Surface& s) {
  const Json* const clear = GltfFile::extension(json, "KHR_materials_transmission");
  s.transmission = share(file_.number(clear, "transmissionFactor", 0));
  if (GltfFile::member(clear, "transmissionTexture") != nullptr)
    file_.warn("textures of transmission are left out");
  const Json* const volume = GltfFile::extension(json, "KHR_materials_volume");
  s.thickness = file_.number(volume, "thicknessFactor", 0);
  double attenuation[3] = {1, 1, 1};
  file_.numbers(volume, "attenuationColor", 3, attenuation);
  s.attenuation = color_of(attenuation);
  s.attenuation_distance = file_.number(volume, "attenuationDistance", 0);
  s.ior = std::clamp(file_.number(GltfFile::extension(json, "KHR_materials_ior"), "ior", 1.5), 1.0,
                     10.0);
  s.dispersion =
      file_.number(GltfFile::extension(json, "KHR_materials_dispersion"), "dispersion", 0);
  s.is_unlit = GltfFile::extension(json, "KHR_materials_unlit") != nullptr;
}

GltfMaterials::Surface GltfMaterials::surface_of(std::optional<std::size_t> index) {
  Surface s;
  const Json* const json = index ? file_.item("materials", *index) : nullptr;
  if (json == nullptr) return s.metallic = 0, s;
  read_rough(json, s);
  read_glossy(json, s);
  read_optics(json, s);
  double emission[3] = {0, 0, 0};
  file_.numbers(json, "emissiveFactor", 3, emission);
  s.emission =
      color_of(emission) *
      std::max(0.0, file_.number(GltfFile::extension(json, "KHR_materials_emissive_strength"),
                                 "emissiveStrength", 1));
  if (s.emission != Color{})
    s.emission_map = map_of(GltfFile::member(json, "emissiveTexture"), Transfer::srgb);
  const Json* const normal = GltfFile::member(json, "normalTexture");
  s.normal_map = map_of(normal, Transfer::linear);
  s.normal_scale = file_.number(normal, "scale", 1);
  const std::string mode = file_.word(json, "alphaMode", "OPAQUE");
  s.alpha_mode = mode == "BLEND"  ? Surface::Alpha::blend
                 : mode == "MASK" ? Surface::Alpha::mask
                                  : Surface::Alpha::opaque;
  s.cutoff = file_.number(json, "alphaCutoff", 0.5);
  return s;
}

/// Shapes have one u and v: textures on another are left out.
void GltfMaterials::drop_other_sets(Surface& s) {
  std::optional<std::size_t> set;
  for (std::optional<Map>* map : {&s.base_map, &s.emission_map, &s.normal_map}) {
    if (!*map) continue;
    if (!set) set = (*map)->uv_set;
    if ((*map)->uv_set == *set) continue;
    file_.warn("textures on other coordinates than the base colour's are left out");
    map->reset();
  }
}

void GltfMaterials::make_opaque(Surface& s, Material& m) {
  // How much of the mirror there is.
  const double gloss = (1 - s.roughness) * (1 - s.roughness);
  const double mirror = gloss > 0.05 ? gloss : 0, rough = s.roughness * s.roughness;
  const Color mean_base =
      s.base_map ? s.base * Color{mean_channel(*s.base_map, 0), mean_channel(*s.base_map, 1),
                                  mean_channel(*s.base_map, 2)}
                 : s.base;
  const double scattered = (1 - s.metallic) * (1 - s.transmission) + s.metallic * (1 - mirror);
  constexpr double kDielectric = 0.04, kBrightest = 0.8;
  const double width = std::max(rough * rough, 1e-3);
  m.highlight = Highlight::blinn;
  m.shininess = std::clamp(2 / width - 2, 1.0, 2000.0);
  const double strength = std::min((m.shininess + 8) / 8, 6.0);
  const auto highlight = [&](double base) {
    return std::min((kDielectric * (1 - s.metallic) + base * s.metallic) * strength, kBrightest);
  };
  m.specular = {highlight(mean_base.r), highlight(mean_base.g), highlight(mean_base.b)};
  m.diffuse = m.ambient = mean_base * scattered;
  const Color mirrored = mean_base * (s.metallic * mirror);
  const double sheen =
      s.roughness < 0.3 && s.transmission == 0 ? kDielectric * mirror * (1 - s.metallic) : 0;
  m.reflection = plus(mirrored, {sheen, sheen, sheen});
  if (!s.base_map) return;
  use(s.base_map->texture, s.base * scattered, Coefficient::diffuse, m);
  use(s.base_map->texture, s.base * scattered, Coefficient::ambient, m);
  if (s.metallic * mirror > 0.02)
    use(s.base_map->texture, s.base * (s.metallic * mirror), Coefficient::reflection, m);
}

void GltfMaterials::make_clear(const Surface& s, Material& m) {
  if (s.transmission > 0) {
    m.refraction = s.base * s.transmission;
    m.fresnel = Fresnel::exact;
    // Without a thickness it is a thin sheet, which bends nothing.
    m.ior = s.thickness > 0 ? s.ior : 1;
    if (s.thickness > 0 && s.attenuation_distance > 0) {
      const auto absorbed = [&](double left) {
        return -std::log(std::clamp(left, 1e-6, 1.0)) / s.attenuation_distance;
      };
      m.absorption = {absorbed(s.attenuation.r), absorbed(s.attenuation.g),
                      absorbed(s.attenuation.b)};
    }
    constexpr double kAbbe = 20, kLeast = 10;
    if (s.thickness > 0 && s.dispersion > 0)
      m.dispersion = {Dispersion::Kind::abbe, {std::max(kAbbe / s.dispersion, kLeast)}};
    return;
  }
  if (s.alpha_mode == Surface::Alpha::opaque) return;
  const bool is_mask = s.alpha_mode == Surface::Alpha::mask;
  const auto seen = [&](double alpha) {
    return is_mask ? (alpha >= s.cutoff ? 1.0 : 0.0) : share(alpha);
  };
  if (!s.base_map || s.base_map->alpha == nullptr) {
    const double left = seen(s.alpha);
    m.refraction = 1 - left;
    m.diffuse = m.diffuse * left, m.ambient = m.ambient * left, m.specular = m.specular * left;
    m.reflection = m.reflection * left;
    return;
  }
  // Where the picture is clear, light passes, and there is less of all else.
  const std::vector<float>& alpha = *s.base_map->alpha;
  Texture clear = s.base_map->texture, rest = s.base_map->texture;
  auto hole = std::make_shared<Image>(clear.image->width, clear.image->height);
  auto color = std::make_shared<Image>(*rest.image);
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    const auto left = static_cast<float>(seen(s.alpha * static_cast<double>(alpha[i])));
    for (std::size_t k = 3 * i; k < 3 * i + 3; ++k)
      hole->pixels[k] = 1 - left, color->pixels[k] *= left;
  }
  clear.image = hole, rest.image = color;
  clear.transfer = Transfer::linear;
  clear.file.clear(), rest.file.clear();
  m.textures.clear();
  m.specular = {}, m.reflection = 0;
  use(rest, s.base, Coefficient::diffuse, m);
  use(rest, s.base, Coefficient::ambient, m);
  use(clear, {1, 1, 1}, Coefficient::refraction, m);
}

/// Light of its own is ambient light that it has the more of.
void GltfMaterials::add_emission(const Surface& s, Material& m) {
  const Color light = s.emission * (1 / kGltfAmbient);
  if (light == Color{}) return;
  const auto ambient =
      std::find_if(m.textures.begin(), m.textures.end(),
                   [](const TextureUse& use) { return use.coefficient == Coefficient::ambient; });
  const Image* const own =
      ambient == m.textures.end() ? nullptr : scene_.textures[ambient->texture].image.get();
  if (!s.emission_map && own == nullptr) {
    m.ambient = plus(m.ambient, light);
    return;
  }
  // Both as one picture, as fine as the finer one.
  const Image* const glow = s.emission_map ? s.emission_map->texture.image.get() : nullptr;
  const Image& larger =
      glow != nullptr && (own == nullptr || glow->width > own->width) ? *glow : *own;
  auto image = std::make_shared<Image>(larger.width, larger.height);
  const float plain[3] = {static_cast<float>(m.ambient.r), static_cast<float>(m.ambient.g),
                          static_cast<float>(m.ambient.b)};
  const float by[3] = {static_cast<float>(light.r), static_cast<float>(light.g),
                       static_cast<float>(light.b)};
  constexpr float kWhite[3] = {1, 1, 1};
  for (std::uint32_t y = 0; y < image->height; ++y)
    for (std::uint32_t x = 0; x < image->width; ++x) {
      const float* const a =
          own != nullptr ? pixel_at(*own, x, y, image->width, image->height) : plain;
      const float* const b =
          glow != nullptr ? pixel_at(*glow, x, y, image->width, image->height) : kWhite;
      for (std::size_t k = 0; k < 3; ++k) image->row(y)[3 * x + k] = a[k] + by[k] * b[k];
    }
  Texture texture = own != nullptr ? scene_.textures[ambient->texture] : s.emission_map->texture;
  texture.image = std::move(image);
  texture.file.clear();
  const auto index = static_cast<std::uint32_t>(scene_.textures.size());
  scene_.textures.push_back(std::move(texture));
  if (ambient != m.textures.end())
    ambient->texture = index;
  else
    m.textures.push_back({Coefficient::ambient, index});
}

std::uint32_t GltfMaterials::add(Surface s, std::optional<std::size_t> index) {
  Material m;
  if (s.is_unlit) s.emission = {}, s.metallic = 0, s.roughness = 1;
  make_opaque(s, m);
  make_clear(s, m);
  if (s.is_unlit) {
    // Its colour, whatever the light.
    m.ambient = m.diffuse * (1 / kGltfAmbient);
    m.diffuse = m.specular = {};
    std::erase_if(m.textures, [](const TextureUse& use) {
      return use.coefficient == Coefficient::diffuse || use.coefficient == Coefficient::specular;
    });
    for (TextureUse& use : m.textures)
      if (use.coefficient == Coefficient::ambient) {
        const Texture texture = scene_.textures[use.texture];
        const double bright = 1 / kGltfAmbient;
        use.texture = scaled(texture, {bright, bright, bright});
      }
  }
  add_emission(s, m);
  if (s.normal_map) {
    Texture texture = s.normal_map->texture;
    if (s.normal_scale != 1) {
      auto image = std::make_shared<Image>(*texture.image);
      const auto by = static_cast<float>(s.normal_scale);
      for (std::size_t i = 0; i < image->pixels.size(); ++i)
        if (i % 3 != 2)
          image->pixels[i] = std::clamp(0.5f + (image->pixels[i] - 0.5f) * by, 0.0f, 1.0f);
      texture.image = std::move(image);
      texture.file.clear();
    }
    m.normals = {NormalUse::Kind::normal_map, scaled(texture, {1, 1, 1})};
  }
  const auto material = static_cast<std::uint32_t>(scene_.materials.size());
  scene_.materials.push_back(std::move(m));
  if (index) {
    const std::string name = file_.word(file_.item("materials", *index), "name", "");
    if (!name.empty()) scene_.material_names[material] = name;
  }
  return material;
}

GltfMaterials::Look GltfMaterials::look(std::optional<std::size_t> index, const Color& vertices) {
  const auto key = std::make_pair(index ? *index + 1 : 0,
                                  std::array<double, 3>{vertices.r, vertices.g, vertices.b});
  const auto known = looks_.find(key);
  if (known != looks_.end()) return known->second;
  Surface surface = surface_of(index);
  surface.base = surface.base * vertices;
  drop_other_sets(surface);
  Look look;
  for (const std::optional<Map>* map :
       {&surface.base_map, &surface.emission_map, &surface.normal_map})
    if (*map) look.uv_set = (*map)->uv_set;
  look.material = add(std::move(surface), index);
  return looks_.emplace(key, look).first->second;
}

std::uint32_t GltfMaterials::painted(std::optional<std::size_t> index, const Texture& colors) {
  Surface surface = surface_of(index);
  if (surface.base_map) {
    file_.warn("colours of vertices are seen without the texture that is there, too");
    surface.base =
        surface.base * Color{mean_channel(*surface.base_map, 0), mean_channel(*surface.base_map, 1),
                             mean_channel(*surface.base_map, 2)};
  }
  surface.normal_map.reset(), surface.emission_map.reset();
  surface.base_map = Map{colors, nullptr, 0};
  return add(std::move(surface), index);
}

}  // namespace zraka
