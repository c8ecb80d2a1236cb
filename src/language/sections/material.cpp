// SPDX-License-Identifier: Apache-2.0
// [material.NAME].
#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "core/text.hpp"
#include "language/sections.hpp"
#include "language/textures.hpp"
#include "materials/dispersion.hpp"
#include "materials/glasses.hpp"

namespace zraka::language {
namespace {

struct Bump {
  TextureIndex texture;
  double height = NormalUse{}.height;
};
struct NormalMap {
  TextureIndex texture;
};
struct Abbe {
  double abbe = 60;
};
struct Cauchy {
  std::array<double, 3> cauchy{};
};
struct Sellmeier {
  std::array<double, 6> sellmeier{};
};
struct MaterialEntry : Material {
  std::optional<double> own_ior;
  std::variant<std::monostate, Abbe, Cauchy, Sellmeier> dispersion_entry;
  std::optional<std::string> glass;
  std::optional<Bump> bump;
  std::optional<NormalMap> normal_map;
};

/// The coefficient's texture, or none any more.
void set_texture(Material& material, Coefficient coefficient,
                 const std::optional<TextureIndex>& texture) {
  std::erase_if(material.textures,
                [&](const TextureUse& use) { return use.coefficient == coefficient; });
  if (texture) material.textures.push_back({coefficient, texture->index});
}

/// A field whose value is in a member, or is a texture in Material::textures.
template <auto member, Coefficient coefficient>
constexpr Field textured_field(std::string_view key, About about) {
  about.textured = true;
  Field made = field<member, MaterialEntry>(key, about);
  made.get = [](const void* object) {
    const Material& material = *static_cast<const MaterialEntry*>(object);
    for (const TextureUse& use : material.textures)
      if (use.coefficient == coefficient) return FieldValue(TextureIndex{use.texture});
    return fields::value_of(material.*member);
  };
  made.set = [](void* object, FieldValue&& value) {
    Material& material = *static_cast<MaterialEntry*>(object);
    const auto* const texture = std::get_if<TextureIndex>(&value);
    set_texture(material, coefficient, texture != nullptr ? std::optional(*texture) : std::nullopt);
    if (texture == nullptr) fields::put_into(material.*member, std::move(value));
  };
  return made;
}

/// Short for two fields; it is read before them.
constexpr Field color_of_both() {
  Field made{.key = "color",
             .kind = FieldKind::color,
             .about = {.text = "short for the same ambient and diffuse",
                       .range = at_least(0),
                       .textured = true}};
  made.get = [](const void*) { return FieldValue(); };
  made.set = [](void* object, FieldValue&& value) {
    Material& material = *static_cast<MaterialEntry*>(object);
    if (const auto* const texture = std::get_if<TextureIndex>(&value)) {
      set_texture(material, Coefficient::ambient, *texture);
      set_texture(material, Coefficient::diffuse, *texture);
    } else {
      material.ambient = material.diffuse = std::get<Color>(value);
    }
  };
  return made;
}

constexpr Field kBumpFields[] = {
    field<&Bump::texture>("texture", {.text = "how high it is, as brightness", .required = true}),
    field<&Bump::height>("height",
                         {.text = "how high 1 is, in the shape's space", .unit = Unit::length}),
};
constexpr Table kBump =
    table_of<Bump>("bump", "Bends the normal as if the surface had bumps.", kBumpFields);
constexpr Field kNormalMapFields[] = {
    field<&NormalMap::texture>(
        "texture",
        {.text = "normals along u, along v and outwards, from -1 to 1 as colours from 0 to 1",
         .required = true}),
};
constexpr Table kNormalMap = table_of<NormalMap>(
    "normal_map", "Takes the normal from a picture of normals.", kNormalMapFields);

constexpr Choice kHighlights[] = {
    {"phong", "(R·V)^n, by the reflected light (Phong 1975)"},
    {"blinn", "(N·H)^n, by the direction halfway between light and viewer (Blinn 1977)"},
};
constexpr Choice kFresnels[] = {
    {"off", "not at all"},
    {"exact", "by Fresnel's equations for unpolarised light"},
    {"schlick", "by Schlick's approximation (1994)"},
};

constexpr Field kAbbeFields[] = {
    field<&Abbe::abbe>("abbe",
                       {.text = "Abbe's number, (n_d - 1)/(n_F - n_C), where n_d is the ior",
                        .range = greater_than(0),
                        .required = true}),
};
constexpr Table kAbbe = table_of<Abbe>("abbe", "By Cauchy's first two terms.", kAbbeFields);
constexpr Field kCauchyFields[] = {
    field<&Cauchy::cauchy>("cauchy",
                           {.text = "A, B, C in n = A + B/λ² + C/λ⁴, λ in µm", .required = true}),
};
constexpr Table kCauchy = table_of<Cauchy>("cauchy", "By Cauchy's formula.", kCauchyFields);
constexpr Field kSellmeierFields[] = {
    field<&Sellmeier::sellmeier>(
        "sellmeier", {.text = "B1, B2, B3, C1, C2, C3 in n² = 1 + Σ Bi·λ²/(λ² - Ci), λ in µm",
                      .required = true}),
};
constexpr Table kSellmeier =
    table_of<Sellmeier>("sellmeier", "By Sellmeier's formula.", kSellmeierFields);

constexpr Field kMaterialFields[] = {
    color_of_both(),
    textured_field<&Material::ambient, Coefficient::ambient>(
        "ambient", {.text = "share of the ambient light", .range = at_least(0), .symbol = "ka"}),
    textured_field<&Material::diffuse, Coefficient::diffuse>(
        "diffuse", {.text = "share of light that leaves in all directions",
                    .range = at_least(0),
                    .symbol = "kd"}),
    textured_field<&Material::specular, Coefficient::specular>(
        "specular",
        {.text = "share of light in the highlight", .range = at_least(0), .symbol = "ks"}),
    textured_field<&Material::shininess, Coefficient::shininess>(
        "shininess", {.text = "the highlight's exponent", .range = at_least(0), .symbol = "n"}),
    field<&Material::highlight, MaterialEntry>(
        "highlight", {.text = "the highlight's formula", .choices = kHighlights}),
    textured_field<&Material::reflection, Coefficient::reflection>(
        "reflection", {.text = "share of the reflected ray", .range = at_least(0), .symbol = "k1"}),
    textured_field<&Material::refraction, Coefficient::refraction>(
        "refraction", {.text = "share of the refracted ray", .range = at_least(0), .symbol = "k2"}),
    field<&MaterialEntry::own_ior>(
        "ior",
        {.text = "index of refraction of the inside; with the profile lab, n1/n2 on entry. Where "
                 "nothing is said, 1, or that of the dispersion's formula at 587.56 nm",
         .range = greater_than(0),
         .symbol = "ni"}),
    field<&Material::fresnel, MaterialEntry>(
        "fresnel",
        {.text = "how the angle moves light from refraction to reflection", .choices = kFresnels}),
    field<&Material::absorption, MaterialEntry>(
        "absorption", {.text = "what the inside swallows per unit of length: exp(-a·d) is left",
                       .range = at_least(0)}),
    field<&Material::priority, MaterialEntry>(
        "priority",
        {.text = "where bodies overlap, the inside of the higher one counts",
         .range = from_to(std::numeric_limits<int>::min(), std::numeric_limits<int>::max())}),
    table_field<&MaterialEntry::dispersion_entry, kAbbe, kCauchy, kSellmeier>(
        "dispersion", {.text = "how the index depends on the wavelength"}),
    field<&MaterialEntry::glass>("glass",
                                 {.text = "short for ior and dispersion of a material that is "
                                          "known by its name, in any case",
                                  .unit = Unit::name_of_glass}),
    field<&Material::casts_shadow, MaterialEntry>(
        "casts_shadow", {.text = "whether it stands in the way of light"}),
    field<&Material::cut_group, MaterialEntry>(
        "cut_group", {.text = "the group of the cuts that concern it, besides those of everything",
                      .range = from_to(0, 4294967295.0)}),
    table_field<&MaterialEntry::bump, kBump>(
        "bump", {.text = "a texture that bends the normal by its height"}),
    table_field<&MaterialEntry::normal_map, kNormalMap>("normal_map",
                                                        {.text = "a texture of normals"}),
};
constexpr Table kMaterialTable =
    table_of<MaterialEntry>("material",
                            "What a surface does with light. A shape that names "
                            "none has the material default, which is grey "
                            "where the file does not say what it is.",
                            kMaterialFields);

NormalUse normals_of(const MaterialEntry& entry) {
  if (entry.bump) return {NormalUse::Kind::bump, entry.bump->texture.index, entry.bump->height};
  if (entry.normal_map) return {NormalUse::Kind::normal_map, entry.normal_map->texture.index};
  return {};
}

struct DispersionOf {
  using K = Dispersion::Kind;
  Dispersion operator()(std::monostate) const { return {}; }
  Dispersion operator()(const Abbe& d) const { return {K::abbe, {d.abbe}}; }
  Dispersion operator()(const Cauchy& d) const { return of(K::cauchy, d.cauchy); }
  Dispersion operator()(const Sellmeier& d) const { return of(K::sellmeier, d.sellmeier); }
  static Dispersion of(K kind, std::span<const double> numbers) {
    Dispersion made{kind};
    std::copy(numbers.begin(), numbers.end(), made.numbers.begin());
    return made;
  }
};

/// Of a material that does not say it.
double ior_of(const Dispersion& dispersion) {
  return refractive_index(dispersion, Material{}.ior, kLineD);
}

/// What the glass is, or why it is none.
void read_glass(const toml::Node& node, MaterialEntry& entry, std::string_view what,
                Problems& problems) {
  const toml::Node& name = *node.find("glass");
  for (const char* other : {"ior", "dispersion"})
    if (const toml::Node* const both = node.find(other))
      problems.error(both->key_begin,
                     fmt::format("{} has glass and {}: expected one of them", what, other));
  const Glass* const glass = glass_named(*entry.glass);
  if (glass != nullptr) {
    entry.dispersion = glass->dispersion;
    entry.ior = glass->ior();
    return;
  }
  std::vector<std::string_view> known;
  for (const Glass& each : glasses()) known.push_back(each.name);
  problems.unknown(name.begin, fmt::format("unknown glass '{}' for {}", shown(*entry.glass), what),
                   *entry.glass, known, "glasses");
}

void read_optics(const toml::Node& node, MaterialEntry& entry, std::string_view what,
                 Problems& problems) {
  entry.dispersion = std::visit(DispersionOf(), entry.dispersion_entry);
  entry.ior = entry.own_ior.value_or(ior_of(entry.dispersion));
  if (entry.glass)
    read_glass(node, entry, what, problems);
  else if (entry.dispersion.kind != Dispersion::Kind::none &&
           !has_index(entry.dispersion, entry.ior))
    problems.error(node.find("dispersion")->begin,
                   fmt::format("dispersion of {} has no index above 0 for some of the light that "
                               "is seen, from {} to {} µm",
                               what, kShortestSeen, kLongestSeen));
}

void read_material(const toml::Node& node, Input& input) {
  MaterialEntry entry;
  const std::string what = fmt::format("material {}", key_of(node.key));
  const std::size_t before = input.problems.errors();
  read_fields(node, kMaterialTable, what, &entry, input);
  if (entry.bump && entry.normal_map)
    input.problems.error(node.find("normal_map")->begin,
                         fmt::format("{} has bump and normal_map: expected one of them", what));
  if (input.problems.errors() == before) read_optics(node, entry, what, input.problems);
  entry.normals = normals_of(entry);
  std::sort(entry.textures.begin(), entry.textures.end(),
            [](const TextureUse& a, const TextureUse& b) { return a.coefficient < b.coefficient; });
  const auto index = static_cast<std::uint32_t>(input.scene.materials.size());
  input.materials.emplace(node.key, index);
  input.scene.material_names.emplace(index, node.key);
  input.scene.materials.push_back(entry);
}

MaterialEntry entry_of(const Material& material) {
  MaterialEntry entry;
  static_cast<Material&>(entry) = material;
  if (material.ior != ior_of(material.dispersion)) entry.own_ior = material.ior;
  const std::array<double, 6>& k = material.dispersion.numbers;
  switch (material.dispersion.kind) {
    case Dispersion::Kind::none:
      break;
    case Dispersion::Kind::abbe:
      entry.dispersion_entry = Abbe{k[0]};
      break;
    case Dispersion::Kind::cauchy:
      entry.dispersion_entry = Cauchy{{k[0], k[1], k[2]}};
      break;
    case Dispersion::Kind::sellmeier:
      entry.dispersion_entry = Sellmeier{k};
      break;
  }
  const TextureIndex texture{material.normals.texture};
  if (material.normals.kind == NormalUse::Kind::bump)
    entry.bump = Bump{texture, material.normals.height};
  if (material.normals.kind == NormalUse::Kind::normal_map) entry.normal_map = NormalMap{texture};
  return entry;
}

void write_material(Output& output) {
  for (std::size_t i = 0; i < output.scene.materials.size(); ++i) {
    const std::string key = key_of(output.materials[i]);
    const MaterialEntry entry = entry_of(output.scene.materials[i]);
    write_table(fmt::format("[material.{}]", key), true, kMaterialTable, fmt::format("material {}", key),
                &entry, output.text);
  }
}

}  // namespace

constexpr Section section::material = {.key = "material",
                                       .form = Section::Form::named,
                                       .text = kMaterialTable.text,
                                       .table = &kMaterialTable,
                                       .read = read_material,
                                       .write = write_material,
                                       .end = make_normal_maps_linear};

}  // namespace zraka::language
