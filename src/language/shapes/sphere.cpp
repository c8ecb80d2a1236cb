// SPDX-License-Identifier: Apache-2.0
#include "language/shapes.hpp"

namespace zraka::language {
namespace {

constexpr Field kFields[] = {
    field<&Sphere::center>("center", {.text = "its centre", .unit = Unit::point, .required = true}),
    field<&Sphere::radius>(
        "radius",
        {.text = "its radius", .unit = Unit::length, .range = greater_than(0), .required = true}),
};

void put(Sphere& sphere, Item& item) {
  add_shape(item, sphere);
}

}  // namespace

constexpr Kind shape::sphere = kind_of<Sphere, put>("sphere", "sphere", "A sphere.", kFields);

void write_shape(const Sphere& sphere, ShapeOutput& output) {
  output.write(shape::sphere, &sphere);
}

}  // namespace zraka::language
