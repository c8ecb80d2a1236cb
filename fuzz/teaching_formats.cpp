// SPDX-License-Identifier: Apache-2.0
// libFuzzer's target for scenes of other courses: any bytes are read or refused. The first tells of
// which kind they are. No file is opened: there is no folder.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "formats/formats.hpp"
#include "whole_scene.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
  zraka::likeness_to_challenge(text);
  zraka::likeness_to_cse167(text);
  const auto read =
      data[0] % 2 == 0 ? zraka::parse_challenge(text, "fuzz") : zraka::parse_cse167(text, "fuzz");
  if (!read) {
    zraka::expect_reason(read.error());
    return 0;
  }
  const zraka::Scene& scene = read->scene;
  zraka::expect_whole(scene);
#define ZRAKA_CHECK(Type, plural)                                                                \
  for (const auto& object : scene.plural)                                                        \
    if (object.material >= scene.materials.size() || object.transform > scene.transforms.size()) \
      std::abort();
  ZRAKA_SHAPES(ZRAKA_CHECK)
#undef ZRAKA_CHECK
  return 0;
}
