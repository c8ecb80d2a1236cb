// SPDX-License-Identifier: Apache-2.0
// [texture.NAME].
#include <fmt/format.h>

#include "language/sections.hpp"
#include "language/textures.hpp"

namespace zraka::language {
namespace {

void read_textures(const toml::Node& node, Input& input) {
  const std::uint32_t index = add_texture(node, input);
  input.textures.emplace(node.key, index);
  input.scene.texture_names.emplace(index, node.key);
}

void write_textures(Output& output) {
  for (std::size_t i = 0; i < output.scene.textures.size(); ++i) {
    const Texture& texture = output.scene.textures[i];
    const Kind& kind = *kTextureFamily.kinds[static_cast<std::size_t>(texture.kind)];
    write_table(fmt::format("[texture.{}]\nkind = {}", key_of(output.text.textures[i]),
                            in_quotes(kind.name)),
                true, kind.table, kind.table.name, &texture, output.text);
  }
}

}  // namespace

constexpr Section section::texture = {
    .key = "texture",
    .form = Section::Form::named,
    .text =
        "Colours, or numbers, that differ from point to point. Materials have them in the place "
        "of coefficients, by name or as a table: diffuse = {kind = \"checker\"}.",
    .family = &kTextureFamily,
    .read = read_textures,
    .write = write_textures};

}  // namespace zraka::language
