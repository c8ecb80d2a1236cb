// SPDX-License-Identifier: Apache-2.0
#include "core/scene_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "core/text.hpp"

namespace zraka {
namespace {

namespace fs = std::filesystem;

/// Without links, "." and "..", as far as there are such files; "" where the system does not say.
fs::path real_path(const fs::path& path) {
  std::error_code error;
  fs::path real = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? fs::path() : real;
}

bool is_inside(const fs::path& path, const fs::path& folder) {
  const fs::path real = real_path(path), real_folder = real_path(folder);
  if (real.empty() || real_folder.empty()) return false;
  return std::mismatch(real_folder.begin(), real_folder.end(), real.begin(), real.end()).first ==
         real_folder.end();
}

}  // namespace

Result<std::string> SceneFolder::path_of(const std::string& name) const {
  // The system would stop at a zero.
  if (name.empty() || name.find('\0') != std::string::npos)
    return failure({}, fmt::format("'{}' is no name of a file", shown(name)));
  // With its folder, no name is "-", which stands for the standard input.
  const fs::path from = folder.empty() ? fs::path(".") : fs::path(folder);
  const fs::path path = from / name;
  if (!allow_outside && !is_inside(path, from))
    return failure({}, fmt::format("'{}' lies outside of the scene's folder", shown(name)),
                   "put it beside the scene, or allow it with --allow-outside");
  return path.string();
}

}  // namespace zraka
