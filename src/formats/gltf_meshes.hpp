// SPDX-License-Identifier: Apache-2.0
// glTF's meshes as groups of triangles, which nodes have instances of.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "formats/gltf_materials.hpp"

namespace zraka {

/// What a node does to its mesh's vertices, besides moving all.
struct GltfPose {
  std::vector<double> weights;    ///< of morph targets; empty: the mesh's own
  std::vector<Transform> joints;  ///< of a skin, into the world; empty: none
};

class GltfMeshes {
 public:
  GltfMeshes(GltfFile& file, GltfMaterials& materials, Scene& scene)
      : file_(file), materials_(materials), scene_(scene) {}

  /// The group of a mesh as it is, the same for all nodes that have it. None where there is nothing
  /// to draw.
  std::optional<std::uint32_t> group(std::size_t mesh);
  /// A group of its own for a pose.
  std::optional<std::uint32_t> posed(std::size_t mesh, const GltfPose& pose);

 private:
  struct Vertices {
    std::vector<Vec3> points, normals;  ///< normals: empty, or one for each point
    const GltfNumbers* uvs = nullptr;
    const GltfNumbers* colors = nullptr;
    std::size_t count() const { return points.size(); }
  };
  using Corners = std::array<std::uint32_t, 3>;

  void read_primitive(const Json& mesh, const Json& primitive, const GltfPose& pose, Group& group);
  std::optional<Vertices> vertices_of(const Json& mesh, const Json& primitive,
                                      const GltfPose& pose);
  void morph(const Json& mesh, const Json& primitive, const GltfPose& pose, Vertices& vertices);
  void move_by_joints(const Json& attributes, const GltfPose& pose, Vertices& vertices);
  const GltfNumbers* attribute(const Json& attributes, const std::string& key, std::size_t count,
                               std::size_t width, std::size_t other_width = 0);
  std::vector<Corners> triangles_of(const Json& primitive, std::size_t count, int mode);
  bool is_packed(const Json& primitive);
  static void drop_second_sides(const Vertices& vertices, std::vector<Corners>& all);
  void add_triangles(const Vertices& vertices, const std::vector<Corners>& all,
                     std::optional<std::size_t> material, Group& group);
  void add_triangle(const Vertices& vertices, const Corners& corners, std::uint32_t material,
                    const CornerUvs* uvs, Group& group);
  bool may_add(std::uint64_t triangles);

  GltfFile& file_;
  GltfMaterials& materials_;
  Scene& scene_;
  std::map<std::size_t, std::optional<std::uint32_t>> groups_;
  std::uint64_t triangles_ = 0;
};

}  // namespace zraka
