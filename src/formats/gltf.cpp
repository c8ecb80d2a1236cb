// SPDX-License-Identifier: Apache-2.0
// glTF 2.0 and GLB (docs/gltf.md): nodes with meshes, cameras and lights, and what is chosen where
// a file has neither.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formats/formats.hpp"
#include "formats/framing.hpp"
#include "formats/gltf_meshes.hpp"
#include "formats/vectors.hpp"
#include "scene/bounds_of.hpp"
#include "scene/view.hpp"

namespace zraka {
namespace {

constexpr double kPi = 3.14159265358979323846;

class GltfReader {
 public:
  GltfReader(const std::string& name, const ReadOptions& options)
      : file_(name, options), materials_(file_, scene_), meshes_(file_, materials_, scene_) {}

  Result<ReadScene> read(std::string_view bytes);

 private:
  struct Placed {
    std::size_t node;
    Transform world;
  };
  Transform transform_of(const Json& node);
  void place(std::size_t node, const Transform& parent, int depth);
  void add_node(const Placed& placed);
  void add_mesh(const Json& node, std::size_t mesh, const Transform& world);
  void add_camera(const Json& camera, const Transform& world);
  void add_light(const Json& light, const Transform& world);
  std::vector<Transform> joints_of(const Json& node);
  void frame();
  void choose_lights(const Bounds& box);
  void note(std::string message, std::string hint = {});

  Scene scene_;
  GltfFile file_;
  GltfMaterials materials_;
  GltfMeshes meshes_;
  std::vector<bool> seen_;
  std::vector<Placed> placed_;
  std::vector<std::optional<Transform>> worlds_;  ///< of all nodes that are placed
  bool has_camera_ = false;
  Diagnostics notes_;
};

void GltfReader::note(std::string message, std::string hint) {
  notes_.push_back({.severity = Severity::note,
                    .file = file_.name(),
                    .message = std::move(message),
                    .hint = std::move(hint)});
}

Transform GltfReader::transform_of(const Json& node) {
  if (GltfFile::member(&node, "matrix") != nullptr) {
    double m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    file_.numbers(&node, "matrix", 16, m);
    return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
  }
  double t[3] = {0, 0, 0}, q[4] = {0, 0, 0, 1}, s[3] = {1, 1, 1};
  file_.numbers(&node, "translation", 3, t);
  file_.numbers(&node, "rotation", 4, q);
  file_.numbers(&node, "scale", 3, s);
  const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (size > 0)
    for (double& part : q) part /= size;
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  return {Vec3{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)} * s[0],
          Vec3{2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)} * s[1],
          Vec3{2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)} * s[2],
          {t[0], t[1], t[2]}};
}

/// Each node once: they are trees.
void GltfReader::place(std::size_t index, const Transform& parent, int depth) {
  constexpr int kDeepestNode = 500;
  if (seen_[index] || depth > kDeepestNode)
    return file_.fail(fmt::format("node {} is in several places, or in itself", index),
                      "the nodes of glTF are trees");
  seen_[index] = true;
  const Json& node = *file_.item("nodes", index);
  const Transform world = then(transform_of(node), parent);
  worlds_[index] = world;
  placed_.push_back({index, world});
  for (const Json& child : file_.list(&node, "children")) {
    double at = -1;
    if (!child.get_number(at) || !(at >= 0) || !(at < static_cast<double>(seen_.size())) ||
        at != std::floor(at))
      return file_.fail(
          fmt::format("node {} has a child that is none of the {} nodes", index, seen_.size()));
    place(static_cast<std::size_t>(at), world, depth + 1);
    if (!file_.good()) return;
  }
}

