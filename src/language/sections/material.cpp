// SPDX-License-Identifier: Apache-2.0
// [material.NAME].
#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"
#include "language/sections.hpp"
#include "language/textures.hpp"

namespace zraka::language {
namespace {

struct Bump {
  TextureIndex texture;
  double height = NormalUse{}.height;
};
struct NormalMap {
  TextureIndex texture;
};
struct MaterialEntry : Material {
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

constexpr Field kFields[] = {
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
    only("highlight", "phong", "the highlight's formula, (R·V)^n"),
    textured_field<&Material::reflection, Coefficient::reflection>(
        "reflection", {.text = "share of the reflected ray",
                       .range = at_least(0),
                       .symbol = "k1",
                       .later = "a colour"}),
    textured_field<&Material::refraction, Coefficient::refraction>(
        "refraction", {.text = "share of the refracted ray",
                       .range = at_least(0),
                       .symbol = "k2",
                       .later = "a colour"}),
    field<&Material::ior, MaterialEntry>(
        "ior", {.text = "index of refraction of the inside; with the profile lab, n1/n2 on entry",
                .range = greater_than(0),
                .symbol = "ni"}),
    only("fresnel", "off", "how the angle moves light from refraction to reflection"),
    only("absorption", 0, "what the inside swallows, per unit of length"),
    only("priority", 0, "which body counts where two overlap"),
    not_built("dispersion", "how the index depends on the wavelength"),
    not_built("glass", "the name of a glass, for its index"),
    table_field<&MaterialEntry::bump>("bump", kBump,
                                      {.text = "a texture that bends the normal by its height"}),
    table_field<&MaterialEntry::normal_map>("normal_map", kNormalMap,
                                            {.text = "a texture of normals"}),
};
constexpr Table kTable =
    table_of<MaterialEntry>("material",
                            "What a surface does with light. A shape that names "
                            "none has the material default, which is grey "
                            "where the file does not say what it is.",
                            kFields);

NormalUse normals_of(const MaterialEntry& entry) {
  if (entry.bump) return {NormalUse::Kind::bump, entry.bump->texture.index, entry.bump->height};
  if (entry.normal_map) return {NormalUse::Kind::normal_map, entry.normal_map->texture.index};
  return {};
}

void read(const toml::Node& node, Input& input) {
  MaterialEntry entry;
  const std::string what = fmt::format("material {}", key_of(node.key));
  read_fields(node, kTable, what, &entry, input);
  if (entry.bump && entry.normal_map)
    input.problems.error(node.find("normal_map")->begin,
                         fmt::format("{} has bump and normal_map: expected one of them", what));
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
  const TextureIndex texture{material.normals.texture};
  if (material.normals.kind == NormalUse::Kind::bump)
    entry.bump = Bump{texture, material.normals.height};
  if (material.normals.kind == NormalUse::Kind::normal_map) entry.normal_map = NormalMap{texture};
  return entry;
}

void write(Output& output) {
  for (std::size_t i = 0; i < output.scene.materials.size(); ++i) {
    const std::string key = key_of(output.materials[i]);
    const MaterialEntry entry = entry_of(output.scene.materials[i]);
    write_table(fmt::format("[material.{}]", key), true, kTable, fmt::format("material {}", key),
                &entry, output.text);
  }
}

}  // namespace

constexpr Section section::material = {.key = "material",
                                       .form = Section::Form::named,
                                       .text = kTable.text,
                                       .table = &kTable,
                                       .read = read,
                                       .write = write,
                                       .end = make_normal_maps_linear};

}  // namespace zraka::language
