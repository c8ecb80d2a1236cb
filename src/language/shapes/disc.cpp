// SPDX-License-Identifier: Apache-2.0
#include "language/shapes.hpp"

namespace zraka::language {
namespace {

constexpr Field kDiscFields[] = {
    field<&Disc::center>("center", {.text = "its centre", .unit = Unit::point, .required = true}),
    field<&Disc::normal>("normal",
                         {.text = "which way it faces", .unit = Unit::direction, .required = true}),
    field<&Disc::radius>(
        "radius",
        {.text = "its radius", .unit = Unit::length, .range = greater_than(0), .required = true}),
    field<&Disc::inner_radius>("inner_radius",
                               {.text = "the radius of the hole in it, less than its own",
                                .unit = Unit::length,
                                .range = at_least(0)}),
};

void put(Disc& disc, Item& item) {
  add_shape(item, disc);
}

}  // namespace

constexpr Kind shape::disc =
    kind_of<Disc, put>("disc", "disc", "A disc or a ring, seen from both sides.", kDiscFields);

void write_shape(const Disc& disc, ShapeOutput& output) {
  output.write(shape::disc, &disc);
}

}  // namespace zraka::language
