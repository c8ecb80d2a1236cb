// SPDX-License-Identifier: Apache-2.0
// What a writer of scenes provides. The list of writers is in writers.cpp.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <zraka/formats.hpp>

namespace zraka {

struct SceneWriter {
  const char* key;                          ///< for commands
  std::array<std::string_view, 2> endings;  ///< of its files' names
  Result<WrittenScene> (*write)(const Scene& scene);
};

/// All of them.
std::span<const SceneWriter> scene_writers();

Result<WrittenScene> write_nff(const Scene& scene);
Result<WrittenScene> write_toml_scene(const Scene& scene);
Result<WrittenScene> write_tachyon(const Scene& scene);
Result<WrittenScene> write_povray(const Scene& scene);
Result<WrittenScene> write_lab_scene(const Scene& scene);

}  // namespace zraka
