// SPDX-License-Identifier: Apache-2.0
// libFuzzer's target for the scene language: any bytes are read or refused, and what is read is
// written as a text that reads as the same.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "formats/formats.hpp"

namespace {

zraka::Result<zraka::ReadScene> read(std::string_view text) {
  return zraka::parse_toml(text, "fuzz");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  zraka::likeness_to_toml(text);
  const auto scene = read(text);
  if (!scene) return 0;
  const std::string written = zraka::write_toml(scene->scene).value();
  const auto again = read(written);
  if (!again || zraka::write_toml(again->scene).value() != written) std::abort();
  return 0;
}
