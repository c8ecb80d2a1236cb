// SPDX-License-Identifier: Apache-2.0
// write_povray SCENE OUTPUT [WIDTH]: a scene for POV-Ray 3.7 to draw as zraka does, with five
// levels of rays. What POV-Ray does otherwise is told in docs/convert.md.
#include <utility>

#include "scene_writer.hpp"

namespace {

using namespace zraka;

Scene adapt(Scene scene) {
  // Pictures that are compared pixel by pixel look through centres, as POV-Ray does.
  const bool corners = scene.defaults.profile != ProfileName::physical || scene.format == "NFF";
  scene.defaults.max_depth = 4;
  scene.defaults.min_contribution = 0;
  return corners ? rivals::with_corners_for_middles(std::move(scene)) : scene;
}

}  // namespace

int main(int argc, char** argv) {
  return rivals::translate_file(argc, argv, "povray", adapt);
}
