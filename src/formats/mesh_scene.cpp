// SPDX-License-Identifier: Apache-2.0
// A scene for a mesh by itself (docs/gltf.md): a camera and lights that show all of it, and the
// materials of an OBJ.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/file.hpp"
#include "core/scene_folder.hpp"
#include "core/text.hpp"
#include "formats/formats.hpp"
#include "formats/framing.hpp"
#include "formats/vectors.hpp"
#include "image/scene_images.hpp"
#include "math/bounds.hpp"
#include "mesh/mesh.hpp"
#include "mesh/mtl.hpp"
#include "scene/check_shape.hpp"

namespace zraka {
namespace {

constexpr double kAmbient = 0.25;

class MeshScene {
 public:
  MeshScene(const std::string& name, const ReadOptions& options)
      : name_(name),
        options_(options),
        folder_{options.folder.value_or(""), options.allow_outside},
        images_(folder_) {}

  Result<ReadScene> build(Mesh mesh);

 private:
  void read_materials(const Mesh& mesh);
  void read_library(const std::string& file, std::map<std::string, MtlMaterial>& known);
  Material material_of(const MtlMaterial& mtl);
  void add_picture(const std::string& file, Material& material);
  std::string add_triangles(const Mesh& mesh);
  void frame(const Mesh& mesh);
  void say(Severity severity, std::string message, std::string hint = {}) {
    read_.warnings.push_back({.severity = severity,
                              .file = name_,
                              .message = std::move(message),
                              .hint = std::move(hint)});
  }

