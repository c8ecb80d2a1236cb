// SPDX-License-Identifier: Apache-2.0
#include "language/textures.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

#include "core/text.hpp"
#include "language/color.hpp"
#include "language/files.hpp"

namespace zraka::language {
namespace {

constexpr const Kind* kTextureKinds[] = {
#define ZRAKA_ADDRESS(kind) &texture::kind,
    ZRAKA_TEXTURES(ZRAKA_ADDRESS)
#undef ZRAKA_ADDRESS
};

void tell_unknown(const toml::Node& node, const Field& field, std::string_view what, Input& input) {
  std::vector<std::string_view> known;
  if (!input.problems.enough())
    for (const auto& [index, name] : input.scene.texture_names) known.push_back(name);
  std::string hint = input.problems.hint_at(node.text, known, "textures");
  if (field.kind == FieldKind::color && !hint.starts_with("did you mean")) {
    const std::string color = hint_at_color(node.text);
    hint =
        fmt::format("{}; {}", color.empty() ? "colours are [r, g, b] or \"#rrggbb\"" : color, hint);
  }
  input.problems.error(
      node.begin,
      fmt::format("unknown texture '{}' for {} of {}", shown(node.text), field.key, what),
      std::move(hint));
}

}  // namespace

constexpr Family kTextureFamily = {"texture", "", kTextureKinds};

std::uint32_t add_texture(const toml::Node& node, Input& input) {
  TextureEntry entry;
  read_item(node, kTextureFamily, input, &entry);
  const auto index = static_cast<std::uint32_t>(input.scene.textures.size());
  if (entry && entry->kind == TextureKind::image && node.find("transfer") == nullptr)
    input.open_transfers[index] = node.find("file");
  input.scene.textures.push_back(entry ? std::move(*entry) : Texture{});
  return index;
}

void make_normal_maps_linear(Input& input) {
  Scene& scene = input.scene;
  std::set<std::uint32_t> colors;
  for (const Material& material : scene.materials) {
    for (const TextureUse& use : material.textures) colors.insert(use.texture);
    if (material.normals.kind == NormalUse::Kind::bump) colors.insert(material.normals.texture);
  }
  if (scene.sky.kind == Sky::Kind::image) colors.insert(scene.sky.texture);
  std::map<std::uint32_t, std::uint32_t> linear;  // by the texture as it was read
  for (Material& material : scene.materials) {
    std::uint32_t& index = material.normals.texture;
    if (material.normals.kind != NormalUse::Kind::normal_map) continue;
    if (const auto made = linear.find(index); made != linear.end()) {
      index = made->second;
      continue;
    }
    const auto open = input.open_transfers.find(index);
    if (open == input.open_transfers.end()) continue;
    // One that gives colours, too, stays as it is.
    const std::uint32_t from = index;
    if (colors.contains(from)) {
      index = static_cast<std::uint32_t>(scene.textures.size());
      scene.textures.push_back(scene.textures[from]);
    }
    Texture& texture = scene.textures[index];
    texture.transfer = Transfer::linear;
    texture.image = read_picture(*open->second, "image texture", texture.transfer, input);
    linear[from] = index;
  }
}

std::optional<std::uint32_t> read_texture(const toml::Node& node, const Field& field,
                                          std::string_view what, Input& input) {
  if (node.kind == toml::Node::Kind::table) return add_texture(node, input);
  if (const auto found = input.textures.find(node.text); found != input.textures.end())
    return found->second;
  tell_unknown(node, field, what, input);
  return std::nullopt;
}

}  // namespace zraka::language
