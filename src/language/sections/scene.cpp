// SPDX-License-Identifier: Apache-2.0
// [scene]: the light that comes from everywhere, and from nowhere.
#include "language/sections.hpp"

namespace zraka::language {
namespace {

constexpr Field kFields[] = {
    field<&Scene::ambient_light>(
        "ambient", {.text = "the light that is everywhere", .range = at_least(0), .symbol = "Ia"}),
    field<&Scene::background>("background", {.text = "the colour of rays that hit nothing",
                                             .range = at_least(0),
                                             .later = "a gradient or an image"}),
    not_built("ambient_occlusion", "how much less of the ambient light corners get"),
};
constexpr Table kTable =
    table_of<Scene>("scene", "The light that is everywhere, and the background.", kFields);

void read(const toml::Node& node, Input& input) {
  read_fields(node, kTable, "scene", &input.scene, input);
}

void write(Output& output) {
  write_table("[scene]", false, kTable, "scene", &output.scene, output.text);
}

}  // namespace

constexpr Section section::scene = {
    .key = "scene", .text = kTable.text, .table = &kTable, .read = read, .write = write};

}  // namespace zraka::language
