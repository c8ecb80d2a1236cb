// SPDX-License-Identifier: Apache-2.0
// The sphere; it is an ellipsoid where it is not round any more, and in CSG.
#include "language/shapes.hpp"
#include "scene/bounds_of.hpp"

namespace zraka::language {
namespace {

struct SphereEntry {
  Vec3 center;
  double radius = 1;
  std::optional<Transform> texture_transform;
};

constexpr Field kSphereFields[] = {
    field<&SphereEntry::center>("center",
                                {.text = "its centre", .unit = Unit::point, .required = true}),
    field<&SphereEntry::radius>(
        "radius",
        {.text = "its radius", .unit = Unit::length, .range = greater_than(0), .required = true}),
    texture_transform_field<SphereEntry>(),
};

void put(SphereEntry& s, Item& item) {
  const bool round = keeps_balls(transform_of(item));
  if (common_of(item).place.members == nullptr && round)
    return add_shape(item, Sphere{s.center, s.radius}, s.texture_transform);
  if (s.texture_transform)
    return refuse_texture_transform(
        item, round ? "a member of CSG" : "a sphere that its transform makes an ellipsoid");
  add_shape(item, Ellipsoid{s.center, {s.radius, s.radius, s.radius}});
}

}  // namespace

constexpr Kind shape::sphere =
    kind_of<SphereEntry, put>("sphere", "sphere", "A sphere.", kSphereFields, true);

void write_shape(const Sphere& s, ShapeOutput& output) {
  const SphereEntry entry{s.center, s.radius, output.texture_transform};
  output.write(shape::sphere, &entry);
}

}  // namespace zraka::language
