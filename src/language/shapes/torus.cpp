// SPDX-License-Identifier: Apache-2.0
#include "language/shapes.hpp"

namespace zraka::language {
namespace {

constexpr Field kTorusFields[] = {
    field<&Torus::center>("center", {.text = "its centre", .unit = Unit::point, .required = true}),
    field<&Torus::normal>("normal", {.text = "the direction of its axis", .unit = Unit::direction}),
    field<&Torus::radius>("radius", {.text = "from the centre to the middle of the tube",
                                     .unit = Unit::length,
                                     .range = greater_than(0),
                                     .required = true}),
    field<&Torus::tube_radius>("tube_radius", {.text = "the radius of the tube, at most the other",
                                               .unit = Unit::length,
                                               .range = greater_than(0),
                                               .required = true}),
};

void put(Torus& torus, Item& item) {
  add_shape(item, torus);
}

}  // namespace

constexpr Kind shape::torus = kind_of<Torus, put>("torus", "torus", "A torus.", kTorusFields, true);

void write_shape(const Torus& torus, ShapeOutput& output) {
  output.write(shape::torus, &torus);
}

}  // namespace zraka::language
