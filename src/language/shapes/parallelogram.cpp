// SPDX-License-Identifier: Apache-2.0
#include "language/shapes.hpp"

namespace zraka::language {
namespace {

constexpr Field kParallelogramFields[] = {
    field<&Parallelogram::corner>("corner",
                                  {.text = "a corner", .unit = Unit::point, .required = true}),
    field<&Parallelogram::edge_u>("edge_u", {.text = "from it to the next corner, where u is 1",
                                             .unit = Unit::direction,
                                             .required = true}),
    field<&Parallelogram::edge_v>("edge_v", {.text = "from it to the one before, where v is 1",
                                             .unit = Unit::direction,
                                             .required = true}),
};

void put(Parallelogram& parallelogram, Item& item) {
  add_shape(item, parallelogram);
}

}  // namespace

constexpr Kind shape::parallelogram = kind_of<Parallelogram, put>(
    "parallelogram", "parallelogram", "A parallelogram, seen from both sides.", kParallelogramFields);

void write_shape(const Parallelogram& parallelogram, ShapeOutput& output) {
  output.write(shape::parallelogram, &parallelogram);
}

}  // namespace zraka::language
