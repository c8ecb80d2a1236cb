// SPDX-License-Identifier: Apache-2.0
// libFuzzer's target for glTF: any bytes are read or refused, and what is read holds together. No
// file is opened: there is no folder.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "formats/formats.hpp"
#include "whole_scene.hpp"

namespace {

void check(const zraka::ShapeLists& shapes, const zraka::Scene& scene) {
#define ZRAKA_CHECK(Type, plural)          \
  for (const auto& object : shapes.plural) \
    if (object.material >= scene.materials.size() && &shapes != &scene) std::abort();
  ZRAKA_PRIMITIVES(ZRAKA_CHECK)
#undef ZRAKA_CHECK
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  zraka::likeness_to_gltf(text);
  const auto read = zraka::parse_gltf(text, "fuzz");
  if (!read) {
    zraka::expect_reason(read.error());
    return 0;
  }
  const zraka::Scene& scene = read->scene;
  zraka::expect_whole(scene);
  for (const zraka::Group& group : scene.groups) check(group, scene);
  for (const auto& instance : scene.instances)
    if (instance.shape.group >= scene.groups.size() || instance.transform > scene.transforms.size())
      std::abort();
  return 0;
}
