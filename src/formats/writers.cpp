// SPDX-License-Identifier: Apache-2.0
// The list of the formats that scenes are written in.
#include "formats/writers.hpp"

#include <fmt/format.h>

#include "core/text.hpp"

namespace zraka {
namespace {

constexpr SceneWriter kWriters[] = {
    {"nff", {".nff"}, write_nff},
    {"toml", {".toml"}, write_toml_scene},
    {"tachyon", {".dat", ".tachyon"}, write_tachyon},
    {"povray", {".pov"}, write_povray},
    {"lab", {".txt"}, write_lab_scene},
};

}  // namespace

std::span<const SceneWriter> scene_writers() {
  return kWriters;
}

Result<WrittenScene> write_scene(const Scene& scene, std::string_view format) {
  std::string keys;
  for (const SceneWriter& writer : kWriters) {
    if (format == writer.key) return writer.write(scene);
    for (const std::string_view ending : writer.endings)
      if (ends_with(format, ending)) return writer.write(scene);
    keys += fmt::format("{}{}", keys.empty() ? "" : ", ", writer.key);
  }
  return failure("", fmt::format("'{}' is no format that can be written", shown(format)),
                 fmt::format("formats: {}", keys));
}

}  // namespace zraka
