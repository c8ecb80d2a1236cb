// SPDX-License-Identifier: Apache-2.0
#include "language/shapes.hpp"

namespace zraka::language {
namespace {

constexpr Field kPlaneFields[] = {
    field<&Plane::point>("point", {.text = "a point of it", .unit = Unit::point, .required = true}),
    field<&Plane::normal>("normal",
                          {.text = "which way it faces; in CSG the half-space is behind it",
                           .unit = Unit::direction,
                           .required = true}),
};

void put(Plane& plane, Item& item) {
  add_shape(item, plane);
}

}  // namespace

constexpr Kind shape::plane = kind_of<Plane, put>(
    "plane", "plane", "A plane without end; in CSG the half-space behind it.", kPlaneFields, true);

void write_shape(const Plane& plane, ShapeOutput& output) {
  output.write(shape::plane, &plane);
}

}  // namespace zraka::language
