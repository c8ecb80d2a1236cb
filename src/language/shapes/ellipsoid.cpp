// SPDX-License-Identifier: Apache-2.0
#include "language/shapes.hpp"

namespace zraka::language {
namespace {

constexpr Field kEllipsoidFields[] = {
    field<&Ellipsoid::center>("center",
                              {.text = "its centre", .unit = Unit::point, .required = true}),
    field<&Ellipsoid::radii>("radii", {.text = "along x, y and z",
                                       .unit = Unit::length,
                                       .range = greater_than(0),
                                       .required = true}),
};

void put(Ellipsoid& ellipsoid, Item& item) {
  add_shape(item, ellipsoid);
}

}  // namespace

constexpr Kind shape::ellipsoid =
    kind_of<Ellipsoid, put>("ellipsoid", "ellipsoid", "An ellipsoid.", kEllipsoidFields, true);

void write_shape(const Ellipsoid& ellipsoid, ShapeOutput& output) {
  output.write(shape::ellipsoid, &ellipsoid);
}

}  // namespace zraka::language
