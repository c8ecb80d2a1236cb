// SPDX-License-Identifier: Apache-2.0
// [[cut]]: half-spaces that are taken away of what is drawn.
#include "language/sections.hpp"

namespace zraka::language {
namespace {

constexpr Field kCutFields[] = {
    field<&Cut::point>("point",
                       {.text = "a point of the plane", .unit = Unit::point, .required = true}),
    field<&Cut::normal>("normal",
                        {.text = "which way what is taken away lies", .unit = Unit::direction}),
    field<&Cut::caps>("caps", {.text = "whether closed bodies are solid: a cap of their material "
                                       "closes what is cut open"}),
    field<&Cut::eye_only>("eye_only", {.text = "whether mirrors, glass and shadows know nothing of "
                                               "it"}),
    field<&Cut::group>("group", {.text = "0: it cuts everything; else what has a material with "
                                         "this cut_group",
                                 .range = from_to(0, 4294967295.0)}),
};
constexpr Table kCutTable = table_of<Cut>(
    "cut", "Takes away what is on one side of a plane, so that the inside is seen.", kCutFields);

void read_cut(const toml::Node& node, Input& input) {
  Cut cut;
  read_fields(node, kCutTable, "cut", &cut, input);
  input.scene.cuts.push_back(cut);
}

void write_cut(Output& output) {
  for (const Cut& cut : output.scene.cuts)
    write_table("[[cut]]", true, kCutTable, "cut", &cut, output.text);
}

}  // namespace

constexpr Section section::cut = {.key = "cut",
                                  .form = Section::Form::list,
                                  .text = kCutTable.text,
                                  .table = &kCutTable,
                                  .read = read_cut,
                                  .write = write_cut};

}  // namespace zraka::language
