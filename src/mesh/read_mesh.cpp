// SPDX-License-Identifier: Apache-2.0
// The list of formats of meshes.
#include <fmt/format.h>

#include <algorithm>

#include "core/file.hpp"
#include "mesh/mesh.hpp"

namespace zraka {
namespace {

struct MeshFormat {
  std::string_view ending;
  Result<Mesh> (*parse)(std::string_view bytes, const std::string& name);
};
constexpr MeshFormat kFormats[] = {{".obj", parse_obj}, {".ply", parse_ply}, {".stl", parse_stl}};
constexpr std::string_view kNotBuilt[] = {".gltf", ".glb"};

constexpr std::uint64_t kLargest = std::uint64_t{1} << 33;

std::string lower(std::string_view text) {
  std::string small(text);
  for (char& c : small) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return small;
}

}  // namespace

Result<Mesh> read_mesh(const std::string& path) {
  const std::string name = lower(path);
  for (const std::string_view ending : kNotBuilt)
    if (name.ends_with(ending))
      return failure(path, fmt::format("meshes of {} files are not built yet", ending),
                     "most programs that write them write .obj or .ply, too");
  for (const MeshFormat& format : kFormats) {
    if (!name.ends_with(format.ending)) continue;
    const Result<std::string> bytes = read_file(path, kLargest);
    if (!bytes) return tl::make_unexpected(bytes.error());
    return format.parse(*bytes, path);
  }
  return failure(path, "its name ends like that of no mesh: expected .obj, .ply or .stl");
}

}  // namespace zraka
