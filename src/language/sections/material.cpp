// SPDX-License-Identifier: Apache-2.0
// [material.NAME].
#include <fmt/format.h>

#include "core/text.hpp"
#include "language/sections.hpp"

namespace zraka::language {
namespace {

constexpr std::string_view kTexture = "a texture";

/// Short for two fields; it is read before them.
constexpr Field color_of_both() {
  Field made{.key = "color",
             .kind = FieldKind::color,
             .about = {.text = "short for the same ambient and diffuse",
                       .range = at_least(0),
                       .later = kTexture}};
  made.get = [](const void*) { return FieldValue(); };
  made.set = [](void* object, FieldValue&& value) {
    Material& material = *static_cast<Material*>(object);
    material.ambient = material.diffuse = std::get<Color>(value);
  };
  return made;
}

constexpr Field kFields[] = {
    color_of_both(),
    field<&Material::ambient>("ambient", {.text = "share of the ambient light",
                                          .range = at_least(0),
                                          .symbol = "ka",
                                          .later = kTexture}),
    field<&Material::diffuse>("diffuse", {.text = "share of light that leaves in all directions",
                                          .range = at_least(0),
                                          .symbol = "kd",
                                          .later = kTexture}),
    field<&Material::specular>("specular", {.text = "share of light in the highlight",
                                            .range = at_least(0),
                                            .symbol = "ks",
                                            .later = kTexture}),
    field<&Material::shininess>("shininess", {.text = "the highlight's exponent",
                                              .range = at_least(0),
                                              .symbol = "n",
                                              .later = kTexture}),
    only("highlight", "phong", "the highlight's formula, (R·V)^n"),
    field<&Material::reflection>("reflection", {.text = "share of the reflected ray",
                                                .range = at_least(0),
                                                .symbol = "k1",
                                                .later = "a colour or a texture"}),
    field<&Material::refraction>("refraction", {.text = "share of the refracted ray",
                                                .range = at_least(0),
                                                .symbol = "k2",
                                                .later = "a colour or a texture"}),
    field<&Material::ior>(
        "ior", {.text = "index of refraction of the inside; with the profile lab, n1/n2 on entry",
                .range = greater_than(0),
                .symbol = "ni"}),
    only("fresnel", "off", "how the angle moves light from refraction to reflection"),
    only("absorption", 0, "what the inside swallows, per unit of length"),
    only("priority", 0, "which body counts where two overlap"),
    not_built("dispersion", "how the index depends on the wavelength"),
    not_built("glass", "the name of a glass, for its index"),
    not_built("bump", "a texture that bends the normal by its height"),
    not_built("normal_map", "a texture of normals"),
};
constexpr Table kTable = table_of<Material>("material",
                                            "What a surface does with light. A shape that names "
                                            "none has the material default, which is grey "
                                            "where the file does not say what it is.",
                                            kFields);

void read(const toml::Node& node, Input& input) {
  Material material;
  read_fields(node, kTable, fmt::format("material {}", key_of(node.key)), &material,
              input.problems);
  const auto index = static_cast<std::uint32_t>(input.scene.materials.size());
  input.materials.emplace(node.key, index);
  input.scene.material_names.emplace(index, node.key);
  input.scene.materials.push_back(material);
}

void write(Output& output) {
  for (std::size_t i = 0; i < output.scene.materials.size(); ++i) {
    const std::string key = key_of(output.materials[i]);
    write_table(fmt::format("[material.{}]", key), true, kTable, fmt::format("material {}", key),
                &output.scene.materials[i], output.text);
  }
}

}  // namespace

constexpr Section section::material = {.key = "material",
                                       .form = Section::Form::named,
                                       .text = kTable.text,
                                       .table = &kTable,
                                       .read = read,
                                       .write = write};

}  // namespace zraka::language
