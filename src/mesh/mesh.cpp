// SPDX-License-Identifier: Apache-2.0
#include "mesh/mesh.hpp"

#include <utility>

#include "math/vec.hpp"
#include "scene/polygon.hpp"
#include "shapes/bodies/body.hpp"

namespace zraka {
namespace {

/// Twice the area long.
V3<double> normal_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  return cross(vector_of(b) - vector_of(a), vector_of(c) - vector_of(a));
}

/// Whether a quadrilateral is cut from its second corner to its fourth: where the other cut would
/// go outside, or is longer.
bool is_cut_from_second(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const bool first_good = dot(normal_of(a, b, c), normal_of(a, c, d)) > 0;
  const bool second_good = dot(normal_of(a, b, d), normal_of(b, c, d)) > 0;
  if (first_good != second_good) return second_good;
  const V3<double> ac = vector_of(c) - vector_of(a), bd = vector_of(d) - vector_of(b);
  return dot(bd, bd) < dot(ac, ac);
}

}  // namespace

void Mesh::add_face(const std::vector<Corner>& corners) {
  const auto point = [&](std::size_t i) -> const Vec3& { return points[corners[i].point]; };
  if (corners.size() == 3) {
    triangles.push_back({corners[0], corners[1], corners[2]});
  } else if (corners.size() == 4) {
    const std::size_t first = is_cut_from_second(point(0), point(1), point(2), point(3)) ? 1 : 0;
    for (const std::size_t i : {first, first + 2})
      triangles.push_back({corners[i], corners[(i + 1) % 4], corners[(i + 2) % 4]});
  } else {
    std::vector<Vec3> places;
    for (std::size_t i = 0; i < corners.size(); ++i) places.push_back(point(i));
    for (const auto& [a, b, c] : triangulate(places))
      triangles.push_back({corners[a], corners[b], corners[c]});
  }
}

void Mesh::add_normals() {
  std::vector<V3<double>> sums(points.size());
  for (const Triangle& t : triangles) {
    const V3<double> normal = normal_of(points[t[0].point], points[t[1].point], points[t[2].point]);
    for (const Corner& corner : t) sums[corner.point] = sums[corner.point] + normal;
  }
  const auto is_zero = [](const V3<double>& v) { return v.x == 0 && v.y == 0 && v.z == 0; };
  const auto add = [&](const V3<double>& v) {
    normals.push_back({v.x, v.y, v.z});
    return static_cast<std::uint32_t>(normals.size() - 1);
  };
  std::vector<std::uint32_t> means(points.size(), kNone);
  for (Triangle& t : triangles)
    for (Corner& corner : t) {
      if (corner.normal != kNone && !(normals[corner.normal] == Vec3{})) continue;
      std::uint32_t& mean = means[corner.point];
      if (mean == kNone && !is_zero(sums[corner.point])) mean = add(sums[corner.point]);
      corner.normal = mean;
      if (mean != kNone) continue;
      // Faces that cancel each other out: the face's own, if it has one.
      const V3<double> own = normal_of(points[t[0].point], points[t[1].point], points[t[2].point]);
      corner.normal = add(is_zero(own) ? V3<double>{0, 0, 1} : own);
    }
}

tl::unexpected<Diagnostics> mesh_failure(const std::string& name, std::size_t line,
                                         std::size_t column, std::string message) {
  Diagnostics problems;
  problems.push_back({.file = name, .line = line, .column = column, .message = std::move(message)});
  return tl::make_unexpected(std::move(problems));
}

}  // namespace zraka
