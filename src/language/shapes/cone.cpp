// SPDX-License-Identifier: Apache-2.0
// The cone, the frustum and the cylinder.
#include <fmt/format.h>

#include "language/shapes.hpp"

namespace zraka::language {
namespace {

struct CylinderEntry {
  Vec3 base, top;
  double radius = 1;
  bool caps = true;
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
};

void refuse_caps(const Item& item, std::string_view kind) {
  item.complain("caps", fmt::format("the caps of {} are not built yet", kind),
                "caps = false draws the side alone");
}

void put(CylinderEntry& c, Item& item) {
  if (c.caps) return refuse_caps(item, "cylinder");
  add_shape(item, Cone{c.base, c.radius, c.top, c.radius});
}

struct ConeEntry {
  Vec3 base;
  double base_radius = 1;
  Vec3 top;
  double top_radius = 0;
  bool caps = true;
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
};

void put(ConeEntry& c, Item& item) {
  if (c.caps) return refuse_caps(item, "cone");
  add_shape(item, Cone{c.base, c.base_radius, c.top, c.top_radius});
}

}  // namespace

constexpr Kind shape::cylinder = kind_of<CylinderEntry, put>(
    "cylinder", "cylinder", "The side of a cylinder, seen from both sides.", kCylinderFields);
constexpr Kind shape::cone = kind_of<ConeEntry, put>(
    "cone", "cone", "The side of a cone or of a frustum, seen from both sides.", kConeFields);

void write_shape(const Cone& c, ShapeOutput& output) {
  if (c.base_radius == c.apex_radius) {
    const CylinderEntry entry{c.base, c.apex, c.base_radius, false};
    return output.write(shape::cylinder, &entry);
  }
  const ConeEntry entry{c.base, c.base_radius, c.apex, c.apex_radius, false};
  output.write(shape::cone, &entry);
}

}  // namespace zraka::language
