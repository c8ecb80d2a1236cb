// SPDX-License-Identifier: Apache-2.0
// [[light]].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "language/sections.hpp"
#include "scene/view.hpp"

namespace zraka::language {
namespace {

constexpr Field color() {
  return field<&Light::color>("color",
                              {.text = "its intensity", .range = at_least(0), .symbol = "Ii"});
}
constexpr Field attenuation() {
  return field<&Light::attenuation>(
      "attenuation", {.text = "at the distance d its light is divided by c + l·d + q·d²",
                      .unit = Unit::attenuation,
                      .range = at_least(0)});
}
constexpr Field position(std::string_view text, std::string_view also = {}) {
  return field<&Light::position>(
      "position", {.text = text, .unit = Unit::point, .required = true, .also = also});
}
constexpr Field direction(std::string_view text) {
  return field<&Light::direction>("direction", {.text = text, .unit = Unit::direction});
}
constexpr Field radius() {
  return field<&Light::radius>(
      "radius", {.text = "its radius", .unit = Unit::length, .range = greater_than(0)});
}
constexpr Field samples() {
  return field<&Light::samples>(
      "samples", {.text = "shadow rays to it from each point", .range = from_to(1, kMaxSamples)});
}

template <LightKind kind>
void put(Light& light, Item& item) {
  light.kind = kind;
  item.input.scene.lights.push_back(light);
}

constexpr Field kPointFields[] = {position("where it is"), color(), attenuation()};
constexpr Kind kPoint = kind_of<Light, put<LightKind::point>>(
    "point", "point light", "Shines from a point into all directions.", kPointFields);

constexpr Field kDirectionalFields[] = {direction("which way its rays go"), color()};
constexpr Kind kDirectional = kind_of<Light, put<LightKind::directional>>(
    "directional", "directional light",
    "Comes from so far that all its rays are parallel, like the sun's.", kDirectionalFields);

struct Spot : Light {
  std::optional<Vec3> target;
};

Vec3 minus(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

void put_spot(Spot& spot, Item& item) {
  if (spot.target && item.node.find("direction") != nullptr)
    return item.complain("direction", "spot light has target and direction: expected one of them");
  if (spot.target) spot.direction = minus(*spot.target, spot.position);
  if (spot.direction == Vec3{})
    return item.complain("target", "target of spot light is its position");
  const auto& [x, y, z] = spot.direction;
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
    return item.complain("target", "target of spot light is too far away for numbers");
  // What is not said makes room for what is.
  if (item.node.find("inner_deg") == nullptr)
    spot.inner_deg = std::min(spot.inner_deg, spot.outer_deg);
  if (item.node.find("outer_deg") == nullptr)
    spot.outer_deg = std::max(spot.inner_deg, spot.outer_deg);
  if (spot.inner_deg > spot.outer_deg)
    return item.complain(
        "inner_deg", fmt::format("inner_deg of spot light is {}, more than outer_deg, which is {}",
                                 spot.inner_deg, spot.outer_deg));
  put<LightKind::spot>(spot, item);
}

constexpr Field kSpotFields[] = {
    position("where it is"),
    field<&Spot::target>("target", {.text = "the point that it shines at", .unit = Unit::point}),
    direction("which way it shines, in the place of target"),
    field<&Light::inner_deg>(
        "inner_deg", {.text = "the angle from its axis up to which it shines in full, at most "
                              "outer_deg",
                      .unit = Unit::degrees,
                      .range = from_to(0, 180)}),
    field<&Light::outer_deg>(
        "outer_deg", {.text = "the angle from its axis beyond which it is dark, smooth between",
                      .unit = Unit::degrees,
                      .range = {0, 180, true, false}}),
    field<&Light::linear_edge>(
        "linear_edge",
        {.text = "between the two angles the light falls in proportion to the angle"}),
    color(),
    attenuation()};
constexpr Kind kSpot =
    kind_of<Spot, put_spot>("spot", "spot light", "Shines from a point into a cone.", kSpotFields);

void put_rectangle(Light& light, Item& item) {
  if (!spans_a_plane(light.edge_u, light.edge_v))
    return item.complain("edge_v", "edge_u and edge_v of rectangle light span no plane");
  put<LightKind::rectangle>(light, item);
}

constexpr Field kRectangleFields[] = {
    field<&Light::position>("corner",
                            {.text = "one of its corners", .unit = Unit::point, .required = true}),
    field<&Light::edge_u>("edge_u", {.text = "from there along one edge", .unit = Unit::direction}),
    field<&Light::edge_v>("edge_v",
                          {.text = "from there along the other edge", .unit = Unit::direction}),
    samples(),
    color(),
    attenuation()};
constexpr Kind kRectangle = kind_of<Light, put_rectangle>(
    "rectangle", "rectangle light", "A parallelogram that shines, and throws soft shadows.",
    kRectangleFields);

constexpr Field kDiscFields[] = {
    position("its centre", "center"),
    field<&Light::normal>("normal", {.text = "which way it faces", .unit = Unit::direction}),
    radius(),
    samples(),
    color(),
    attenuation()};
constexpr Kind kDisc = kind_of<Light, put<LightKind::disc>>(
    "disc", "disc light", "A disc that shines, and throws soft shadows.", kDiscFields);

constexpr Field kSphereFields[] = {position("its centre", "center"), radius(), samples(), color(),
                                   attenuation()};
constexpr Kind kSphere = kind_of<Light, put<LightKind::sphere>>(
    "sphere", "sphere light", "A ball that shines, and throws soft shadows.", kSphereFields);

/// In the order of LightKind.
constexpr const Kind* kLightKinds[] = {&kPoint, &kDirectional, &kSpot, &kRectangle, &kDisc, &kSphere};
constexpr Family kLightFamily = {"light", "point", kLightKinds};

void read_light(const toml::Node& node, Input& input) {
  read_item(node, kLightFamily, input);
}

/// With its target, if that leads back to the same direction, and else with that.
Spot entry_of(const Light& light) {
  Spot entry{light, {}};
  const Vec3 &p = light.position, &d = light.direction;
  const Vec3 target{p.x + d.x, p.y + d.y, p.z + d.z};
  if (light.kind != LightKind::spot || minus(target, p) != d) return entry;
  entry.target = target;
  entry.direction = Light{}.direction;
  return entry;
}

void write_light(Output& output) {
  for (const Light& light : output.scene.lights) {
    const Kind& kind = *kLightKinds[static_cast<std::size_t>(light.kind)];
    const std::string named =
        kind.name == kLightFamily.default_kind ? "" : fmt::format("\nkind = {}", in_quotes(kind.name));
    const Spot entry = entry_of(light);
    write_table("[[light]]" + named, true, kind.table, kind.table.name, &entry, output.text);
  }
}

}  // namespace

constexpr Section section::light = {.key = "light",
                                    .form = Section::Form::list,
                                    .text = "What the light comes from.",
                                    .family = &kLightFamily,
                                    .read = read_light,
                                    .write = write_light};

}  // namespace zraka::language