std::vector<Transform> GltfReader::joints_of(const Json& node) {
  std::vector<Transform> all;
  const std::optional<std::size_t> at = file_.index(&node, "skin", "skins");
  if (!at) return all;
  const Json* const skin = file_.item("skins", *at);
  const Json::Array& joints = file_.list(skin, "joints");
  const std::optional<std::size_t> back = file_.index(skin, "inverseBindMatrices", "accessors");
  const GltfNumbers* const matrices = back ? file_.accessor(*back, 16) : nullptr;
  if (matrices != nullptr && matrices->count < joints.size())
    return file_.fail(fmt::format("skin {} has fewer matrices than joints", *at)), all;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    double joint = -1;
    joints[i].get_number(joint);
    const bool is_node = joint >= 0 && joint < static_cast<double>(worlds_.size());
    Transform way =
        is_node ? worlds_[static_cast<std::size_t>(joint)].value_or(Transform{}) : Transform{};
    if (matrices != nullptr) {
      const float* const m = matrices->at(i);
      const auto column = [&](std::size_t c) {
        return Vec3{static_cast<double>(m[4 * c]), static_cast<double>(m[4 * c + 1]),
                    static_cast<double>(m[4 * c + 2])};
      };
      way = then({column(0), column(1), column(2), column(3)}, way);
    }
    all.push_back(way);
  }
  return all;
}

void GltfReader::add_mesh(const Json& node, std::size_t mesh, const Transform& world) {
  GltfPose pose;
  for (const Json& weight : file_.list(&node, "weights")) {
    double value = 0;
    pose.weights.push_back(weight.get_number(value) ? value : 0);
  }
  pose.joints = joints_of(node);
  if (!file_.good()) return;
  const std::optional<std::uint32_t> group =
      pose.weights.empty() && pose.joints.empty() ? meshes_.group(mesh) : meshes_.posed(mesh, pose);
  if (!group) return;
  // A skin's joints say where its points are.
  const Transform own = pose.joints.empty() ? world : Transform{};
  if (!inverse(own)) return file_.warn("meshes that nodes make flat are left out");
  Object<Instance> instance{{*group}, 0};
  if (own != Transform{}) {
    scene_.transforms.push_back(own);
    instance.transform = static_cast<std::uint32_t>(scene_.transforms.size());
  }
  scene_.instances.push_back(instance);
}

void GltfReader::add_camera(const Json& camera, const Transform& world) {
  if (has_camera_) return;
  const Vec3 eye = world.origin, ahead = unit(world.along_z) * -1, up = unit(world.along_y);
  const bool is_parallel = file_.word(&camera, "type", "perspective") == "orthographic";
  const Json* const lens = GltfFile::member(&camera, is_parallel ? "orthographic" : "perspective");
  constexpr double kUsualAspect = 16.0 / 9, kWidest = 8;
  double aspect = file_.number(lens, "aspectRatio", kUsualAspect);
  std::optional<Camera> seen;
  if (is_parallel) {
    const double x = std::fabs(file_.number(lens, "xmag", 1)),
                 y = std::fabs(file_.number(lens, "ymag", 1));
    if (y > 0) aspect = x / y;
    aspect = std::clamp(aspect, 1 / kWidest, kWidest);
    seen = look_along(eye, eye + ahead, up, 2 * (y > 0 ? y : 1), aspect);
  } else {
    const double height = file_.number(lens, "yfov", kPi / 4) * 180 / kPi;
    aspect = std::clamp(aspect, 1 / kWidest, kWidest);
    if (height > 0 && height < 180) seen = look_at(eye, eye + ahead, up, height, aspect);
  }
  if (!seen) return file_.warn("cameras that see nothing are left out");
  has_camera_ = true;
  scene_.camera = *seen;
  scene_.resolution.height = kFramedResolution.height;
  scene_.resolution.width =
      static_cast<std::uint32_t>(std::lround(std::max(1.0, scene_.resolution.height * aspect)));
}

