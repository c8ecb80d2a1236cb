// SPDX-License-Identifier: Apache-2.0
// The triangle, flat or smooth.
#include <optional>

#include "language/shapes.hpp"

namespace zraka::language {
namespace {

struct TriangleEntry {
  Vec3 a, b, c;
  std::optional<Points> normals;
  std::optional<CornerUvs> uvs;
  std::optional<Transform> texture_transform;
};

constexpr Field kTriangleFields[] = {
    field<&TriangleEntry::a>("a", {.text = "a corner", .unit = Unit::point, .required = true}),
    field<&TriangleEntry::b>("b", {.text = "a corner", .unit = Unit::point, .required = true}),
    field<&TriangleEntry::c>("c", {.text = "a corner", .unit = Unit::point, .required = true}),
    field<&TriangleEntry::normals>(
        "normals", {.text = "normals of the corners, between which the surface's is blended; which "
                            "side they point to is outside",
                    .unit = Unit::direction,
                    .fewest = 3,
                    .most = 3}),
    field<&TriangleEntry::uvs>("uvs",
                               {.text = "[u, v] of each corner, else [0, 0], [1, 0] and [0, 1]"}),
    texture_transform_field<TriangleEntry>(),
};

void put(TriangleEntry& t, Item& item) {
  ShapeLists& shapes = *common_of(item).place.shapes;
  if (!t.normals) {
    add_shape(item, Triangle{t.a, t.b, t.c}, t.texture_transform);
    return add_uvs(shapes.triangle_uvs, shapes.triangles.size(), t.uvs);
  }
  const Points& n = *t.normals;
  add_shape(item, SmoothTriangle{t.a, t.b, t.c, n[0], n[1], n[2]}, t.texture_transform);
  add_uvs(shapes.smooth_triangle_uvs, shapes.smooth_triangles.size(), t.uvs);
}

}  // namespace

constexpr Kind shape::triangle = kind_of<TriangleEntry, put>(
    "triangle", "triangle", "A triangle, seen from both sides.", kTriangleFields);

void write_shape(const Triangle& t, ShapeOutput& output) {
  const TriangleEntry entry{t.a, t.b, t.c, {}, output.uvs, output.texture_transform};
  output.write(shape::triangle, &entry);
}

void write_shape(const SmoothTriangle& t, ShapeOutput& output) {
  const TriangleEntry entry{t.a,        t.b,
                            t.c,        Points{t.normal_a, t.normal_b, t.normal_c},
                            output.uvs, output.texture_transform};
  output.write(shape::triangle, &entry);
}

}  // namespace zraka::language
