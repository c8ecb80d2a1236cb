// SPDX-License-Identifier: Apache-2.0
// The textures of a scene, made ready once and looked up by all threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "textures/prepared_texture.hpp"

namespace zraka {

class TextureSet {
 public:
  TextureSet() = default;
  /// Keeps the images of the textures alive, and nothing else of them.
  explicit TextureSet(const std::vector<Texture>& textures);

  bool empty() const { return textures_.empty(); }

  /// What a texture, as its index in Scene::textures, gives at a point. Coordinates that are not
  /// finite count as 0, footprints that are not as very large.
  TextureValue value(std::uint32_t texture, const TexturePoint& at) const;
  /// The same, where others have been asked at this point: `known` is theirs, and of this point
  /// alone.
  TextureValue value(std::uint32_t texture, const TexturePoint& at, TextureLookup& known) const;

  /// How fast the mean of red, green and blue rises there: along x, y and z of the shape's space
  /// for a solid texture, along u, v and nothing for one over the surface. Measured across the
  /// footprint, or across a small part of the texture's size where that is more.
  V3<double> slope(std::uint32_t texture, const TexturePoint& at) const;

  /// All of them, by their indices.
  const PreparedTexture* all() const { return textures_.data(); }

  /// Whether it can be asked for many hits at a time (engine/texturing.hpp).
  bool in_lanes(std::uint32_t texture) const {
    return textures_[texture].mapping != TextureMapping::uv;
  }

  /// Whether what it gives depends on the footprint.
  bool sees_footprint(std::uint32_t texture) const { return textures_[texture].sees_footprint; }

  /// Whether it has borders, of which it depends on roundings what lies on which side.
  bool has_borders(std::uint32_t texture) const {
    return textures_[texture].kind != TextureKind::image;
  }

  TextureMapping mapping(std::uint32_t texture) const { return textures_[texture].mapping; }

  /// Memory of the smaller images.
  std::uint64_t bytes() const;

 private:
  std::vector<PreparedTexture> textures_;
};

}  // namespace zraka
