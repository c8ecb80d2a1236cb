// SPDX-License-Identifier: Apache-2.0
#include "language/shapes.hpp"

namespace zraka::language {
namespace {

constexpr Field kBoxFields[] = {
    field<&Box::min>(
        "min",
        {.text = "the corner where x, y and z are least", .unit = Unit::point, .required = true}),
    field<&Box::max>("max", {.text = "the corner opposite", .unit = Unit::point, .required = true}),
    field<&Box::radius>("radius", {.text = "of rounded edges, at most half the shortest side",
                                   .unit = Unit::length,
                                   .range = at_least(0)}),
};

void put(Box& box, Item& item) {
  add_shape(item, box);
}

}  // namespace

constexpr Kind shape::box =
    kind_of<Box, put>("box", "box", "A box whose sides are along the axes.", kBoxFields, true);

void write_shape(const Box& box, ShapeOutput& output) {
  output.write(shape::box, &box);
}

}  // namespace zraka::language
