// SPDX-License-Identifier: Apache-2.0
// [[shape]].
#include "language/sections.hpp"
#include "language/shapes.hpp"

namespace zraka::language {
namespace {

void read_shapes(const toml::Node& node, Input& input) {
  read_shape(node, {.shapes = &input.scene}, input);
}

void write_shapes(Output& output) {
  write_shapes(output.scene, false, "[[shape]]", output);
}

}  // namespace

constexpr Section section::shape = {.key = "shape",
                                    .form = Section::Form::list,
                                    .text = "What is seen.",
                                    .family = &kShapeFamily,
                                    .read = read_shapes,
                                    .write = write_shapes};

}  // namespace zraka::language
