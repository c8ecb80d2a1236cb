// SPDX-License-Identifier: Apache-2.0
#include "language/shapes.hpp"

namespace zraka::language {
namespace {

constexpr Field kCapsuleFields[] = {
    field<&Capsule::base>("base",
                          {.text = "one end of the line", .unit = Unit::point, .required = true}),
    field<&Capsule::top>("top", {.text = "the other", .unit = Unit::point, .required = true}),
    field<&Capsule::radius>(
        "radius",
        {.text = "its radius", .unit = Unit::length, .range = greater_than(0), .required = true}),
};

void put(Capsule& capsule, Item& item) {
  add_shape(item, capsule);
}

}  // namespace

constexpr Kind shape::capsule = kind_of<Capsule, put>(
    "capsule", "capsule", "All points within a radius of a line.", kCapsuleFields, true);

void write_shape(const Capsule& capsule, ShapeOutput& output) {
  output.write(shape::capsule, &capsule);
}

}  // namespace zraka::language
