// SPDX-License-Identifier: Apache-2.0
// [render]: how the picture is made, where the command line does not say it.
#include "language/sections.hpp"

namespace zraka::language {
namespace {

constexpr Choice kProfiles[] = {
    {"lab", "the course's rules, to the letter"},
    {"physical", "optics' rules"},
    {"spd", "the rules by which the Standard Procedural Databases count rays"},
};
constexpr Choice kShadows[] = {
    {"opaque", "whatever stands between a point and a light puts the point in shadow"},
    {"off", "there are none"},
    {"transparent", "what refracts lets light through", false},
};
constexpr Field kFields[] = {
    field<&RenderDefaults::profile>("profile",
                                    {.text = "the rules of light", .choices = kProfiles}),
    field<&RenderDefaults::max_depth>("max_depth",
                                      {.text = "levels of rays after those from the eye",
                                       .range = from_to(0, static_cast<double>(kMaxDepth))}),
    only("min_contribution", 0, "below which contribution to the pixel a ray is left out"),
    field<&RenderDefaults::shadows>("shadows",
                                    {.text = "what shadow rays do", .choices = kShadows}),
    only("samples", 1, "rays a pixel"),
    only("filter", "box", "how samples become a pixel"),
    only("wavelengths", 12, "into how many a ray splits that a dispersive body refracts"),
    only("seed", 0, "of random numbers"),
};
constexpr Table kTable =
    table_of<RenderDefaults>("render", "How the picture is made; the command line wins.", kFields);

void read(const toml::Node& node, Input& input) {
  read_fields(node, kTable, "render", &input.scene.defaults, input);
}

void write(Output& output) {
  write_table("[render]", false, kTable, "render", &output.scene.defaults, output.text);
}

}  // namespace

constexpr Section section::render = {
    .key = "render", .text = kTable.text, .table = &kTable, .read = read, .write = write};

}  // namespace zraka::language
