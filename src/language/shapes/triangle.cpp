// SPDX-License-Identifier: Apache-2.0
// The triangle, flat or smooth.
#include <optional>

#include "language/shapes.hpp"

namespace zraka::language {
namespace {

struct TriangleEntry {
  Vec3 a, b, c;
  std::optional<Points> normals;
};

constexpr Field kFields[] = {
    field<&TriangleEntry::a>("a", {.text = "a corner", .unit = Unit::point, .required = true}),
    field<&TriangleEntry::b>("b", {.text = "a corner", .unit = Unit::point, .required = true}),
    field<&TriangleEntry::c>("c", {.text = "a corner", .unit = Unit::point, .required = true}),
    field<&TriangleEntry::normals>(
        "normals", {.text = "normals of the corners, between which the surface's is blended; which "
                            "side they point to is outside",
                    .unit = Unit::direction,
                    .fewest = 3,
                    .most = 3}),
    not_built("uvs", "[u, v] of each corner"),
};

void put(TriangleEntry& t, Item& item) {
  if (!t.normals) return add_shape(item, Triangle{t.a, t.b, t.c});
  const Points& n = *t.normals;
  add_shape(item, SmoothTriangle{t.a, t.b, t.c, n[0], n[1], n[2]});
}

}  // namespace

constexpr Kind shape::triangle = kind_of<TriangleEntry, put>(
    "triangle", "triangle", "A triangle, seen from both sides.", kFields);

void write_shape(const Triangle& t, ShapeOutput& output) {
  const TriangleEntry entry{t.a, t.b, t.c, {}};
  output.write(shape::triangle, &entry);
}

void write_shape(const SmoothTriangle& t, ShapeOutput& output) {
  const TriangleEntry entry{t.a, t.b, t.c, Points{t.normal_a, t.normal_b, t.normal_c}};
  output.write(shape::triangle, &entry);
}

}  // namespace zraka::language
