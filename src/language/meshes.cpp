// SPDX-License-Identifier: Apache-2.0
#include "language/meshes.hpp"

#include <fmt/format.h>

#include "scene/check_shape.hpp"

namespace zraka::language {
namespace {

class Builder {
 public:
  Builder(const Mesh& mesh, bool smooth) : mesh_(mesh), smooth_(smooth) {}

  /// "" where all is well.
  std::string build() {
    const std::size_t count = mesh_.triangles.size();
    smooth_ ? group_.smooth_triangles.reserve(count) : group_.triangles.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::string problem =
          smooth_ ? add(smooth_triangle(mesh_.triangles[i]), group_.smooth_triangles)
                  : add(flat_triangle(mesh_.triangles[i]), group_.triangles);
      if (!problem.empty()) return fmt::format("triangle {}: {}", i, problem);
    }
    if (!mesh_.uvs.empty()) add_uvs();
    return "";
  }
  Group&& take() { return std::move(group_); }

 private:
  template <class Shape>
  static std::string add(const Shape& shape, std::vector<Object<Shape>>& objects) {
    objects.push_back({shape, kMaterialOfWhole});
    return problem_of(shape);
  }

  const Vec3& point(const Mesh::Corner& corner) const { return mesh_.points[corner.point]; }
  const Vec3& normal(const Mesh::Corner& corner) const { return mesh_.normals[corner.normal]; }

  Triangle flat_triangle(const Mesh::Triangle& t) const {
    return {point(t[0]), point(t[1]), point(t[2])};
  }
  SmoothTriangle smooth_triangle(const Mesh::Triangle& t) const {
    return {point(t[0]), point(t[1]), point(t[2]), normal(t[0]), normal(t[1]), normal(t[2])};
  }

  void add_uvs() {
    std::vector<CornerUvs>& uvs = smooth_ ? group_.smooth_triangle_uvs : group_.triangle_uvs;
    uvs.reserve(mesh_.triangles.size());
    for (const Mesh::Triangle& t : mesh_.triangles) {
      uvs.push_back(kCornerUvs);
      for (std::size_t corner = 0; corner < 3; ++corner)
        if (t[corner].uv != Mesh::kNone) uvs.back()[corner] = mesh_.uvs[t[corner].uv];
    }
  }

  const Mesh& mesh_;
  bool smooth_;
  Group group_;
};

}  // namespace

std::optional<std::uint32_t> add_group(const Mesh& mesh, bool smooth, Item& item) {
  Builder builder(mesh, smooth);
  if (const std::string problem = builder.build(); !problem.empty()) {
    item.complain("file", problem);
    return std::nullopt;
  }
  std::vector<Group>& groups = item.input.scene.groups;
  groups.push_back(builder.take());
  return static_cast<std::uint32_t>(groups.size() - 1);
}

void add_instance(std::uint32_t group, Item& item) {
  item.input.group_uses.push_back({common_of(item).place.group, group, item.node.begin});
  add_shape(item, Instance{group});
}

}  // namespace zraka::language