/// Candelas and lux as they are, over π, for that is what a white surface sends on of what arrives.
void GltfReader::add_light(const Json& given, const Transform& world) {
  double rgb[3] = {1, 1, 1};
  file_.numbers(&given, "color", 3, rgb);
  const double intensity = std::max(0.0, file_.number(&given, "intensity", 1)) / kPi;
  const std::string type = file_.word(&given, "type", "point");
  Light light;
  light.position = world.origin;
  light.direction = unit(world.along_z) * -1;
  if (light.direction == Vec3{}) light.direction = {0, 0, -1};
  light.color = {std::max(0.0, rgb[0]) * intensity, std::max(0.0, rgb[1]) * intensity,
                 std::max(0.0, rgb[2]) * intensity};
  if (type == "directional") {
    light.kind = LightKind::directional;
  } else {
    light.attenuation = {0, 0, 1};
    if (type == "spot") {
      const Json* const spot = GltfFile::member(&given, "spot");
      light.kind = LightKind::spot;
      light.outer_deg =
          std::clamp(file_.number(spot, "outerConeAngle", kPi / 4) * 180 / kPi, 0.1, 90.0);
      light.inner_deg =
          std::clamp(file_.number(spot, "innerConeAngle", 0) * 180 / kPi, 0.0, light.outer_deg);
    }
  }
  scene_.lights.push_back(light);
}

void GltfReader::add_node(const Placed& placed) {
  const Json& node = *file_.item("nodes", placed.node);
  if (!file_.flag(GltfFile::extension(&node, "KHR_node_visibility"), "visible", true)) return;
  if (const std::optional<std::size_t> mesh = file_.index(&node, "mesh", "meshes"))
    add_mesh(node, *mesh, placed.world);
  if (const std::optional<std::size_t> camera = file_.index(&node, "camera", "cameras"))
    add_camera(*file_.item("cameras", *camera), placed.world);
  const Json* const light = GltfFile::extension(&node, "KHR_lights_punctual");
  if (light == nullptr) return;
  const Json::Array& lights =
      file_.list(GltfFile::extension(&file_.root(), "KHR_lights_punctual"), "lights");
  const double at = file_.number(light, "light", -1);
  if (!(at >= 0) || !(at < static_cast<double>(lights.size())))
    return file_.fail(fmt::format("node {} has a light that the file does not have", placed.node));
  add_light(lights[static_cast<std::size_t>(at)], placed.world);
}

/// Lights of the file are as bright as a lamp or as the sun: they are made to give a picture.
void GltfReader::choose_lights(const Bounds& box) {
  const Vec3 middle = (box.lower + box.upper) * 0.5;
  scene_.ambient_light = {kGltfAmbient, kGltfAmbient, kGltfAmbient};
  scene_.sky.kind = Sky::Kind::gradient;
  scene_.sky.bottom = {0.18, 0.18, 0.18};
  scene_.sky.top = {0.55, 0.6, 0.7};
  if (scene_.lights.empty()) {
    const ViewDirection direction{unit({0.5, 0.35, 1}), {0, 1, 0}};
    add_studio_lights(scene_, direction, middle, std::max(length(box.upper - box.lower) / 2, 1e-9));
    return note("the file has no lights: two are chosen here");
  }
  double sum = 0;
  const double least = length(box.upper - box.lower) * 0.1;
  for (const Light& light : scene_.lights) {
    const double away = std::max(length(light.position - middle), least);
    sum += std::max({light.color.r, light.color.g, light.color.b}) /
           (light.kind == LightKind::directional || !(away > 0) ? 1 : away * away);
  }
  constexpr double kDark = 0.3, kBright = 2;
  if (!(sum > 0) || !std::isfinite(sum) || (sum >= kDark && sum <= kBright)) return;
  for (Light& light : scene_.lights) light.color = light.color * (1 / sum);
  note(fmt::format("the file's lights are {:.3g} times as bright as they are drawn", sum));
}

