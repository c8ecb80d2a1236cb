// SPDX-License-Identifier: Apache-2.0
// What a ray has hit besides a shape's number: the instances on the way, the member of a CSG shape,
// the shape's own space, and what textures gave there.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>
#include <zraka/scene.hpp>

namespace zraka {

using Float3 = std::array<float, 3>;

/// A shape and the name that its file gives it; "" without one.
struct NamedShape {
  ShapeId id;
  std::string name;
};

/// An instance on the way to what a ray hits.
struct ExplainedInstance {
  NamedShape shape;         ///< numbered in the scene, or in the group of the instance before it
  std::uint32_t group = 0;  ///< that it shows, as its index in Scene::groups
  std::string group_name;
  Transform transform;  ///< from the group's space to where the instance stands
};

/// A member of a CSG shape that is no CSG shape itself.
struct ExplainedMember {
  std::vector<std::uint32_t> position;  ///< from 1: {1, 2} is the second member of the first
  CsgOperation operation{};             ///< that it is an operand of, with so many
  std::uint32_t operands = 0;
  std::int32_t kind = 0;  ///< index in ZRAKA_SHAPES
  std::string name;
  Transform transform;  ///< from the member's space to that of the whole
};

/// The way to a shape that stands in groups, and the part of a CSG shape: nothing of that for most.
struct ExplainedPath {
  std::vector<ExplainedInstance> instances{};  ///< the outermost first
  std::optional<NamedShape> inner{};           ///< in the group of the last of them
  std::optional<ExplainedMember> member{};     ///< whose surface it is
};

/// Where a ray goes into a member of a CSG shape, or comes out of it.
struct ExplainedCrossing {
  double distance = 0;     ///< from the ray's origin
  std::size_t member = 0;  ///< index in ExplainedCrossings::members
  bool enters = false;
  bool inside = false;  ///< the ray is within the whole behind it
};

/// At most so many are kept, the last before the hit and its own.
inline constexpr std::size_t kMostCrossingsKept = 32;

/// A ray's way through the members of a CSG shape, up to the hit.
struct ExplainedCrossings {
  bool starts_inside = false;              ///< the ray begins within the whole
  std::size_t left_out = 0;                ///< crossings before those that are here
  std::vector<ExplainedMember> members{};  ///< those that are crossed
  std::vector<ExplainedCrossing> all{};    ///< in the order of distance; the last is the hit
};

/// A hit in the space that its shape is described in.
struct OwnPlace {
  Vec3 point;
  /// Of the surface, and how wide the cone is there that holds what the pixel sees of it, in the
  /// world's units; where a texture was looked up.
  std::optional<std::array<double, 2>> uv{};
  std::optional<double> footprint{};
};

struct ExplainedTexture {
  std::uint32_t index = 0;  ///< in Scene::textures
  TextureKind kind{};
  std::string name;
};

/// A coefficient that a texture has given.
struct TexturedCoefficient {
  Coefficient coefficient{};
  ExplainedTexture texture;
  Float3 value{};  ///< as light takes it; of one number, three times that
};

/// A normal that a texture may have bent.
struct TexturedNormal {
  NormalUse::Kind kind{};
  ExplainedTexture texture;
  Float3 smooth{};  ///< N before
};

}  // namespace zraka
