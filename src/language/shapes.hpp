// SPDX-License-Identifier: Apache-2.0
// The list of kinds of shapes that a file may have, and what the file of a kind works with.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>
#include <zraka/scene.hpp>

#include "language/section.hpp"
#include "shapes/bodies.hpp"

/// X(name): every kind, in shapes/; some files have two.
#define ZRAKA_SHAPE_KINDS(X) \
  X(sphere)                  \
  X(ellipsoid)               \
  X(box)                     \
  X(plane)                   \
  X(parallelogram)           \
  X(disc)                    \
  X(cylinder)                \
  X(cone)                    \
  X(capsule)                 \
  X(torus)                   \
  X(quadric)                 \
  X(superellipsoid)          \
  X(triangle)                \
  X(polygon)                 \
  X(height_field)            \
  X(mesh)                    \
  X(particles)               \
  X(union_)                  \
  X(intersection)            \
  X(difference)              \
  X(instance)

namespace zraka::language {

namespace shape {
#define ZRAKA_DECLARE(name) extern const Kind name;
ZRAKA_SHAPE_KINDS(ZRAKA_DECLARE)
#undef ZRAKA_DECLARE
}  // namespace shape

/// The kinds, and what all of them have: a CommonEntry.
extern const Family kShapeFamily;

/// The places of the lists of shapes in ShapeId::kind.
enum ShapeList {
#define ZRAKA_LIST(Type, plural) k##Type##List,
  ZRAKA_SHAPES(ZRAKA_LIST)
#undef ZRAKA_LIST
};

/// Where shapes go while they are read: into the scene, or a group of it; or, as members, into CSG.
struct Place {
  ShapeLists* shapes = nullptr;
  std::vector<CsgMember>* members = nullptr;
  std::uint32_t group = GroupUse::kNoGroup;  ///< that shapes go into
  int depth = 0;                             ///< of members: how many CSG shapes they are in

  /// What names no material has that of the whole which it is a part of.
  bool is_part() const { return members != nullptr || group != GroupUse::kNoGroup; }
};

/// What people write of shapes of all kinds, and what it comes to.
struct CommonEntry {
  std::optional<std::string> material;
  std::string name;
  std::optional<Transform> transform;

  Place place{};
  std::uint32_t material_index = 0;
};
inline CommonEntry& common_of(const Item& item) {
  return *static_cast<CommonEntry*>(item.common);
}
inline Transform transform_of(const Item& item) {
  return common_of(item).transform.value_or(Transform{});
}

/// Reads a shape of any kind to where it goes.
void read_shape(const toml::Node& node, const Place& place, Input& input);

/// Puts a body to where the item goes, with its material, name and transform, if nothing is wrong
/// with it.
#define ZRAKA_ADD(Type, plural) void add_shape(Item& item, const Type& body);
ZRAKA_BODIES(ZRAKA_ADD)
#undef ZRAKA_ADD
/// The same for a primitive, which the transform moves, and which must not be a member. Its
/// textures and uv move with it, and before that by a transform of their own.
#define ZRAKA_ADD(Type, plural)                     \
  void add_shape(Item& item, const Type& primitive, \
                 const std::optional<Transform>& of_textures = {});
ZRAKA_PRIMITIVES(ZRAKA_ADD)
#undef ZRAKA_ADD
/// Texture coordinates of the triangle that was added last to these shapes.
void add_uvs(std::vector<CornerUvs>& uvs, std::size_t triangles,
             const std::optional<CornerUvs>& of_last);
/// Those of triangles that say nothing.
inline constexpr CornerUvs kCornerUvs = {{{0, 0}, {1, 0}, {0, 1}}};
/// `what` cannot have its textures moved for themselves.
void refuse_texture_transform(const Item& item, std::string_view what);

/// A field `texture_transform` of the shapes that become primitives.
template <class Entry>
constexpr Field texture_transform_field() {
  return field<&Entry::texture_transform>(
      "texture_transform", {.text = "where its textures and uv are moved to before the shape is"});
}

/// One shape while it is written: as lines of TOML, or, of a member, as an inline table.
struct ShapeOutput {
  Output& output;
  std::string header;  ///< [[shape]]; "" of a member
  CommonEntry common{};
  std::optional<Transform> texture_transform{};  ///< of primitives, which are moved already
  std::optional<CornerUvs> uvs{};                ///< of triangles
  std::string member{};                          ///< the inline table

  void write(const Kind& kind, const void* entry);
};

/// Writes all shapes of the scene or of a group, each below the header.
void write_shapes(const ShapeLists& shapes, bool parts, const std::string& header, Output& output);
/// As an inline table.
std::string text_of(const CsgMember& member, Output& output);

/// Writes a shape of the scene as one of a kind of the language's.
#define ZRAKA_DECLARE(Type, plural) void write_shape(const Type& shape, ShapeOutput& output);
ZRAKA_SHAPES(ZRAKA_DECLARE)
#undef ZRAKA_DECLARE

}  // namespace zraka::language