  const std::string& name_;
  const ReadOptions& options_;
  SceneFolder folder_;
  SceneImages images_;
  ReadScene read_;
  Scene& scene_ = read_.scene;
};

void MeshScene::add_picture(const std::string& file, Material& material) {
  const auto image = options_.folder ? images_.load(file)
                                     : Result<std::shared_ptr<const Image>>(
                                           failure(file, "files beside the scene need a folder"));
  if (!image)
    return say(Severity::warning,
               fmt::format("{}: {}; it is left out", shown(file), image.error()[0].message));
  Texture texture;
  texture.kind = TextureKind::image;
  texture.mapping = TextureMapping::uv;
  texture.file = file;
  texture.image = *image;
  const auto index = static_cast<std::uint32_t>(scene_.textures.size());
  scene_.textures.push_back(std::move(texture));
  material.textures = {{Coefficient::ambient, index}, {Coefficient::diffuse, index}};
}

Material MeshScene::material_of(const MtlMaterial& mtl) {
  constexpr int kMirrors = 3, kFresnel = 5, kBends = 6, kBendsByFresnel = 7;
  Material m;
  m.ambient = m.diffuse = mtl.diffuse * mtl.opacity;
  if (mtl.emission != Color{})
    m.ambient = {m.ambient.r + mtl.emission.r / kAmbient, m.ambient.g + mtl.emission.g / kAmbient,
                 m.ambient.b + mtl.emission.b / kAmbient};
  m.specular = mtl.specular;
  m.shininess = mtl.shininess;
  if (mtl.illumination >= kMirrors && mtl.illumination <= kBendsByFresnel) {
    const Color& ks = mtl.specular;
    m.reflection = Color{std::min(ks.r, 1.0), std::min(ks.g, 1.0), std::min(ks.b, 1.0)};
  }
  m.refraction = 1 - mtl.opacity;
  if (mtl.illumination == kBends || mtl.illumination == kBendsByFresnel) m.ior = mtl.ior;
  if ((mtl.illumination == kFresnel || mtl.illumination == kBendsByFresnel) && mtl.opacity < 1)
    m.fresnel = Fresnel::exact;
  if (!mtl.diffuse_map.empty()) add_picture(mtl.diffuse_map, m);
  return m;
}

void MeshScene::read_library(const std::string& file, std::map<std::string, MtlMaterial>& known) {
  constexpr std::uint64_t kLargest = std::uint64_t{1} << 26;
  const auto fail = [&](const Diagnostics& problems) {
    say(Severity::warning,
        fmt::format("{}: {}; what it has is grey", shown(file), problems[0].message));
  };
  if (!options_.folder)
    return say(Severity::warning, fmt::format("{}: files beside the scene need a folder; what it "
                                              "has is grey",
                                              shown(file)));
  const Result<std::string> path = folder_.path_of(file);
  if (!path) return fail(path.error());
  const Result<std::string> text = read_file(*path, kLargest);
  if (!text) return fail(text.error());
  // Pictures lie beside the file that names them.
  const std::string beside = file.substr(0, file.find_last_of('/') + 1);
  for (MtlMaterial& material : parse_mtl(*text)) {
    if (!material.diffuse_map.empty()) material.diffuse_map.insert(0, beside);
    known.try_emplace(material.name, material);
  }
}

/// Material 0 is of what names none.
void MeshScene::read_materials(const Mesh& mesh) {
  Material plain;
  plain.ambient = plain.diffuse;
  plain.specular = {0.2, 0.2, 0.2};
  plain.shininess = 40;
  scene_.materials = {plain};
  std::map<std::string, MtlMaterial> known;
  constexpr std::size_t kMostFiles = 100;
  for (std::size_t i = 0; i < std::min(mesh.material_files.size(), kMostFiles); ++i)
    read_library(mesh.material_files[i], known);
  std::uint64_t missing = 0;
  for (const std::string& name : mesh.material_names) {
    const auto found = known.find(name);
    missing += found == known.end();
    scene_.materials.push_back(found == known.end() ? plain : material_of(found->second));
    if (is_utf8(name) && !name.empty())
      scene_.material_names[static_cast<std::uint32_t>(scene_.materials.size() - 1)] = name;
  }
  if (missing > 0 && !known.empty())
    say(Severity::warning,
        fmt::format("{} of its materials {} in no file of materials: grey is drawn", missing,
                    missing == 1 ? "is" : "are"));
}

std::string MeshScene::add_triangles(const Mesh& mesh) {
  const bool smooth = !mesh.normals.empty();
  const auto put = [&](std::size_t i, const auto& shape, auto& list,
                       std::vector<CornerUvs>& uvs) -> std::string {
    const std::uint32_t own = i < mesh.materials.size() ? mesh.materials[i] : Mesh::kNone;
    list.push_back({shape, own == Mesh::kNone ? 0 : own + 1});
    if (!mesh.uvs.empty()) {
      uvs.push_back({{{0, 0}, {1, 0}, {0, 1}}});
      for (std::size_t k = 0; k < 3; ++k)
        if (mesh.triangles[i][k].uv != Mesh::kNone)
          uvs.back()[k] = mesh.uvs[mesh.triangles[i][k].uv];
    }
    return problem_of(shape);
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Mesh::Triangle& t = mesh.triangles[i];
    const auto point = [&](std::size_t k) { return mesh.points[t[k].point]; };
    const auto normal = [&](std::size_t k) { return mesh.normals[t[k].normal]; };
    const std::string problem =
        smooth
            ? put(i, SmoothTriangle{point(0), point(1), point(2), normal(0), normal(1), normal(2)},
                  scene_.smooth_triangles, scene_.smooth_triangle_uvs)
            : put(i, Triangle{point(0), point(1), point(2)}, scene_.triangles, scene_.triangle_uvs);
    if (!problem.empty()) return fmt::format("triangle {}: {}", i, problem);
  }
  return "";
}

void MeshScene::frame(const Mesh& mesh) {
  // What is printed stands on z = 0, as STL has it; all others have y up.
  const bool z_up =
      ends_with(name_, ".stl") || ends_with(name_, ".stl.gz") || ends_with(name_, ".stl.zst");
  const ViewDirection direction = z_up ? ViewDirection{unit({0.5, -1, 0.35}), {0, 0, 1}}
                                       : ViewDirection{unit({0.5, 0.35, 1}), {0, 1, 0}};
  std::vector<Vec3> points;
  Bounds box;
  points.reserve(3 * mesh.triangles.size());
  for (const Mesh::Triangle& triangle : mesh.triangles)
    for (const Mesh::Corner& corner : triangle) {
      const Vec3& point = mesh.points[corner.point];
      points.push_back(point);
      box.include({point, point});
    }
  scene_.resolution = kFramedResolution;
  scene_.camera = camera_around(
      points, direction, static_cast<double>(kFramedResolution.width) / kFramedResolution.height);
  const double size = length(box.upper - box.lower) / 2;
  add_studio_lights(scene_, direction, (box.lower + box.upper) * 0.5, size > 0 ? size : 1);
  scene_.ambient_light = {kAmbient, kAmbient, kAmbient};
  scene_.sky.kind = Sky::Kind::gradient;
  scene_.sky.up = direction.up;
  scene_.sky.bottom = {0.18, 0.18, 0.18};
  scene_.sky.top = {0.55, 0.6, 0.7};
}

Result<ReadScene> MeshScene::build(Mesh mesh) {
  if (!mesh.normals.empty()) mesh.add_normals();
  read_materials(mesh);
  if (const std::string problem = add_triangles(mesh); !problem.empty())
    return failure(name_, problem);
  frame(mesh);
  const bool is_clear = std::any_of(scene_.materials.begin(), scene_.materials.end(),
                                    [](const Material& m) { return m.refraction.most() > 0; });
  if (is_clear) scene_.defaults.shadows = Shadows::transparent;
  say(Severity::note,
      fmt::format("{} triangle{}; light and camera are chosen here", grouped(mesh.triangles.size()),
                  mesh.triangles.size() == 1 ? "" : "s"),
      "a scene with a shape of kind 'mesh' chooses otherwise: zraka help mesh");
  return std::move(read_);
}

}  // namespace

Likeness likeness_to_mesh(std::string_view text) {
  return is_mesh(text) ? Likeness::sure : Likeness::none;
}

Result<ReadScene> parse_mesh_scene(std::string_view bytes, const std::string& name,
                                   const ReadOptions& options) {
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  Result<Mesh> mesh = parse_mesh(bytes, name);
  if (!mesh) return tl::make_unexpected(mesh.error());
  return MeshScene(name, options).build(std::move(*mesh));
}

}  // namespace zraka
