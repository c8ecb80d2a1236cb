// SPDX-License-Identifier: Apache-2.0
// libFuzzer's target for glTF: any bytes are read or refused, and what is read holds together. No
// file is opened: there is no folder.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "formats/formats.hpp"

namespace {

void check(const zraka::ShapeLists& shapes, const zraka::Scene& scene) {
#define ZRAKA_CHECK(Type, plural)          \
  for (const auto& object : shapes.plural) \
    if (object.material >= scene.materials.size() && &shapes != &scene) std::abort();
  ZRAKA_PRIMITIVES(ZRAKA_CHECK)
#undef ZRAKA_CHECK
  if (!shapes.triangle_uvs.empty() && shapes.triangle_uvs.size() != shapes.triangles.size())
    std::abort();
  if (!shapes.smooth_triangle_uvs.empty() &&
      shapes.smooth_triangle_uvs.size() != shapes.smooth_triangles.size())
    std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  zraka::likeness_to_gltf(text);
  const auto read = zraka::parse_gltf(text, "fuzz");
  if (!read) {
    if (read.error().empty()) std::abort();
    return 0;
  }
  const zraka::Scene& scene = read->scene;
  for (const zraka::Material& material : scene.materials)
    for (const zraka::TextureUse& use : material.textures)
      if (use.texture >= scene.textures.size()) std::abort();
  for (const zraka::Group& group : scene.groups) check(group, scene);
  for (const auto& instance : scene.instances)
    if (instance.shape.group >= scene.groups.size() || instance.transform > scene.transforms.size())
      std::abort();
  if (scene.resolution.width == 0 || scene.resolution.height == 0) std::abort();
  return 0;
}
