// SPDX-License-Identifier: Apache-2.0
// What a picture knows of its pixels besides their colours.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>
#include <zraka/api.hpp>

namespace zraka {

/// What can be known of a pixel: of what the ray through it hits first, and of its ray tree.
enum class Layer : std::uint8_t {
  depth,        ///< distance along the ray, in the scene's units; kNoDepth where nothing is hit
  position,     ///< the point, in the world
  normal,       ///< unit length, in the world, towards the viewer; not bent by textures
  uv,           ///< of the surface (docs/shapes.md)
  object_id,    ///< 1 + the index of the shape, counted over all kinds; 0 where nothing is hit
  material_id,  ///< 1 + the index in Scene::materials; 0 where nothing is hit
  rays,         ///< how many were traced for the pixel, of all kinds
  tree_depth,   ///< levels of rays after the first that its ray tree has
  cryptomatte   ///< object masks by name (Friedman and Jones, "Fully automatic ID mattes", 2015)
};

/// In the order of Layer: what people call them.
inline constexpr std::array<std::string_view, 9> kLayerNames = {
    "depth",       "position", "normal",     "uv",         "object-id",
    "material-id", "rays",     "tree-depth", "cryptomatte"};
ZRAKA_API std::optional<Layer> layer_named(std::string_view name);

/// What Layer::depth has where nothing is hit: Blender's, since infinity breaks its filters.
inline constexpr float kNoDepth = 1e10f;

class LayerSet {
 public:
  static LayerSet all() {
    LayerSet set;
    for (std::size_t i = 0; i < kLayerNames.size(); ++i) set.add(static_cast<Layer>(i));
    return set;
  }
  void add(Layer layer) { bits_ |= bit(layer); }
  bool has(Layer layer) const { return (bits_ & bit(layer)) != 0; }
  bool empty() const { return bits_ == 0; }
  friend bool operator==(LayerSet, LayerSet) = default;

 private:
  static std::uint32_t bit(Layer layer) { return std::uint32_t{1} << static_cast<int>(layer); }
  std::uint32_t bits_ = 0;
};

/// One value a pixel, row by row from the top. The name is the one that the channel has in OpenEXR:
///
///   A                        alpha: how much of the pixel shapes cover
///   Z                        Layer::depth
///   position.X …Y …Z, normal.X …Y …Z, uv.U …V
///   objectId.X, materialId.X, rays.X, treeDepth.X
///   CryptoObject00.R …G …B …A
///
/// R, G, B, A and Z without a layer are what OpenEXR's "Technical Introduction" reserves for
/// colour, opacity and depth; Blender takes them for its passes Combined and Depth, Nuke for rgba
/// and depth.Z. All others are LAYER.CHANNEL with a channel of one letter, since Blender passes
/// over most longer ones (imb_exr_split_channel_name() in its openexr_api.cpp), and with letters
/// and digits only, since Nuke makes underscores of the rest (ExrChannelNameToNuke.cpp in its NDK).
struct Channel {
  std::string name;
  std::variant<std::vector<float>, std::vector<std::uint32_t>> values;
  bool half = false;  ///< a float of which 16 bits are enough

  const std::vector<float>* floats() const { return std::get_if<std::vector<float>>(&values); }
  const std::vector<std::uint32_t>* ids() const {
    return std::get_if<std::vector<std::uint32_t>>(&values);
  }
};

/// Channels of a picture; without any, it has no size either.
struct Layers {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<Channel> channels;
  /// Strings that belong to channels, for OpenEXR's header: name and value.
  std::vector<std::pair<std::string, std::string>> notes;

  ZRAKA_API const Channel* find(std::string_view name) const;
  /// Channel A: one value a pixel, 0 transparent to 1 opaque; nullptr: all are opaque.
  ZRAKA_API const float* alpha() const;
};

}  // namespace zraka
