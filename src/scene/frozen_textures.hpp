// SPDX-License-Identifier: Apache-2.0
// What textures need of a scene, beside its shapes.
#pragma once

#include <cstdint>
#include <zraka/textures.hpp>

namespace zraka {

class TextureSet;

/// The textures of one material.
struct MaterialTextures {
  const TextureUse* uses;
  std::int32_t use_count;
  NormalUse normals;
  bool sees_uv;         ///< some texture is laid over the surface, or bends its normals
  bool sees_footprint;  ///< some texture is a mean over what a pixel sees
  bool has_borders;     ///< roundings decide which side of a border of some texture counts
  bool of_children;     ///< some texture says what is reflected or goes through
  bool in_lanes;        ///< none is laid over the surface, and none bends normals (engine/texturing.hpp)
  bool any() const { return use_count > 0 || normals.kind != NormalUse::Kind::none; }
};

/// Of a scene in which some material has textures.
struct FrozenTextures {
  const TextureSet* set;
  const MaterialTextures* of_material;
  /// From the world, or from the space of a group, into that of a shape: by Object::transform - 1.
  const Transform* to_shape;
};

/// A triangle that was cut into pieces: its corners in the engine's frame.
struct WholeTriangle {
  std::int32_t index;  ///< among those of its kind, as it was read
  double corners[9];
};

/// What textures need of shapes of one kind, by their index as they were read.
struct FrozenMapping {
  const std::int32_t* transform;  ///< nullptr: none has one
  const CornerUvs* uvs;           ///< of triangles; nullptr: none has any
  const WholeTriangle* wholes;    ///< in the order of their indices
  std::int32_t whole_count;
};

}  // namespace zraka
