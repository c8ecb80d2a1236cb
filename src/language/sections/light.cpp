// SPDX-License-Identifier: Apache-2.0
// [[light]].
#include "language/sections.hpp"

namespace zraka::language {
namespace {

void put(Light& light, Item& item) {
  item.input.scene.lights.push_back(light);
}

constexpr Field kPointFields[] = {
    field<&Light::position>("position",
                                 {.text = "where it is", .unit = Unit::point, .required = true}),
    field<&Light::color>("color",
                              {.text = "its intensity", .range = at_least(0), .symbol = "Ii"}),
    only("attenuation", Vec3{1, 0, 0},
         "[c, l, q]: at the distance d the light is divided by c + l·d + q·d²"),
};
constexpr Kind kPoint = kind_of<Light, put>(
    "point", "point light", "Shines from a point into all directions.", kPointFields);
constexpr const Kind* kKinds[] = {&kPoint};
constexpr std::string_view kNotBuilt[] = {"directional", "spot", "rectangle", "disc", "sphere"};
constexpr Family kFamily = {"light", "point", kKinds, kNotBuilt};

void read(const toml::Node& node, Input& input) {
  read_item(node, kFamily, input);
}

void write(Output& output) {
  for (const Light& light : output.scene.lights)
    write_table("[[light]]", true, kPoint.table, kPoint.table.name, &light, output.text);
}

}  // namespace

constexpr Section section::light = {.key = "light",
                                    .form = Section::Form::list,
                                    .text = "What the light comes from.",
                                    .family = &kFamily,
                                    .read = read,
                                    .write = write};

}  // namespace zraka::language
