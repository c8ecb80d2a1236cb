// SPDX-License-Identifier: Apache-2.0
// libFuzzer's target for the files of meshes: any bytes are read or refused. The first tells of
// which kind they are.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "mesh/mesh.hpp"
#include "mesh/mtl.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  zraka::is_mesh(bytes);
  zraka::parse_mtl(bytes);
  const auto parse = data[0] % 4 == 0   ? zraka::parse_obj
                     : data[0] % 4 == 1 ? zraka::parse_ply
                     : data[0] % 4 == 2 ? zraka::parse_stl
                                        : zraka::parse_off;
  auto mesh = parse(bytes, "fuzz");
  if (!mesh) return 0;
  mesh->add_normals();
  for (const zraka::Mesh::Triangle& triangle : mesh->triangles)
    for (const zraka::Mesh::Corner& corner : triangle)
      if (corner.point >= mesh->points.size() || corner.normal >= mesh->normals.size() ||
          (corner.uv != zraka::Mesh::kNone && corner.uv >= mesh->uvs.size()))
        std::abort();
  return 0;
}
