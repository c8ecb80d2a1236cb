// SPDX-License-Identifier: Apache-2.0
// Shapes as TOML.
#include <fmt/format.h>

#include "language/shapes.hpp"

namespace zraka::language {
namespace {

std::optional<Transform> transform_at(std::uint32_t index, Output& output) {
  const std::vector<Transform>& transforms = output.scene.transforms;
  if (index == 0) return std::nullopt;
  if (index <= transforms.size()) return transforms[index - 1];
  output.text.problems.push_back(fmt::format("transform {} of {}", index, transforms.size()));
  return std::nullopt;
}

std::optional<CornerUvs> uvs_at(std::size_t triangle, const std::vector<CornerUvs>& uvs) {
  return uvs.empty() || uvs[triangle] == kCornerUvs ? std::nullopt : std::optional(uvs[triangle]);
}

/// None where that is what a shape has which names none.
std::optional<std::string> material_at(std::uint32_t index, bool part, Output& output) {
  if (part && index == kMaterialOfWhole) return std::nullopt;
  if (index >= output.materials.size()) {
    output.text.problems.push_back(
        fmt::format("material {} of {}", index, output.materials.size()));
    return std::nullopt;
  }
  const std::string& name = output.materials[index];
  return !part && name == "default" ? std::nullopt : std::optional(name);
}

template <class Shape>
void write_all(const ShapeLists& shapes, const std::vector<Object<Shape>>& objects, ShapeList list,
               bool parts, const std::string& header, Output& output) {
  for (std::uint32_t i = 0; i < objects.size(); ++i) {
    ShapeOutput shape{output, header};
    shape.common.material = material_at(objects[i].material, parts, output);
    if (const auto name = shapes.names.find({list, i}); name != shapes.names.end())
      shape.common.name = name->second;
    (is_body<Shape> ? shape.common.transform : shape.texture_transform) =
        transform_at(objects[i].transform, output);
    if constexpr (std::is_same_v<Shape, Triangle>) shape.uvs = uvs_at(i, shapes.triangle_uvs);
    if constexpr (std::is_same_v<Shape, SmoothTriangle>)
      shape.uvs = uvs_at(i, shapes.smooth_triangle_uvs);
    write_shape(objects[i].shape, shape);
  }
}

}  // namespace

void ShapeOutput::write(const Kind& kind, const void* entry) {
  if (!header.empty()) {
    write_table(fmt::format("{}\nkind = {}", header, in_quotes(kind.name)), true,
                kShapeFamily.common, kind.table.name, &common, output.text);
    return write_fields(kind.table, kind.table.name, entry, output.text);
  }
  std::vector<std::string> pairs = {fmt::format("kind = {}", in_quotes(kind.name))};
  for (const Part& part :
       {Part{&kShapeFamily.common, &common}, Part{&kind.table, const_cast<void*>(entry)}})
    for (std::string& pair : pairs_of(*part.table, kind.table.name, part.object, output.text))
      pairs.push_back(std::move(pair));
  member = fmt::format("{{{}}}", fmt::join(pairs, ", "));
}

void write_shapes(const ShapeLists& shapes, bool parts, const std::string& header, Output& output) {
#define ZRAKA_WRITE(Type, plural) \
  write_all(shapes, shapes.plural, k##Type##List, parts, header, output);
  ZRAKA_SHAPES(ZRAKA_WRITE)
#undef ZRAKA_WRITE
}

std::string text_of(const CsgMember& member, Output& output) {
  ShapeOutput shape{output, ""};
  shape.common.material = material_at(member.material, true, output);
  shape.common.name = member.name;
  shape.common.transform = transform_at(member.transform, output);
  std::visit(
      [&]<class Shape>(const Shape& body) {
        if constexpr (!std::is_same_v<Shape, std::monostate>) write_shape(body, shape);
      },
      member.body);
  return std::move(shape.member);
}

}  // namespace zraka::language
