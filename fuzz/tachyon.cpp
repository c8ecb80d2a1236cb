// SPDX-License-Identifier: Apache-2.0
// libFuzzer's target for Tachyon's scenes: any bytes are read or refused, and what is read holds
// together. No file is opened: there is no folder.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "formats/formats.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  zraka::likeness_to_tachyon(text);
  const auto read = zraka::parse_tachyon_scene(text, "fuzz");
  if (!read) {
    if (read.error().empty()) std::abort();
    return 0;
  }
  const zraka::Scene& scene = read->scene;
  for (const zraka::Material& material : scene.materials)
    for (const zraka::TextureUse& use : material.textures)
      if (use.texture >= scene.textures.size()) std::abort();
#define ZRAKA_CHECK(Type, plural)         \
  for (const auto& object : scene.plural) \
    if (object.material >= scene.materials.size()) std::abort();
  ZRAKA_SHAPES(ZRAKA_CHECK)
#undef ZRAKA_CHECK
  if (!scene.smooth_triangle_uvs.empty() &&
      scene.smooth_triangle_uvs.size() != scene.smooth_triangles.size())
    std::abort();
  if (scene.resolution.width == 0 || scene.resolution.height == 0) std::abort();
  return 0;
}
