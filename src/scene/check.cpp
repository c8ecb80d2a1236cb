// SPDX-License-Identifier: Apache-2.0
// What can be wrong with a scene that a program has put together.
#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <type_traits>
#include <zraka/render.hpp>

#include "core/in_parallel.hpp"
#include "materials/dispersion.hpp"
#include "scene/check_bodies.hpp"
#include "scene/check_shape.hpp"
#include "scene/freeze.hpp"
#include "scene/view.hpp"
#include "scene/view_axes.hpp"
#include "shapes/shapes.hpp"

namespace zraka {

namespace {

/// Squares and products of what is this far stay finite.

bool within_reach(const Vec3& v) {
  return std::fabs(v.x) <= kFarthest && std::fabs(v.y) <= kFarthest && std::fabs(v.z) <= kFarthest;
}

bool finite_material(const Material& m) {
  return finite(m.ambient) && finite(m.diffuse) && finite(m.specular) && finite(m.shininess) &&
         finite(m.reflection) && finite(m.refraction) && finite(m.ior) && finite(m.absorption) &&
         std::all_of(m.dispersion.numbers.begin(), m.dispersion.numbers.end(),
                     [](double number) { return finite(number); });
}

/// What is wrong with a material, "" where all is well.
std::string problem_of(const Material& m) {
  if (!finite_material(m)) return "is not finite";
  if (!(m.absorption.r >= 0 && m.absorption.g >= 0 && m.absorption.b >= 0))
    return "has an absorption below 0";
  if (m.dispersion.kind != Dispersion::Kind::none && !has_index(m.dispersion, m.ior))
    return "has no index of refraction above 0 for some of the light that is seen";
  return "";
}

/// The same of a light.
std::string problem_of(const Light& light) {
  const auto is_direction = [](const Vec3& v) { return finite(v) && v != Vec3{}; };
  const Vec3& a = light.attenuation;
  const bool surface = light.is_surface(), placed = light.kind != LightKind::directional;
  if (!finite(light.color) || (placed && !finite(light.position))) return "is not finite";
  if (placed && !within_reach(light.position))
    return fmt::format("is farther than {} from the origin", kFarthest);
  if (placed && !(finite(a) && a.x >= 0 && a.y >= 0 && a.z >= 0 && a != Vec3{}))
    return "has an attenuation that is not finite, below 0, or 0";
  if (placed && std::max({a.x, a.y, a.z}) < 1e-30) return "has an attenuation below 1e-30";
  if (surface && (light.samples < 1 || light.samples > kMaxSamples))
    return fmt::format("has {} samples: expected 1 to {}", light.samples, kMaxSamples);
  switch (light.kind) {
    case LightKind::point:
      break;
    case LightKind::directional:
      if (!is_direction(light.direction)) return "has a direction that is 0, or not finite";
      break;
    case LightKind::spot:
      if (!is_direction(light.direction)) return "has a direction that is 0, or not finite";
      if (!(light.inner_deg >= 0 && light.inner_deg <= light.outer_deg && light.outer_deg > 0 &&
            light.outer_deg <= 180))
        return fmt::format("shines from {} to {} degrees: expected angles up to 180, in order",
                           light.inner_deg, light.outer_deg);
      break;
    case LightKind::rectangle:
      if (!finite(light.edge_u) || !finite(light.edge_v)) return "has an edge that is not finite";
      if (!within_reach(light.edge_u) || !within_reach(light.edge_v))
        return fmt::format("is larger than {}", kFarthest);
      if (!spans_a_plane(light.edge_u, light.edge_v)) return "has edges that span no plane";
      break;
    case LightKind::disc:
      if (!is_direction(light.normal)) return "has a normal that is 0, or not finite";
      [[fallthrough]];
    case LightKind::sphere:
      if (!finite(light.radius) || !(light.radius > 0))
        return "has a radius that is not a finite number above 0";
      if (light.radius > kFarthest) return fmt::format("is larger than {}", kFarthest);
      break;
  }
  return "";
}

void check_cuts(const Scene& scene, const auto& complain) {
  constexpr std::size_t kMaxCuts = 1024;  // each ray asks all of them
  if (scene.cuts.size() > kMaxCuts)
    return complain(
        fmt::format("there are {} cuts: at most {} can be", scene.cuts.size(), kMaxCuts));
  for (std::size_t i = 0; i < scene.cuts.size(); ++i)
    if (const Cut& cut = scene.cuts[i];
        !finite(cut.point) || !finite(cut.normal) || cut.normal == Vec3{})
      complain(fmt::format("cut {}: its normal is 0, or it is not finite", i + 1));
}

void check_sky(const Scene& scene, const auto& complain) {
  const Sky& sky = scene.sky;
  const AmbientOcclusion& occlusion = scene.ambient_occlusion;
  if (!finite(scene.background) || !finite(scene.ambient_light))
    complain("the background or the ambient light is not finite");
  if (sky.kind == Sky::Kind::gradient && (!finite(sky.bottom) || !finite(sky.top)))
    complain("a colour of the sky is not finite");
  if (sky.kind != Sky::Kind::flat && (!finite(sky.up) || sky.up == Vec3{}))
    complain("the sky's up is 0, or not finite");
  if (sky.kind == Sky::Kind::image && sky.texture >= scene.textures.size())
    complain(fmt::format("the sky has texture {}, but there are {}", sky.texture,
                         scene.textures.size()));
  else if (sky.kind == Sky::Kind::image && scene.textures[sky.texture].kind != TextureKind::image)
    complain("the sky's texture is no image");
  if (occlusion.samples < 0 || occlusion.samples > kMaxSamples)
    complain(fmt::format("ambient occlusion has {} samples: expected 0 to {}", occlusion.samples,
                         kMaxSamples));
  if (!finite(occlusion.distance) || !(occlusion.distance >= 0) || !finite(occlusion.color))
    complain("ambient occlusion is not finite, or its distance below 0");
}

/// How far a box reaches from the origin.
double farthest(const Bounds& box) {
  return std::max({std::fabs(box.lower.x), std::fabs(box.lower.y), std::fabs(box.lower.z),
                   std::fabs(box.upper.x), std::fabs(box.upper.y), std::fabs(box.upper.z)});
}

/// How far from the origin shapes reach, and how far the smallest reaches from its middle.
struct Extent {
  double most = 0, least = Bounds::kInfinity;
};

template <class Shape>
const char* problem_with(const Shape& shape) {
  if constexpr (requires { ShapeTraits<Shape>::check(shape); })
    return ShapeTraits<Shape>::check(shape);
  else
    return nullptr;
}

template <class Shape>
void check_objects(const Scene& scene, const Whereabouts& where,
                   const std::vector<Object<Shape>>& objects, Extent& extent,
                   const auto& complain) {
  using Traits = ShapeTraits<Shape>;
  std::mutex adding;
  // Mostly nothing is wrong, which is soon known; what is said otherwise must come in order.
  std::atomic<bool> good = true;
  in_parallel(objects.size(), [&](std::size_t begin, std::size_t end) {
    Extent part;
    for (std::size_t i = begin; i < end; ++i) {
      if (problem_with(objects[i].shape) != nullptr ||
          objects[i].material >= scene.materials.size() ||
          objects[i].transform > scene.transforms.size())
        good = false;
      const Bounds box = where.bounds(objects[i]);
      if (!has_bounds<Shape>(box)) continue;
      const double reach = box.reach(), most = farthest(box);
      if (!(most <= kFarthest)) good = false;
      part.most = std::max(part.most, most);
      if (reach > 0) part.least = std::min(part.least, reach);
    }
    const std::lock_guard lock(adding);
    extent.most = std::max(extent.most, part.most);
    extent.least = std::min(extent.least, part.least);
  });
  if (good) return;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (const char* problem = problem_with(objects[i].shape))
      complain(fmt::format("{} {}: {}", Traits::kName, i + 1, problem));
    if (const Bounds box = where.bounds(objects[i]);
        has_bounds<Shape>(box) && !(farthest(box) <= kFarthest))
      complain(fmt::format("{} {}: it reaches farther than {} from the origin", Traits::kName,
                           i + 1, kFarthest));
    if (objects[i].material >= scene.materials.size())
      complain(fmt::format("{} {}: it has material {}, but there are {}", Traits::kName, i + 1,
                           objects[i].material, scene.materials.size()));
    if (objects[i].transform > scene.transforms.size())
      complain(fmt::format("{} {}: it has transform {}, but there are {}", Traits::kName, i + 1,
                           objects[i].transform, scene.transforms.size()));
  }
}

std::uint64_t count_members(const Csg& csg) {
  std::uint64_t count = csg.of.size();
  for (const CsgMember& member : csg.of)
    if (const Csg* const inner = std::get_if<Csg>(&member.body)) count += count_members(*inner);
  return count;
}

/// All bodies, members of CSG among them.
std::uint64_t count_bodies(const Scene& scene) {
  std::uint64_t bodies = 0;
  const auto count = [&](const ShapeLists& shapes) {
#define ZRAKA_COUNT(Type, plural) bodies += shapes.plural.size();
    ZRAKA_BODIES(ZRAKA_COUNT)
#undef ZRAKA_COUNT
    for (const Object<Csg>& object : shapes.csgs) bodies += count_members(object.shape);
  };
  count(scene);
  for (const Group& group : scene.groups) count(group);
  return bodies;
}

/// Words for what is wrong with a camera whose vectors are finite, and "" if nothing is.
std::string problem_with(const Camera& camera) {
  if (camera.kind == CameraKind::fisheye && !(camera.fov_deg > 0 && camera.fov_deg <= 360))
    return fmt::format(
        "the fisheye camera's angle of view is {}°: more than 0 and at most 360 are "
        "possible",
        camera.fov_deg);
  if (!(camera.aperture >= 0 && camera.aperture <= kFarthest))
    return fmt::format("the lens' diameter is {}: 0 or more is possible", camera.aperture);
  if (camera.aperture > 0 && !(camera.focus_distance > 0 && camera.focus_distance <= kFarthest))
    return fmt::format("the camera is in focus at the distance {}: it has to be more than 0",
                       camera.focus_distance);
  if (camera.kind == CameraKind::pinhole && camera.aperture == 0) return "";
  const bool window = camera.kind != CameraKind::fisheye && camera.kind != CameraKind::panorama;
  if (!ViewAxes(camera).good() || (window && !spans_a_plane(camera.window_right, camera.window_up)))
    return "the camera looks nowhere, or straight up: its eye, its window's middle and up span no "
           "plane";
  return "";
}

void check_camera(const Camera& camera, const auto& complain) {
  if (!finite(camera.eye) || !finite(camera.window_center) || !finite(camera.window_right) ||
      !finite(camera.window_up))
    complain("the camera is not finite");
  else if (!within_reach(camera.eye) || !within_reach(camera.window_center) ||
           !within_reach(camera.window_right) || !within_reach(camera.window_up))
    complain(fmt::format("the camera reaches farther than {} from the origin", kFarthest));
  else if (std::string problem = problem_with(camera); !problem.empty())
    complain(std::move(problem));
}

/// Whether floats can hold what the camera sees beside what there is else.
void check_floats(const Scene& scene, const Extent& extent, const auto& complain) {
  // Looking for what is seen takes long in large scenes, and most are far from any bound.
  constexpr std::uint64_t kFewShapes = 65536;
  constexpr double kFar = 0x1p60;        // has a square
  constexpr double kFarCorner = 0x1p30;  // has a fourth power
  constexpr double kFarEdge = 4;         // as far as hit_margin() is enough for
  constexpr double kLargeCone = 0x1p18;  // widths of the picture: offsets are a quarter of one
  const Camera& camera = scene.camera;
  const auto length = [](const Vec3& v) { return std::hypot(v.x, v.y, v.z); };
  const double away =
      length({camera.window_center.x - camera.eye.x, camera.window_center.y - camera.eye.y,
              camera.window_center.z - camera.eye.z});
  double pixel = std::fmin(length(camera.window_right) / scene.resolution.width,
                           length(camera.window_up) / scene.resolution.height);
  // Directions have 24 bits; of parallel rays it is the places that have.
  double held = away;
  if (camera.kind == CameraKind::fisheye)
    pixel = camera.fov_deg * 0x1p-6 / scene.resolution.height, held = 1;
  if (camera.kind == CameraKind::panorama) pixel = held = 1;
  if (camera.kind == CameraKind::orthographic) {
    const Frame frame = frame_of(scene);
    const Vec3 eye = frame.point(camera.eye);
    held = frame.world_length(std::max({std::fabs(eye.x), std::fabs(eye.y), std::fabs(eye.z)}));
  }
  if (pixel < held * 0x1p-21)
    complain("the view is too narrow: floats cannot tell the rays of neighbouring pixels apart",
             "from nearer by, or with fewer pixels, they can");
  if (scene.shape_count() == 0 ||
      (scene.shape_count() > kFewShapes && extent.most < 0x1p20 * extent.least))
    return;
  const Frame frame = frame_of(scene);
  const auto reach_of = [&](const Vec3& world) {
    const Vec3 v = frame.point(world);
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  };
  if (!(reach_of(camera.eye) <= kFar))
    complain("the eye is so far from all shapes that floats cannot hold the distance",
             "move it nearer");
  const Whereabouts where(scene);
  const auto look = [&]<class Shape>(const std::vector<Object<Shape>>& objects) {
    using Traits = ShapeTraits<Shape>;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const Bounds box = where.bounds(objects[i]);
      if (!has_bounds<Shape>(box)) continue;
      const double reach = std::max(reach_of(box.lower), reach_of(box.upper));
      constexpr bool kRound = std::is_same_v<Shape, Sphere>;
      const bool too_far = reach > (kRound ? kFar : kFarCorner) ||
                           (!kRound && frame.length(box.distance_to(frame.center)) > kFarEdge);
      if (too_far)
        complain(
            fmt::format("{} {}: it reaches {:.1g} from what the camera sees, which is so small "
                        "that floats cannot hold both",
                        Traits::kName, i + 1, frame.world_length(reach)),
            "move it nearer, make it smaller or leave it out");
      else if (std::is_same_v<Shape, Cone> && box.reach() > kLargeCone * frame.width_seen &&
               box.distance_to(frame.center) < box.reach())
        complain(fmt::format("{} {}: it is {:.1g} times as large as what the camera sees of it; "
                             "floats cannot hold that",
                             Traits::kName, i + 1, box.reach() / frame.width_seen),
                 "triangles or a sphere in its place can be as large");
    }
  };
#define ZRAKA_LOOK(Type, plural) look(scene.plural);
  ZRAKA_SHAPES(ZRAKA_LOOK)
#undef ZRAKA_LOOK
}

}  // namespace

