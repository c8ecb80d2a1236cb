// SPDX-License-Identifier: Apache-2.0
// write_tachyon SCENE OUTPUT [WIDTH]: a scene for Tachyon to draw as zraka does, with five levels
// of rays. What Tachyon cannot say is told in docs/convert.md; cones become cylinders of their mean
// radius here, so that it has no more shapes to draw than we.
#include <utility>

#include "scene_writer.hpp"

namespace {

using namespace zraka;

Scene adapt(Scene scene) {
  for (Object<Cone>& cone : scene.cones) {
    const double mean = (cone.shape.base_radius + cone.shape.apex_radius) / 2;
    cone.shape.base_radius = cone.shape.apex_radius = mean;
  }
  for (Material& material : scene.materials) material.highlight = Highlight::blinn;
  scene.defaults.max_depth = 4;
  scene.defaults.sampling = {};
  return rivals::with_corners_for_middles(std::move(scene));
}

}  // namespace

int main(int argc, char** argv) {
  return rivals::translate_file(argc, argv, "tachyon", adapt);
}
