// SPDX-License-Identifier: Apache-2.0
// A mesh of triangles from a file.
#include "language/files.hpp"
#include "language/meshes.hpp"

namespace zraka::language {
namespace {

struct MeshEntry {
  std::string file;
  std::optional<bool> smooth;
};

constexpr Field kMeshFields[] = {
    field<&MeshEntry::file>(
        "file", {.text = "its triangles and polygons", .unit = Unit::mesh, .required = true}),
    field<&MeshEntry::smooth>(
        "smooth", {.text = "whether normals are blended between corners, those of the file or, "
                           "where it has none, means of those around; where nothing is said, as "
                           "the file has normals or not"}),
};

std::optional<std::uint32_t> read_group(const std::string& path, const MeshEntry& entry,
                                        Item& item) {
  Result<Mesh> mesh = read_mesh(path);
  if (!mesh) {
    tell(mesh.error(), *item.node.find("file"), "mesh", item.input);
    return std::nullopt;
  }
  const bool smooth = entry.smooth.value_or(!mesh->normals.empty());
  if (smooth) mesh->add_normals();
  return add_group(*mesh, smooth, item);
}

void put(MeshEntry& entry, Item& item) {
  const std::optional<std::string> path = path_of(*item.node.find("file"), "mesh", item.input);
  if (!path) return;
  const auto key = std::make_pair(*path, entry.smooth ? 1 + *entry.smooth : 0);
  const auto known = item.input.meshes.find(key);
  const std::optional<std::uint32_t> group =
      known != item.input.meshes.end() ? known->second : read_group(*path, entry, item);
  if (!group) return;
  item.input.meshes[key] = *group;
  add_instance(*group, item);
}

}  // namespace

constexpr Kind shape::mesh = kind_of<MeshEntry, put>(
    "mesh", "mesh", "Triangles from a file, which is read once however often it is named.",
    kMeshFields);

}  // namespace zraka::language