void GltfReader::frame() {
  const Whereabouts where(scene_);
  Bounds box;
  std::vector<Vec3> corners;
  for (const Object<Instance>& instance : scene_.instances) {
    const Bounds own = where.bounds(instance);
    box.include(own);
    const Bounds& group = where.group(instance.shape.group);
    for (int i = 0; i < 8; ++i)
      corners.push_back(moved(Vec3{(i & 1) != 0 ? group.upper.x : group.lower.x,
                                   (i & 2) != 0 ? group.upper.y : group.lower.y,
                                   (i & 4) != 0 ? group.upper.z : group.lower.z},
                              where.transform(instance.transform)));
  }
  choose_lights(box);
  if (has_camera_) return;
  scene_.resolution = kFramedResolution;
  scene_.camera =
      camera_around(corners, {unit({0.5, 0.35, 1}), {0, 1, 0}},
                    static_cast<double>(kFramedResolution.width) / kFramedResolution.height);
  note("the file has no camera: one is chosen that sees all of it");
}

Result<ReadScene> GltfReader::read(std::string_view bytes) {
  if (!file_.open(bytes)) return tl::make_unexpected(std::move(file_.errors()));
  const Json& root = file_.root();
  const std::size_t nodes = file_.list(&root, "nodes").size();
  seen_.assign(nodes, false);
  worlds_.resize(nodes);
  std::vector<double> roots;
  const Json::Array& scenes = file_.list(&root, "scenes");
  const std::size_t scene = file_.index(&root, "scene", "scenes").value_or(0);
  if (!scenes.empty()) {
    for (const Json& node : file_.list(&scenes[scene], "nodes")) {
      roots.push_back(-1);
      node.get_number(roots.back());
    }
  } else {
    // Those that are no other's child.
    std::vector<bool> is_child(nodes);
    for (const Json& node : file_.list(&root, "nodes"))
      for (const Json& child : file_.list(&node, "children"))
        if (double at = -1; child.get_number(at) && at >= 0 && at < static_cast<double>(nodes))
          is_child[static_cast<std::size_t>(at)] = true;
    for (std::size_t i = 0; i < nodes; ++i)
      if (!is_child[i]) roots.push_back(static_cast<double>(i));
  }
  for (const double at : roots) {
    if (!file_.good()) break;
    if (!(at >= 0) || !(at < static_cast<double>(nodes)))
      file_.fail(fmt::format("the scene names a node that is none of the {} nodes", nodes));
    else
      place(static_cast<std::size_t>(at), {}, 0);
  }
  for (const Placed& placed : placed_) {
    if (!file_.good()) break;
    add_node(placed);
  }
  if (file_.good() && scene_.instances.empty()) {
    const Diagnostics said = file_.warnings();
    file_.fail(
        "there is nothing to draw in this file: no node of its scene has a mesh of triangles",
        said.empty() ? "" : said.front().message);
  }
  if (!file_.good()) return tl::make_unexpected(std::move(file_.errors()));
  frame();
  if (!file_.list(&root, "animations").empty()) note("the file moves; it is drawn as it stands");
  scene_.defaults.shadows =
      std::any_of(scene_.materials.begin(), scene_.materials.end(),
                  [](const Material& m) {
                    return m.refraction.most() > 0 ||
                           std::any_of(m.textures.begin(), m.textures.end(), [](auto& use) {
                             return use.coefficient == Coefficient::refraction;
                           });
                  })
          ? Shadows::transparent
          : Shadows::opaque;
  ReadScene read{std::move(scene_), file_.warnings()};
  read.warnings.insert(read.warnings.end(), notes_.begin(), notes_.end());
  return read;
}

}  // namespace

Likeness likeness_to_gltf(std::string_view text) {
  if (text.starts_with("glTF")) return Likeness::sure;
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos || text[begin] != '{') return Likeness::none;
  return text.find("\"asset\"") != std::string_view::npos ? Likeness::sure : Likeness::possible;
}

Result<ReadScene> parse_gltf(std::string_view text, const std::string& name,
                             const ReadOptions& options) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return GltfReader(name, options).read(text);
}

}  // namespace zraka
