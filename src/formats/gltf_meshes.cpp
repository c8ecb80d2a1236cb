// SPDX-License-Identifier: Apache-2.0
#include "formats/gltf_meshes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_set>

#include "formats/painted.hpp"
#include "formats/vectors.hpp"
#include "scene/bounds_of.hpp"

namespace zraka {
namespace {

constexpr int kTriangles = 4, kStrip = 5, kFan = 6;

Vec3 vector_at(const GltfNumbers& numbers, std::size_t i) {
  const float* const v = numbers.at(i);
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

bool is_finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

/// A mesh may be named often, but what a file stands for has to do with its size.
bool GltfMeshes::may_add(std::uint64_t triangles) {
  constexpr std::uint64_t kAlways = 1'000'000;
  const std::uint64_t most = kAlways + file_.size() / 4;
  triangles_ += triangles;
  if (triangles_ <= most) return true;
  file_.fail(fmt::format("the file's meshes have more than {} triangles, more than {} bytes hold",
                         most, file_.size()));
  return false;
}

const GltfNumbers* GltfMeshes::attribute(const Json& attributes, const std::string& key,
                                         std::size_t count, std::size_t width,
                                         std::size_t other_width) {
  const std::optional<std::size_t> at = file_.index(&attributes, key, "accessors");
  const GltfNumbers* const numbers = at ? file_.accessor(*at, width, other_width) : nullptr;
  if (numbers == nullptr || numbers->count == count) return numbers;
  file_.fail(fmt::format("accessor {} has {} elements for {} points: {}", *at, numbers->count,
                         count, key));
  return nullptr;
}

/// Shapes that are blended to others by weights.
void GltfMeshes::morph(const Json& mesh, const Json& primitive, const GltfPose& pose,
                       Vertices& vertices) {
  const Json::Array& targets = file_.list(&primitive, "targets");
  std::vector<double> weights = pose.weights;
  if (weights.empty())
    for (const Json& weight : file_.list(&mesh, "weights")) {
      double value = 0;
      if (weight.get_number(value)) weights.push_back(value);
    }
  for (std::size_t t = 0; t < std::min(targets.size(), weights.size()); ++t) {
    if (weights[t] == 0) continue;
    const auto add = [&](const char* key, std::vector<Vec3>& to) {
      const GltfNumbers* const by = attribute(targets[t], key, vertices.count(), 3);
      for (std::size_t i = 0; by != nullptr && i < to.size(); ++i)
        to[i] = to[i] + vector_at(*by, i) * weights[t];
    };
    add("POSITION", vertices.points);
    add("NORMAL", vertices.normals);
  }
}

/// Each point follows up to four joints (linear blend skinning).
void GltfMeshes::move_by_joints(const Json& attributes, const GltfPose& pose, Vertices& vertices) {
  const std::size_t count = vertices.count();
  const GltfNumbers* const joints = attribute(attributes, "JOINTS_0", count, 4);
  const GltfNumbers* const weights = attribute(attributes, "WEIGHTS_0", count, 4);
  if (joints == nullptr || weights == nullptr) return;
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 point, normal;
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto weight = static_cast<double>(weights->at(i)[k]);
      const auto joint = static_cast<double>(joints->at(i)[k]);
      if (!(weight > 0)) continue;
      if (!(joint < static_cast<double>(pose.joints.size())))
        return file_.fail(fmt::format("JOINTS_0 names joint {}, of {}", joint, pose.joints.size()));
      const Transform& way = pose.joints[static_cast<std::size_t>(joint)];
      point = point + moved(vertices.points[i], way) * weight;
      if (!vertices.normals.empty()) normal = normal + turned(vertices.normals[i], way) * weight;
      sum += weight;
    }
    if (!(sum > 0)) continue;
    vertices.points[i] = point * (1 / sum);
    if (!vertices.normals.empty()) vertices.normals[i] = normal;
  }
}

std::optional<GltfMeshes::Vertices> GltfMeshes::vertices_of(const Json& mesh, const Json& primitive,
                                                            const GltfPose& pose) {
  const Json* const attributes = GltfFile::member(&primitive, "attributes");
  const std::optional<std::size_t> at = file_.index(attributes, "POSITION", "accessors");
  if (!at) return std::nullopt;
  const GltfNumbers* const points = file_.accessor(*at, 3);
  if (points == nullptr) return std::nullopt;
  Vertices vertices;
  vertices.points.reserve(points->count);
  for (std::size_t i = 0; i < points->count; ++i) vertices.points.push_back(vector_at(*points, i));
  if (const GltfNumbers* const normals = attribute(*attributes, "NORMAL", points->count, 3))
    for (std::size_t i = 0; i < points->count; ++i)
      vertices.normals.push_back(vector_at(*normals, i));
  vertices.colors = attribute(*attributes, "COLOR_0", points->count, 3, 4);
  morph(mesh, primitive, pose, vertices);
  if (!pose.joints.empty()) move_by_joints(*attributes, pose, vertices);
  if (!file_.good()) return std::nullopt;
  return vertices;
}

std::vector<GltfMeshes::Corners> GltfMeshes::triangles_of(const Json& primitive, std::size_t count,
                                                          int mode) {
  std::vector<std::uint32_t> order;
  std::uint64_t corners = count;
  const std::optional<std::size_t> at = file_.index(&primitive, "indices", "accessors");
  if (at) {
    const std::optional<std::vector<std::uint32_t>> indices = file_.indices(*at);
    if (!indices) return {};
    order = *indices;
    corners = order.size();
    for (const std::uint32_t index : order)
      if (index >= count) {
        file_.fail(fmt::format("accessor {} names point {}, of {}", *at, index, count));
        return {};
      }
  }
  if (!file_.good()) return {};
  const std::uint64_t triangles = mode == kTriangles ? corners / 3 : corners < 3 ? 0 : corners - 2;
  if (!may_add(triangles)) return {};
  if (mode == kTriangles && corners % 3 != 0)
    file_.warn("primitives whose corners are no multiple of three end with a part of a triangle");
  const auto corner = [&](std::uint64_t i) {
    return order.empty() ? static_cast<std::uint32_t>(i) : order[i];
  };
  std::vector<Corners> all;
  all.reserve(triangles);
  for (std::uint64_t i = 0; i < triangles; ++i)
    if (mode == kTriangles)
      all.push_back({corner(3 * i), corner(3 * i + 1), corner(3 * i + 2)});
    else if (mode == kStrip)
      all.push_back({corner(i), corner(i + 1 + i % 2), corner(i + 2 - i % 2)});
    else
      all.push_back({corner(i + 1), corner(i + 2), corner(0)});
  return all;
}

void GltfMeshes::add_triangle(const Vertices& vertices, const Corners& corners,
                              std::uint32_t material, const CornerUvs* uvs, Group& group) {
  const auto [i, j, k] = corners;
  const Vec3 &a = vertices.points[i], &b = vertices.points[j], &c = vertices.points[k];
  if (!is_finite(a) || !is_finite(b) || !is_finite(c))
    return file_.warn("triangles with corners that are not finite are left out");
  const auto is_normal = [&](std::uint32_t at) {
    const Vec3& n = vertices.normals[at];
    return is_finite(n) && n != Vec3{};
  };
  const bool is_smooth = !vertices.normals.empty() && is_normal(i) && is_normal(j) && is_normal(k);
  constexpr CornerUvs kUsual = {{{0, 0}, {1, 0}, {0, 1}}};
  const auto put = [&](auto& list, std::vector<CornerUvs>& own, const auto& shape) {
    list.push_back({shape, material});
    if (uvs == nullptr) return;
    own.resize(list.size() - 1, kUsual);
    own.push_back(*uvs);
  };
  if (is_smooth)
    put(group.smooth_triangles, group.smooth_triangle_uvs,
        SmoothTriangle{a, b, c, vertices.normals[i], vertices.normals[j], vertices.normals[k]});
  else
    put(group.triangles, group.triangle_uvs, Triangle{a, b, c});
}

void GltfMeshes::add_triangles(const Vertices& v, const std::vector<Corners>& all,
                               std::optional<std::size_t> material, Group& group) {
  Color color{1, 1, 1};
  bool is_painted = false;
  const auto color_at = [&](std::uint32_t i) {
    const float* const c = v.colors->at(i);
    const auto good = [](float value) {
      return std::isfinite(value) ? std::max(static_cast<double>(value), 0.0) : 0;
    };
    return Color{good(c[0]), good(c[1]), good(c[2])};
  };
  if (v.colors != nullptr && !all.empty()) {
    color = color_at(all[0][0]);
    for (const Corners& corners : all)
      for (const std::uint32_t i : corners) is_painted = is_painted || color_at(i) != color;
  }
  if (is_painted) {
    std::vector<float> colors;
    colors.reserve(9 * all.size());
    for (const Corners& corners : all)
      for (const std::uint32_t i : corners) {
        const Color c = color_at(i);
        for (const double value : {c.r, c.g, c.b}) colors.push_back(static_cast<float>(value));
      }
    std::vector<CornerUvs> uvs(all.size());
    const Texture texture =
        painted_texture(colors, [&](std::size_t i, const CornerUvs& corners) { uvs[i] = corners; });
    const std::uint32_t index = materials_.painted(material, texture);
    for (std::size_t i = 0; i < all.size(); ++i) add_triangle(v, all[i], index, &uvs[i], group);
    return;
  }
  const GltfMaterials::Look look = materials_.look(material, color);
  for (const Corners& corners : all) {
    CornerUvs uvs{};
    if (v.uvs != nullptr)
      for (std::size_t k = 0; k < 3; ++k) {
        const float* const uv = v.uvs->at(corners[k]);
        uvs[k] = {std::isfinite(uv[0]) ? uv[0] : 0, std::isfinite(uv[1]) ? 1 - uv[1] : 0};
      }
    add_triangle(v, corners, look.material, look.uv_set ? &uvs : nullptr, group);
  }
}

/// Points without bytes of their own, which an extension has.
bool GltfMeshes::is_packed(const Json& primitive) {
  if (GltfFile::extension(&primitive, "KHR_draco_mesh_compression") == nullptr) return false;
  const std::optional<std::size_t> at =
      file_.index(GltfFile::member(&primitive, "attributes"), "POSITION", "accessors");
  return !at || GltfFile::member(file_.item("accessors", *at), "bufferView") == nullptr;
}

/// Models for programs that hide the backs of faces may have each face twice, once for each side;
/// here all faces are seen from both, and one of the two is enough.
void GltfMeshes::drop_second_sides(const Vertices& vertices, std::vector<Corners>& all) {
  std::unordered_set<std::uint64_t> seen;
  const auto hash_of = [&](std::uint32_t i) {
    const Vec3& p = vertices.points[i];
    std::uint64_t hash = 0;
    for (const double part : {p.x, p.y, p.z}) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(part + 0.0)) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 29;
    }
    return hash;
  };
  std::erase_if(all, [&](const Corners& corners) {
    std::uint64_t sum = 0, mixed = 0;  // whatever the order
    for (const std::uint32_t i : corners) {
      const std::uint64_t hash = hash_of(i);
      sum += hash, mixed ^= hash * 0xD6E8FEB86659FD93u;
    }
    return !seen.insert(sum ^ mixed * 3).second;
  });
}