Diagnostics check(const Scene& scene) {
  constexpr std::size_t kEnough = 20;
  Diagnostics found;
  const auto complain = [&](std::string message, std::string hint = {}) {
    if (found.size() < kEnough)
      found.push_back({.message = std::move(message), .hint = std::move(hint)});
  };
  const std::uint64_t pixels = std::uint64_t{scene.resolution.width} * scene.resolution.height;
  if (pixels == 0) complain("the picture has no pixels");
  if (pixels > kMaxPixels)
    complain(fmt::format("a picture of {}×{} pixels is too large: at most {} pixels fit",
                         scene.resolution.width, scene.resolution.height, kMaxPixels));
  check_camera(scene.camera, complain);
  check_sky(scene, complain);
  check_cuts(scene, complain);
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    if (const std::string problem = problem_of(scene.lights[i]); !problem.empty())
      complain(fmt::format("light {} {}", i + 1, problem));
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    if (const std::string problem = problem_of(scene.materials[i]); !problem.empty())
      complain(fmt::format("material {} {}", i, problem));
  if (scene.shape_count() > static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max()))
    complain(fmt::format("{} shapes are too many: at most {} fit", scene.shape_count(),
                         std::numeric_limits<std::int32_t>::max()));
  constexpr std::uint64_t kMostMaterials = std::uint64_t{1} << 26;
  if (scene.materials.size() > kMostMaterials || scene.lights.size() > kMostMaterials)
    complain(fmt::format("{} materials and {} lights are too many: at most {} of each fit",
                         scene.materials.size(), scene.lights.size(), kMostMaterials));
  // Their numbers are counted in 31 bits.
  constexpr std::uint64_t kMostBodies = (std::uint64_t{1} << 31) / 32;
  if (const std::uint64_t bodies = count_bodies(scene); bodies > kMostBodies)
    complain(fmt::format("{} bodies, members of CSG among them, are too many: at most {} fit",
                         bodies, kMostBodies));
  Extent extent;
  if (!check_references(scene, complain)) return found;
  const Whereabouts where(scene);
#define ZRAKA_CHECK(Type, plural) check_objects(scene, where, scene.plural, extent, complain);
  ZRAKA_SHAPES(ZRAKA_CHECK)
#undef ZRAKA_CHECK
  if (found.empty()) check_floats(scene, extent, complain);
  return found;
}

}  // namespace zraka
