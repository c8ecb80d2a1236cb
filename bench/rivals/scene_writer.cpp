// SPDX-License-Identifier: Apache-2.0
#include "scene_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace zraka::rivals {
namespace {

int fail(const Diagnostics& problems) {
  for (const Diagnostic& problem : problems) fmt::print(stderr, "{}", to_string(problem));
  return 1;
}

}  // namespace

Scene with_corners_for_middles(Scene scene) {
  const auto stretch = [](Vec3& side, std::uint32_t pixels) {
    const double more = (pixels + 1.0) / pixels;
    side = {side.x * more, side.y * more, side.z * more};
  };
  stretch(scene.camera.window_right, scene.resolution.width);
  stretch(scene.camera.window_up, scene.resolution.height);
  ++scene.resolution.width, ++scene.resolution.height;
  scene.defaults.profile = ProfileName::physical;
  return scene;
}

int translate_file(int argc, char** argv, const char* format, Scene (*adapt)(Scene scene)) {
  const int width = argc == 4 ? std::atoi(argv[3]) : 0;
  if (argc < 3 || argc > 4 || width < 0) {
    fmt::print(stderr, "usage: {} SCENE OUTPUT [WIDTH]\n", argv[0]);
    return 2;
  }
  Result<ReadScene> read = read_scene(argv[1]);
  if (!read) return fail(read.error());
  if (width > 0) {
    Resolution& r = read->scene.resolution;
    const auto columns = static_cast<std::uint32_t>(width);
    r = {columns, std::max(1u, columns * r.height / r.width)};
  }
  const Result<WrittenScene> translated = write_scene(adapt(std::move(read->scene)), format);
  if (!translated) return fail(translated.error());
  const Result<void> written = write_text_file(argv[2], translated->text);
  return written ? 0 : fail(written.error());
}

}  // namespace zraka::rivals
