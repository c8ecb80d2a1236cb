// SPDX-License-Identifier: Apache-2.0
// Meshes of triangles as files have them. The list of their formats is in read_mesh.cpp.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>
#include <zraka/diagnostic.hpp>
#include <zraka/values.hpp>

namespace zraka {

struct Mesh {
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  struct Corner {
    std::uint32_t point = 0, normal = kNone, uv = kNone;
  };
  using Triangle = std::array<Corner, 3>;

  std::vector<Vec3> points, normals;
  std::vector<std::array<float, 2>> uvs;
  std::vector<Triangle> triangles;
  /// Of each triangle, as an index into material_names, or kNone; empty where none has one.
  std::vector<std::uint32_t> materials;
  std::vector<std::string> material_names,
      material_files;  ///< of OBJ: what it uses, and where it is

  /// Adds a face as triangles; it may be concave. Corners have to exist.
  void add_face(const std::vector<Corner>& corners);
  /// Gives each corner without a normal, or with one that is 0, the mean of those of the faces
  /// around its point, larger faces counting more.
  void add_normals();
};

/// The most triangles, points or the like of a mesh.
inline constexpr std::uint64_t kMostInMesh = std::uint64_t{1} << 28;

/// Reads a file whose name ends in .obj, .ply, .stl or .off.
Result<Mesh> read_mesh(const std::string& path);
/// Whether a content, of which the first 64 KiB are enough but for a binary STL, or a file's name
/// is one of a mesh.
bool is_mesh(std::string_view text);
bool is_mesh_name(std::string_view name);
/// Of the kind that its content tells, or else its name.
Result<Mesh> parse_mesh(std::string_view bytes, const std::string& name);

/// Wavefront OBJ: v, vn, vt, f, usemtl and mtllib; what else there is, is passed over.
Result<Mesh> parse_obj(std::string_view text, const std::string& name);
/// PLY, text or binary of either order of bytes (Turk, "The PLY Polygon File Format", 1994).
Result<Mesh> parse_ply(std::string_view bytes, const std::string& name);
/// STL, text or binary. Points in the same place are one; normals of facets are passed over.
Result<Mesh> parse_stl(std::string_view bytes, const std::string& name);

/// OFF, text: corners and polygons, whose colours are passed over.
Result<Mesh> parse_off(std::string_view text, const std::string& name);

/// Whether it is no larger than a float may be.
inline bool fits_float(double value) {
  return std::fabs(value) <= static_cast<double>(std::numeric_limits<float>::max());
}

/// A failure at a line, and a column if that is known.
tl::unexpected<Diagnostics> mesh_failure(const std::string& name, std::size_t line,
                                         std::size_t column, std::string message);

}  // namespace zraka
