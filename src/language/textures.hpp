// SPDX-License-Identifier: Apache-2.0
// Kinds of textures (the list is ZRAKA_TEXTURES), and textures where fields of materials name them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <zraka/textures.hpp>

#include "language/section.hpp"
#include "scene/check_bodies.hpp"

namespace zraka::language {

namespace texture {
#define ZRAKA_DECLARE(kind) extern const Kind kind;
ZRAKA_TEXTURES(ZRAKA_DECLARE)
#undef ZRAKA_DECLARE
}  // namespace texture

/// All of them; what is read is put into a TextureEntry.
extern const Family kTextureFamily;
using TextureEntry = std::optional<Texture>;

/// Reads a texture, and adds it to the scene; a placeholder where there is anything wrong with it.
std::uint32_t add_texture(const toml::Node& node, Input& input);

/// The texture that a field of `what` has in the place of a value: by its name, or as a table.
/// None, and the problem told, if it is neither.
std::optional<std::uint32_t> read_texture(const toml::Node& node, const Field& field,
                                          std::string_view what, Input& input);

/// Pictures of normals are no colours: where the file does not say how light became their numbers,
/// the numbers are taken as they are.
void make_normal_maps_linear(Input& input);

inline void as_it_is(Texture&) {}
inline void nothing_more(Texture&, Item&) {}

/// A kind of texture: `begin` says how one is where the file says nothing, `end` does what is left
/// when the fields have been read.
template <TextureKind kind, void (*begin)(Texture&) = as_it_is,
          void (*end)(Texture&, Item&) = nothing_more>
constexpr Kind texture_kind(std::string_view name, std::string_view called, std::string_view text,
                            std::span<const Field> fields) {
  const auto defaults = []() -> const void* {
    static const Texture texture = [] {
      Texture made;
      made.kind = kind;
      begin(made);
      return made;
    }();
    return &texture;
  };
  return {name, Table{called, text, fields, defaults}, [](const Kind& of, Item& item) {
            Texture made = *static_cast<const Texture*>(of.table.defaults());
            const std::size_t before = item.input.problems.errors();
            const Part part{&of.table, &made};
            read_fields(item.node, of.table.name, {&part, 1}, item.input, "kind");
            if (item.input.problems.errors() != before) return;
            end(made, item);
            *static_cast<TextureEntry*>(item.common) = std::move(made);
          }};
}

/// Fields that several kinds have.
namespace texture_fields {

inline constexpr Choice kMappings[] = {
    {"solid", "at the point in space, which the shape's transform moves"},
    {"uv", "at the surface's u and v"},
    {"cylinder", "rolled round the y axis: at the angle and the height of the point in space"},
    {"sphere", "rolled round the y axis: at the longitude and the latitude of the point in space"},
};
inline constexpr Choice kWraps[] = {
    {"repeat", "it once more"},
    {"clamp", "its edge"},
    {"mirror", "its mirror image, and so on in turns"},
};

constexpr Field colors(std::string_view text, std::size_t most = About{}.most) {
  return field<&Texture::colors>("colors",
                                 {.text = text, .range = at_least(0), .fewest = 2, .most = most});
}
constexpr Field size(std::string_view text) {
  return field<&Texture::size>("size",
                               {.text = text, .unit = Unit::length, .range = greater_than(0)});
}
constexpr Field direction(std::string_view text) {
  return field<&Texture::direction>("direction", {.text = text, .unit = Unit::direction});
}
constexpr Field turbulence() {
  return field<&Texture::turbulence>(
      "turbulence", {.text = "how far noise bends it, in sizes", .range = at_least(0)});
}
constexpr Field octaves() {
  return field<&Texture::octaves>(
      "octaves", {.text = "how many kinds of noise are added up, each of half the grain and half "
                          "the height before",
                  .range = from_to(1, kMostOctaves)});
}
constexpr Field seed() {
  return field<&Texture::seed>(
      "seed", {.text = "another one, another noise", .range = from_to(0, 4294967295.0)});
}
constexpr Field wrap(std::string_view text) {
  return field<&Texture::wrap>("wrap", {.text = text, .choices = kWraps});
}
constexpr Field mapping() {
  return field<&Texture::mapping>("mapping",
                                  {.text = "where it is looked up", .choices = kMappings});
}
constexpr Field repeat_u() {
  return field<&Texture::repeat_u>("repeat_u",
                                   {.text = "of cylinder and sphere: how often it goes round"});
}
constexpr Field repeat_v() {
  return field<&Texture::repeat_v>("repeat_v",
                                   {.text = "the same upwards: per unit, or from pole to pole"});
}
constexpr Field offset_u() {
  return field<&Texture::offset_u>("offset_u", {.text = "from how far on it goes round"});
}
constexpr Field offset_v() {
  return field<&Texture::offset_v>("offset_v", {.text = "the same upwards"});
}
constexpr Field transform() {
  return field<&Texture::transform>(
      "transform",
      {.text = "from the texture's space to the shape's, or to u and v, as transforms of shapes"});
}

}  // namespace texture_fields

}  // namespace zraka::language
