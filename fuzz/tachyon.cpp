// SPDX-License-Identifier: Apache-2.0
// libFuzzer's target for Tachyon's scenes: any bytes are read or refused, and what is read holds
// together. No file is opened: there is no folder.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "formats/formats.hpp"
#include "whole_scene.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  zraka::likeness_to_tachyon(text);
  const auto read = zraka::parse_tachyon_scene(text, "fuzz");
  if (!read) {
    zraka::expect_reason(read.error());
    return 0;
  }
  const zraka::Scene& scene = read->scene;
  zraka::expect_whole(scene);
#define ZRAKA_CHECK(Type, plural)         \
  for (const auto& object : scene.plural) \
    if (object.material >= scene.materials.size()) std::abort();
  ZRAKA_SHAPES(ZRAKA_CHECK)
#undef ZRAKA_CHECK
  return 0;
}
