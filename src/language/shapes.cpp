// SPDX-License-Identifier: Apache-2.0
// Shapes of all kinds while they are read: their common fields, and the way into the scene.
#include "language/shapes.hpp"

#include <fmt/format.h>

#include "core/text.hpp"
#include "language/bake.hpp"
#include "language/transforms.hpp"
#include "scene/bounds_of.hpp"
#include "scene/check_shape.hpp"

namespace zraka::language {
namespace {

constexpr Field kCommonFields[] = {
    field<&CommonEntry::material>(
        "material", {.text = "its material; what names none has the material default, or, as a "
                             "part of a group or of CSG, that of the whole",
                     .unit = Unit::name_of_material}),
    field<&CommonEntry::name>("name", {.text = "what explain and influence call it"}),
    field<&CommonEntry::transform>(
        "transform", {.text = "where it is moved to, and how it is turned and scaled"}),
};

constexpr const Kind* kKinds[] = {
#define ZRAKA_ADDRESS(name) &shape::name,
    ZRAKA_SHAPE_KINDS(ZRAKA_ADDRESS)
#undef ZRAKA_ADDRESS
};

/// The index of a material by its name; the one called default need not be in the file.
std::uint32_t material_named(const std::string& name, const Item& item) {
  Input& input = item.input;
  if (const auto found = input.materials.find(name); found != input.materials.end())
    return found->second;
  if (name == "default") {
    const auto index = static_cast<std::uint32_t>(input.scene.materials.size());
    input.scene.materials.push_back({});
    input.scene.material_names.emplace(index, "default");
    input.materials.emplace("default", index);
    return index;
  }
  std::vector<std::string_view> known;
  if (!input.problems.enough())
    for (const auto& [index, each] : input.scene.material_names) known.push_back(each);
  if (const toml::Node* const node = item.node.find("material"))
    input.problems.unknown(node->begin, fmt::format("unknown material '{}'", shown(name)), name,
                           known, "materials");
  return 0;
}

void prepare(Item& item) {
  CommonEntry& common = common_of(item);
  common.material_index = !common.material && common.place.is_part()
                              ? kMaterialOfWhole
                              : material_named(common.material.value_or("default"), item);
}

/// By the name of its kind in the file.
void refuse(const Item& item, std::string_view problem) {
  const toml::Node* const kind = item.node.find("kind");
  item.input.problems.error(item.node.begin,
                            fmt::format("{}: {}", kind != nullptr ? kind->text : "", problem));
}

template <class Shape>
void put_into(ShapeLists& shapes, std::vector<Object<Shape>> ShapeLists::*list, ShapeList kind,
              const Shape& shape, std::uint32_t transform, const CommonEntry& common) {
  auto& objects = shapes.*list;
  if (!common.name.empty())
    shapes.names[{kind, static_cast<std::uint32_t>(objects.size())}] = common.name;
  objects.push_back({shape, common.material_index, transform});
}

template <class Body>
void add_body(Item& item, std::vector<Object<Body>> ShapeLists::*list, ShapeList kind,
              const Body& body) {
  CommonEntry& common = common_of(item);
  const Transform transform = transform_of(item);
  std::string problem = problem_of(body, transform);
  if (problem.empty() && common.place.members != nullptr) problem = problem_of_member(body);
  if (!problem.empty()) return refuse(item, problem);
  const std::uint32_t index = index_of(transform, item.input);
  if (common.place.members != nullptr)
    common.place.members->push_back({body, common.material_index, index, common.name});
  else
    put_into(*common.place.shapes, list, kind, body, index, common);
}

template <class Primitive>
void add_primitive(Item& item, std::vector<Object<Primitive>> ShapeLists::*list, ShapeList kind,
                   const Primitive& primitive, const std::optional<Transform>& of_textures) {
  CommonEntry& common = common_of(item);
  const Primitive moved = common.transform ? baked(primitive, *common.transform) : primitive;
  if (const std::string problem = problem_of(moved); !problem.empty()) return refuse(item, problem);
  Transform with_textures = transform_of(item);
  if (of_textures)
    with_textures = common.transform ? then(*of_textures, with_textures) : *of_textures;
  if (!is_readable(with_textures))
    return item.complain("texture_transform",
                         "texture_transform and transform together are too large or too small for "
                         "numbers");
  put_into(*common.place.shapes, list, kind, moved, index_of(with_textures, item.input), common);
}

}  // namespace

constexpr Family kShapeFamily = {
    .name = "shape",
    .default_kind = "",
    .kinds = kKinds,
    .common = table_of<CommonEntry>("shape", "What every shape has.", kCommonFields),
    .prepare = prepare};

void read_shape(const toml::Node& node, const Place& place, Input& input) {
  CommonEntry common;
  common.place = place;
  read_item(node, kShapeFamily, input, &common);
}

#define ZRAKA_ADD(Type, plural)                               \
  void add_shape(Item& item, const Type& body) {              \
    add_body(item, &ShapeLists::plural, k##Type##List, body); \
  }
ZRAKA_BODIES(ZRAKA_ADD)
#undef ZRAKA_ADD
#define ZRAKA_ADD(Type, plural)                                                                    \
  void add_shape(Item& item, const Type& primitive, const std::optional<Transform>& of_textures) { \
    add_primitive(item, &ShapeLists::plural, k##Type##List, primitive, of_textures);               \
  }
ZRAKA_PRIMITIVES(ZRAKA_ADD)
#undef ZRAKA_ADD

void add_uvs(std::vector<CornerUvs>& uvs, std::size_t triangles,
             const std::optional<CornerUvs>& of_last) {
  if (triangles == 0 || (uvs.empty() && !of_last)) return;
  uvs.resize(triangles, kCornerUvs);
  if (of_last) uvs.back() = *of_last;
}

void refuse_texture_transform(const Item& item, std::string_view what) {
  item.complain("texture_transform", fmt::format("texture_transform for {} is not built yet", what),
                "the texture's own transform moves it on all shapes");
}

}  // namespace zraka::language