void GltfMeshes::read_primitive(const Json& mesh, const Json& primitive, const GltfPose& pose,
                                Group& group) {
  const double mode = file_.number(&primitive, "mode", kTriangles);
  if (mode != kTriangles && mode != kStrip && mode != kFan)
    return file_.warn("points and lines are left out");
  if (is_packed(primitive)) return file_.warn("meshes that Draco has packed are left out");
  std::optional<Vertices> vertices = vertices_of(mesh, primitive, pose);
  if (!vertices) {
    if (file_.good()) file_.warn("primitives without points are left out");
    return;
  }
  std::vector<Corners> all = triangles_of(primitive, vertices->count(), static_cast<int>(mode));
  if (all.empty()) return;
  const std::optional<std::size_t> material = file_.index(&primitive, "material", "materials");
  if (!material || !file_.flag(file_.item("materials", *material), "doubleSided", false))
    drop_second_sides(*vertices, all);
  const GltfMaterials::Look look = materials_.look(material, {1, 1, 1});
  if (look.uv_set)
    vertices->uvs = attribute(*GltfFile::member(&primitive, "attributes"),
                              fmt::format("TEXCOORD_{}", *look.uv_set), vertices->count(), 2);
  if (file_.good()) add_triangles(*vertices, all, material, group);
}

std::optional<std::uint32_t> GltfMeshes::posed(std::size_t index, const GltfPose& pose) {
  const Json& mesh = *file_.item("meshes", index);
  Group group;
  group.name = file_.word(&mesh, "name", "");
  for (const Json& primitive : file_.list(&mesh, "primitives")) {
    read_primitive(mesh, primitive, pose, group);
    if (!file_.good()) return std::nullopt;
  }
  if (group.shape_count() == 0) return std::nullopt;
  constexpr CornerUvs kUsual = {{{0, 0}, {1, 0}, {0, 1}}};
  if (!group.triangle_uvs.empty()) group.triangle_uvs.resize(group.triangles.size(), kUsual);
  if (!group.smooth_triangle_uvs.empty())
    group.smooth_triangle_uvs.resize(group.smooth_triangles.size(), kUsual);
  scene_.groups.push_back(std::move(group));
  return static_cast<std::uint32_t>(scene_.groups.size() - 1);
}

std::optional<std::uint32_t> GltfMeshes::group(std::size_t index) {
  const auto known = groups_.find(index);
  if (known != groups_.end()) return known->second;
  return groups_.emplace(index, posed(index, {})).first->second;
}

}  // namespace zraka
