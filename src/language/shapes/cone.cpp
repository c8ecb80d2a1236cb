// SPDX-License-Identifier: Apache-2.0
// The cone, the frustum and the cylinder: with caps they are bodies; without,
// primitives as long as they are round.
#include <fmt/format.h>

#include "language/shapes.hpp"
#include "scene/bounds_of.hpp"

namespace zraka::language {
namespace {

struct CylinderEntry {
  Vec3 base, top;
  double radius = 1;
  bool caps = true;
  std::optional<Transform> texture_transform;
};

constexpr Field kCylinderFields[] = {
    field<&CylinderEntry::base>(
        "base", {.text = "the middle of one end", .unit = Unit::point, .required = true}),
    field<&CylinderEntry::top>(
        "top", {.text = "the middle of the other", .unit = Unit::point, .required = true}),
    field<&CylinderEntry::radius>(
        "radius",
        {.text = "its radius", .unit = Unit::length, .range = greater_than(0), .required = true}),
    field<&CylinderEntry::caps>("caps", {.text = "whether its ends are closed"}),
    texture_transform_field<CylinderEntry>(),
};

void put(const Frustum& f, const std::optional<Transform>& texture_transform, Item& item) {
  const bool round = keeps_balls(transform_of(item));
  const bool is_member = common_of(item).place.members != nullptr;
  if (is_member && !f.caps)
    return item.complain("caps", "without caps it is no closed body: CSG is of closed bodies");
  if (!f.caps && round)
    return add_shape(item, Cone{f.base, f.base_radius, f.top, f.top_radius}, texture_transform);
  if (texture_transform)
    return refuse_texture_transform(item,
                                    f.caps ? "what has caps" : "what its transform makes oval");
  add_shape(item, f);
}

void put(CylinderEntry& c, Item& item) {
  put(Frustum{c.base, c.radius, c.top, c.radius, c.caps}, c.texture_transform, item);
}

struct ConeEntry {
  Vec3 base;
  double base_radius = 1;
  Vec3 top;
  double top_radius = 0;
  bool caps = true;
  std::optional<Transform> texture_transform;
};

constexpr Field kConeFields[] = {
    field<&ConeEntry::base>(
        "base", {.text = "the middle of one end", .unit = Unit::point, .required = true}),
    field<&ConeEntry::base_radius>(
        "base_radius",
        {.text = "the radius there", .unit = Unit::length, .range = at_least(0), .required = true}),
    field<&ConeEntry::top>(
        "top", {.text = "the middle of the other end", .unit = Unit::point, .required = true}),
    field<&ConeEntry::top_radius>(
        "top_radius", {.text = "the radius there", .unit = Unit::length, .range = at_least(0)}),
    field<&ConeEntry::caps>("caps", {.text = "whether its ends are closed"}),
    texture_transform_field<ConeEntry>(),
};

void put(ConeEntry& c, Item& item) {
  put(Frustum{c.base, c.base_radius, c.top, c.top_radius, c.caps}, c.texture_transform, item);
}

}  // namespace

constexpr Kind shape::cylinder = kind_of<CylinderEntry, put>(
    "cylinder", "cylinder", "A cylinder; without caps its side alone, seen from both sides.",
    kCylinderFields, true);
constexpr Kind shape::cone = kind_of<ConeEntry, put>(
    "cone", "cone", "A cone or a frustum; without caps its side alone, seen from both sides.",
    kConeFields, true);

void write_shape(const Frustum& f, ShapeOutput& output) {
  if (f.base_radius == f.top_radius) {
    const CylinderEntry entry{f.base, f.top, f.base_radius, f.caps, output.texture_transform};
    return output.write(shape::cylinder, &entry);
  }
  const ConeEntry entry{f.base,       f.base_radius, f.top,
                        f.top_radius, f.caps,        output.texture_transform};
  output.write(shape::cone, &entry);
}

void write_shape(const Cone& c, ShapeOutput& output) {
  write_shape(Frustum{c.base, c.base_radius, c.apex, c.apex_radius, false}, output);
}

}  // namespace zraka::language
