// SPDX-License-Identifier: Apache-2.0
// The list of kinds of shapes that a file may have, and what the file of a kind works with.
#pragma once

#include <fmt/format.h>

#include <utility>
#include <vector>
#include <zraka/scene.hpp>

#include "language/section.hpp"
#include "scene/check_shape.hpp"

/// X(name): every kind, in shapes/; cylinders are in cone.cpp.
#define ZRAKA_SHAPE_KINDS(X) \
  X(sphere)                  \
  X(cylinder)                \
  X(cone)                    \
  X(triangle)                \
  X(polygon)

namespace zraka::language {

/// Kinds of the language that are not built yet.
inline constexpr std::string_view kShapesNotBuilt[] = {
    "ellipsoid", "box",   "plane",        "parallelogram",  "disc",
    "capsule",   "torus", "quadric",      "superellipsoid", "height_field",
    "mesh",      "union", "intersection", "difference",     "instance"};

namespace shape {
#define ZRAKA_DECLARE(name) extern const Kind name;
ZRAKA_SHAPE_KINDS(ZRAKA_DECLARE)
#undef ZRAKA_DECLARE
}  // namespace shape

/// The places of the scene's lists of shapes in ShapeId::kind.
enum ShapeList {
#define ZRAKA_LIST(Type, plural) k##Type##List,
  ZRAKA_SHAPES(ZRAKA_LIST)
#undef ZRAKA_LIST
};

/// Puts a shape into the scene, with the item's material and name, if nothing is wrong with it.
template <class Shape>
void add_shape(Item& item, std::vector<Object<Shape>> ShapeLists::*list, ShapeList kind,
               const Shape& shape) {
  std::string problem;
  if constexpr (requires { ShapeTraits<Shape>::check(shape); }) problem = problem_of(shape);
  if (!problem.empty()) {
    item.input.problems.error(item.node.begin,
                              fmt::format("{}: {}", ShapeTraits<Shape>::kName, problem));
    return;
  }
  auto& objects = item.input.scene.*list;
  if (!item.name.empty())
    item.input.scene.names[{kind, static_cast<std::uint32_t>(objects.size())}] = item.name;
  objects.push_back({shape, item.material});
}
#define ZRAKA_ADD(Type, plural)                            \
  inline void add_shape(Item& item, const Type& shape) {   \
    add_shape(item, &ShapeLists::plural, k##Type##List, shape); \
  }
ZRAKA_SHAPES(ZRAKA_ADD)
#undef ZRAKA_ADD

/// One shape while it is written.
struct ShapeOutput {
  Output& output;
  std::string_view material, name;

  void write(const Kind& kind, const void* entry);
};

/// Writes a shape of the scene as one of a kind of the language's.
#define ZRAKA_DECLARE(Type, plural) void write_shape(const Type& shape, ShapeOutput& output);
ZRAKA_SHAPES(ZRAKA_DECLARE)
#undef ZRAKA_DECLARE

}  // namespace zraka::language
