// SPDX-License-Identifier: Apache-2.0
#include "explain/shape_lookup.hpp"

#include <type_traits>

#include "scene/bounds_of.hpp"

namespace zraka {
namespace {

/// The index in ZRAKA_SHAPES.
template <class Shape>
constexpr std::int32_t kind_of() {
  std::int32_t kind = 0;
#define ZRAKA_IF(Type, plural)                            \
  if constexpr (std::is_same_v<Shape, Type>) return kind; \
  ++kind;
  ZRAKA_SHAPES(ZRAKA_IF)
#undef ZRAKA_IF
  return kind;
}

/// Calls function(object) for the shape with this id.
template <class Function>
void with_object(const ShapeLists& shapes, const ShapeId& id, const Function& function) {
#define ZRAKA_IF(Type, plural)                                       \
  if (id.kind == kind_of<Type>() && id.index < shapes.plural.size()) \
    return function(shapes.plural[id.index]);
  ZRAKA_SHAPES(ZRAKA_IF)
#undef ZRAKA_IF
}

/// Ids count over all kinds.
ShapeId shape_with_id(const ShapeLists& shapes, std::int32_t id) {
  auto left = static_cast<std::size_t>(id);
  std::int32_t kind = 0;
#define ZRAKA_IF(Type, plural)                                                      \
  if (left < shapes.plural.size()) return {kind, static_cast<std::uint32_t>(left)}; \
  left -= shapes.plural.size();                                                     \
  ++kind;
  ZRAKA_SHAPES(ZRAKA_IF)
#undef ZRAKA_IF
  return {};
}

/// What people call a member: one that its file calls a sphere is an ellipsoid to the engine.
std::int32_t kind_of_member(const AnyBody& body) {
  return std::visit(
      []<class Shape>(const Shape& shape) {
        if constexpr (std::is_same_v<Shape, Ellipsoid>)
          if (shape.radii.x == shape.radii.y && shape.radii.y == shape.radii.z)
            return kind_of<Sphere>();
        if constexpr (std::is_same_v<Shape, std::monostate>)
          return 0;
        else
          return kind_of<Shape>();
      },
      body);
}

/// Counts down to the member that is looked for; true once it is there.
bool look_for(const Scene& scene, const Csg& csg, std::size_t& left, ExplainedMember& found) {
  for (std::size_t i = 0; i < csg.of.size(); ++i) {
    const CsgMember& member = csg.of[i];
    found.position.push_back(static_cast<std::uint32_t>(i + 1));
    if (const Csg* const inner = std::get_if<Csg>(&member.body)) {
      if (look_for(scene, *inner, left, found)) {
        found.transform = then(found.transform, transform_at(scene, member.transform));
        return true;
      }
    } else if (left-- == 0) {
      found.operation = csg.operation;
      found.operands = static_cast<std::uint32_t>(csg.of.size());
      found.kind = kind_of_member(member.body);
      found.name = member.name;
      found.transform = transform_at(scene, member.transform);
      return true;
    }
    found.position.pop_back();
  }
  return false;
}

}  // namespace

Transform transform_at(const Scene& scene, std::uint32_t index) {
  return index == 0 ? Transform() : scene.transforms[index - 1];
}

ShapeId shape_in_slot(const ShapeLists& shapes, const FrozenScene<float>& frozen,
                      std::int32_t slot) {
#define ZRAKA_IF(Type, plural)                                 \
  if (const std::int32_t at = slot - frozen.plural.first_slot; \
      at >= 0 && at < frozen.plural.count)                     \
    return shape_with_id(shapes, frozen.plural.id[at]);
  ZRAKA_KINDS(ZRAKA_IF)
#undef ZRAKA_IF
  return {};
}

NamedShape named(const ShapeLists& shapes, const ShapeId& id) {
  const auto name = shapes.names.find(id);
  return {id, name == shapes.names.end() ? std::string() : name->second};
}

std::uint32_t transform_of(const ShapeLists& shapes, const ShapeId& id) {
  std::uint32_t transform = 0;
  with_object(shapes, id, [&](const auto& object) { transform = object.transform; });
  return transform;
}

const Csg* csg_of(const ShapeLists& shapes, const ShapeId& id) {
  return id.kind == kind_of<Csg>() ? &shapes.csgs[id.index].shape : nullptr;
}

const Instance* instance_of(const ShapeLists& shapes, const ShapeId& id) {
  return id.kind == kind_of<Instance>() ? &shapes.instances[id.index].shape : nullptr;
}

ExplainedMember member_of(const Scene& scene, const Csg& csg, std::size_t i) {
  ExplainedMember found;
  look_for(scene, csg, i, found);
  return found;
}

}  // namespace zraka
