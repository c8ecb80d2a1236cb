// SPDX-License-Identifier: Apache-2.0
#include "language/shapes.hpp"

namespace zraka::language {
namespace {

constexpr Field kQuadricFields[] = {
    field<&Quadric::coefficients>(
        "coefficients", {.text = "of xx, yy, zz, xy, xz, yz, x, y, z and 1", .required = true}),
    field<&Quadric::min>(
        "min",
        {.text = "what lies outside of the box from here", .unit = Unit::point, .required = true}),
    field<&Quadric::max>("max",
                         {.text = "to here is not there", .unit = Unit::point, .required = true}),
};

void put(Quadric& quadric, Item& item) {
  add_shape(item, quadric);
}

}  // namespace

constexpr Kind shape::quadric = kind_of<Quadric, put>(
    "quadric", "quadric", "Where a polynomial of degree 2 is 0; in CSG where it is negative.",
    kQuadricFields, true);

void write_shape(const Quadric& quadric, ShapeOutput& output) {
  output.write(shape::quadric, &quadric);
}

}  // namespace zraka::language
