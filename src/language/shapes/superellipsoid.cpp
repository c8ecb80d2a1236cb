// SPDX-License-Identifier: Apache-2.0
#include "language/shapes.hpp"

namespace zraka::language {
namespace {

struct SuperellipsoidEntry {
  Vec3 center;
  Vec3 radii{1, 1, 1};
  std::array<double, 2> exponents{1, 1};
};

constexpr Field kSuperellipsoidFields[] = {
    field<&SuperellipsoidEntry::center>(
        "center", {.text = "its centre", .unit = Unit::point, .required = true}),
    field<&SuperellipsoidEntry::radii>("radii", {.text = "along x, y and z",
                                                 .unit = Unit::length,
                                                 .range = greater_than(0),
                                                 .required = true}),
    field<&SuperellipsoidEntry::exponents>(
        "exponents", {.text = "e, round z, and n, from pole to pole: near 0 a box, 1 an "
                              "ellipsoid, 2 an octahedron, above 2 pinched",
                      .range = from_to(0.05, 4),
                      .required = true}),
};

void put(SuperellipsoidEntry& s, Item& item) {
  add_shape(item, Superellipsoid{s.center, s.radii, s.exponents[0], s.exponents[1]});
}

}  // namespace

constexpr Kind shape::superellipsoid = kind_of<SuperellipsoidEntry, put>(
    "superellipsoid", "superellipsoid",
    "(|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) = 1 in units of the radii (Barr 1981).", kSuperellipsoidFields,
    true);

void write_shape(const Superellipsoid& s, ShapeOutput& output) {
  const SuperellipsoidEntry entry{s.center, s.radii, {s.e, s.n}};
  output.write(shape::superellipsoid, &entry);
}

}  // namespace zraka::language
