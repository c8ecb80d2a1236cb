// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>
#include <zraka/lint.hpp>

#include "scene/freeze.hpp"
#include "scene/inside.hpp"
#include "shapes/shapes.hpp"

namespace zraka {
namespace {

/// Warnings of one kind: the first are said, the rest counted.
class Warnings {
 public:
  explicit Warnings(Diagnostics& all) : all_(all) {}
  ~Warnings() {
    if (count_ > kSaid) add(fmt::format("and {} more like this", count_ - kSaid));
  }
  Warnings(const Warnings&) = delete;

  void say(const auto& message) {
    if (++count_ <= kSaid) add(message());
  }

 private:
  static constexpr std::size_t kSaid = 3;
  void add(std::string message) {
    all_.push_back({.severity = Severity::warning, .message = std::move(message)});
  }
  Diagnostics& all_;
  std::size_t count_ = 0;
};

double reach(const Bounds& box) {
  return std::max(
      {box.upper.x - box.lower.x, box.upper.y - box.lower.y, box.upper.z - box.lower.z});
}

double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec3 minus(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vec3 sum(const Vec3& a, const Vec3& b, double s, double t) {
  return {a.x * s + b.x * t, a.y * s + b.y * t, a.z * s + b.z * t};
}
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The sides of what a camera sees: planes by a point and a normal that points inwards. Of a
/// fisheye's or a panorama's view, which may be round about, there are none.
class View {
 public:
  explicit View(const Camera& camera) {
    const Vec3 &eye = camera.eye, &r = camera.window_right, &u = camera.window_up;
    const Vec3 along = minus(camera.window_center, eye);
    const Vec3 ways[] = {sum(r, u, -0.5, -0.5), sum(r, u, 0.5, -0.5), sum(r, u, 0.5, 0.5),
                         sum(r, u, -0.5, 0.5)};
    if (camera.kind == CameraKind::orthographic) {
      for (int i = 0; i < 4; ++i) {
        const Vec3 corner = sum(eye, ways[i], 1, 1);
        add(corner, cross(minus(ways[(i + 1) % 4], ways[i]), along), minus(eye, corner));
      }
      add(eye, along, along);
    } else if (camera.kind == CameraKind::pinhole) {
      for (int i = 0; i < 4; ++i)
        add(eye, cross(sum(along, ways[i], 1, 1), sum(along, ways[(i + 1) % 4], 1, 1)), along);
    }
  }

  /// True for some boxes beyond an edge of the view, too.
  bool may_see(const Bounds& box) const {
    return std::none_of(sides_.begin(), sides_.end(), [&](const Side& side) {
      const Vec3& n = side.normal;
      const Vec3 farthest{n.x > 0 ? box.upper.x : box.lower.x, n.y > 0 ? box.upper.y : box.lower.y,
                          n.z > 0 ? box.upper.z : box.lower.z};
      return dot(n, minus(farthest, side.point)) < 0;
    });
  }

 private:
  struct Side {
    Vec3 point, normal;
  };
  void add(const Vec3& point, const Vec3& normal, const Vec3& inwards) {
    sides_.push_back({point, sum(normal, {}, dot(normal, inwards) < 0 ? -1 : 1, 0)});
  }
  std::vector<Side> sides_;
};

/// "sphere 3", or with its name.
std::string name_of(const Scene& scene, const char* kind, ShapeId id) {
  const auto name = scene.names.find(id);
  return name == scene.names.end() ? fmt::format("{} {}", kind, id.index + 1)
                                   : fmt::format("{} {} ({})", kind, id.index + 1, name->second);
}

std::string material_of(const Scene& scene, std::uint32_t index) {
  const auto name = scene.material_names.find(index);
  return name == scene.material_names.end() ? fmt::format("material {}", index)
                                            : fmt::format("material {}", name->second);
}

bool refracts(const Material& m) {
  return m.refraction.most() > 0 ||
         std::any_of(m.textures.begin(), m.textures.end(), [](const TextureUse& use) {
           return use.coefficient == Coefficient::refraction;
         });
}

/// What of a material changes nothing; "" if all does.
std::string useless_optics(const Material& m) {
  const bool disperses = m.dispersion.kind != Dispersion::Kind::none;
  if (refracts(m))
    return m.dispersion.kind == Dispersion::Kind::abbe && m.ior == 1
               ? "its dispersion changes nothing, as its ior is 1"
               : "";
  std::vector<std::string_view> names;
  if (m.fresnel != Fresnel::off) names.push_back("fresnel");
  if (m.absorption != Color{}) names.push_back("absorption");
  if (m.priority != 0) names.push_back("priority");
  if (disperses) names.push_back("dispersion");
  return names.empty() ? ""
                       : fmt::format("its {} change{} nothing, as it refracts no light",
                                     fmt::join(names, ", "), names.size() == 1 ? "s" : "");
}

void lint_materials(const Scene& scene, Diagnostics& all) {
  Warnings specular(all), shares(all), optics(all);
  for (std::uint32_t i = 0; i < scene.materials.size(); ++i) {
    const Material& m = scene.materials[i];
    if (const double ks = std::max({m.specular.r, m.specular.g, m.specular.b}); ks > 1)
      specular.say([&] {
        return fmt::format("{}: its specular share is {}, over 1", material_of(scene, i), ks);
      });
    const double sum = Share(Color{m.reflection.r + m.refraction.r, m.reflection.g + m.refraction.g,
                                   m.reflection.b + m.refraction.b})
                           .most();
    if (sum > 1)
      shares.say([&] {
        return fmt::format("{}: the shares of the reflected and the refracted ray are {}, over 1",
                           material_of(scene, i), sum);
      });
    if (const std::string useless = useless_optics(m); !useless.empty())
      optics.say([&] { return fmt::format("{}: {}", material_of(scene, i), useless); });
  }
}

/// One point of a light that shines from somewhere.
std::optional<Vec3> point_of(const Light& light) {
  if (light.kind == LightKind::directional) return std::nullopt;
  if (light.kind != LightKind::rectangle) return light.position;
  return sum(light.position, sum(light.edge_u, light.edge_v, 0.5, 0.5), 1, 1);
}

void lint_lights(const Scene& scene, Diagnostics& all) {
  if (scene.lights.empty())
    all.push_back({.severity = Severity::warning,
                   .message = "there are no lights: only the ambient light is seen"});
  Warnings noisy(all);
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    if (scene.lights[i].is_surface() && scene.lights[i].samples == 1)
      noisy.say([&] {
        return fmt::format("light {}: its soft shadows are noise, as it has 1 sample", i + 1);
      });
}

/// Whether a cut takes a place away of what is of a material.
bool is_cut_away(const Scene& scene, std::uint32_t material, const Vec3& place) {
  return std::any_of(scene.cuts.begin(), scene.cuts.end(), [&](const Cut& cut) {
    const bool concerns = cut.group == 0 || (material < scene.materials.size() &&
                                             scene.materials[material].cut_group == cut.group);
    return concerns && dot(cut.normal, minus(place, cut.point)) > 0;
  });
}

void lint_cuts(const Scene& scene, Diagnostics& all) {
  Warnings useless(all);
  for (std::size_t i = 0; i < scene.cuts.size(); ++i)
    if (const std::uint32_t group = scene.cuts[i].group;
        group != 0 && std::none_of(scene.materials.begin(), scene.materials.end(),
                                   [&](const Material& m) { return m.cut_group == group; }))
      useless.say([&] {
        return fmt::format("cut {}: it cuts nothing, as no material has the cut_group {}", i + 1,
                           group);
      });
}

void lint_insides(const Scene& scene, Diagnostics& all) {
  Warnings eyes(all), lights(all);
  const Insides insides(scene);
  std::int32_t kind = 0;
  const auto look = [&](const char* name, const auto& objects) {
    for (std::uint32_t i = 0; i < objects.size(); ++i) {
      const auto body = [&] { return name_of(scene, name, {kind, i}); };
      if (insides.has(objects[i], scene.camera.eye) &&
          !is_cut_away(scene, objects[i].material, scene.camera.eye))
        eyes.say([&] { return fmt::format("the eye is inside {}", body()); });
      for (std::size_t l = 0; l < scene.lights.size(); ++l)
        if (const auto point = point_of(scene.lights[l]); point && insides.has(objects[i], *point))
          lights.say([&] { return fmt::format("light {} is inside {}", l + 1, body()); });
    }
    ++kind;
  };
#define ZRAKA_LOOK(Type, plural) look(ShapeTraits<Type>::kName, scene.plural);
  ZRAKA_SHAPES(ZRAKA_LOOK)
#undef ZRAKA_LOOK
}

/// A sphere, or a box along the axes, that refracts.
struct Clear {
  Bounds box;
  std::optional<Sphere> sphere;
  std::int32_t priority;
  const char* kind;
  ShapeId id;
};

/// Whether both have some of their insides in common.
bool overlap(const Clear& a, const Clear& b) {
  const Vec3 lower{std::max(a.box.lower.x, b.box.lower.x), std::max(a.box.lower.y, b.box.lower.y),
                   std::max(a.box.lower.z, b.box.lower.z)};
  const Vec3 upper{std::min(a.box.upper.x, b.box.upper.x), std::min(a.box.upper.y, b.box.upper.y),
                   std::min(a.box.upper.z, b.box.upper.z)};
  if (!(lower.x < upper.x && lower.y < upper.y && lower.z < upper.z)) return false;
  if (a.sphere && b.sphere) {
    const Vec3 d = minus(a.sphere->center, b.sphere->center);
    return std::sqrt(dot(d, d)) < a.sphere->radius + b.sphere->radius;
  }
  if (a.sphere) return b.box.distance_to(a.sphere->center) < a.sphere->radius;
  if (b.sphere) return a.box.distance_to(b.sphere->center) < b.sphere->radius;
  return true;
}

/// Bodies that overlap where priorities say nothing of which one counts, in scenes that have some.
void lint_priorities(const Scene& scene, Diagnostics& all) {
  const bool used = std::any_of(scene.materials.begin(), scene.materials.end(),
                                [](const Material& m) { return m.priority != 0; });
  if (!used) return;
  std::vector<Clear> clear;
  std::int32_t kind = 0;
  const auto add = [&]<class Shape>(const std::vector<Object<Shape>>& objects) {
    if constexpr (std::is_same_v<Shape, Sphere> || std::is_same_v<Shape, Box>)
      for (std::uint32_t i = 0; i < objects.size(); ++i) {
        const Object<Shape>& object = objects[i];
        const Material& m = scene.materials[object.material];
        if (!refracts(m) || (is_body<Shape> && object.transform != 0)) continue;
        clear.push_back({ShapeTraits<Shape>::bounds(object.shape),
                         {},
                         m.priority,
                         ShapeTraits<Shape>::kName,
                         {kind, i}});
        if constexpr (std::is_same_v<Shape, Sphere>) clear.back().sphere = object.shape;
      }
    ++kind;
  };
#define ZRAKA_ADD(Type, plural) add(scene.plural);
  ZRAKA_SHAPES(ZRAKA_ADD)
#undef ZRAKA_ADD
  // Only those whose boxes overlap along x are looked at.
  std::sort(clear.begin(), clear.end(),
            [](const Clear& a, const Clear& b) { return a.box.lower.x < b.box.lower.x; });
  constexpr std::size_t kMostPairs = 10'000'000;
  std::size_t pairs = 0;
  Warnings equal(all);
  for (std::size_t i = 0; i < clear.size(); ++i)
    for (std::size_t j = i + 1; j < clear.size() && clear[j].box.lower.x < clear[i].box.upper.x;
         ++j) {
      if (++pairs > kMostPairs) return;
      if (clear[i].priority == clear[j].priority && overlap(clear[i], clear[j]))
        equal.say([&] {
          const auto& [first, second] = std::minmax(
              clear[i], clear[j], [](const Clear& a, const Clear& b) { return a.id < b.id; });
          return fmt::format("{} and {} overlap, and have the same priority, {}",
                             name_of(scene, first.kind, first.id),
                             name_of(scene, second.kind, second.id), first.priority);
        });
    }
}

void lint_places(const Scene& scene, Diagnostics& all) {
  const Vec3 center = frame_of(scene).center;
  const View view(scene.camera);
  bool seen = false;
  std::int32_t kind = 0;
  Warnings small(all);
  const Whereabouts where(scene);
  const auto look = [&](const char* name, const auto& objects) {
    for (std::uint32_t i = 0; i < objects.size(); ++i) {
      const Bounds box = where.bounds(objects[i]);
      if (!box.bounded()) {
        seen = true;
        continue;
      }
      seen = seen || view.may_see(box);
      // Floats have 24 bits for the way from the eye, and from where the engine's frame is.
      const double away = std::max(box.distance_to(scene.camera.eye), box.distance_to(center));
      if (reach(box) < away * 0x1p-20)
        small.say([&] {
          return fmt::format(
              "{} is too small for where it is: {:.2g} of the way there, where its "
              "edges blur",
              name_of(scene, name, {kind, i}), reach(box) / away);
        });
    }
    ++kind;
  };
#define ZRAKA_LOOK(Type, plural) look(ShapeTraits<Type>::kName, scene.plural);
  ZRAKA_SHAPES(ZRAKA_LOOK)
#undef ZRAKA_LOOK
  if (!seen)
    all.push_back(
        {.severity = Severity::warning,
         .message = scene.shape_count() == 0 ? "there are no shapes" : "nothing is in view",
         .hint = scene.shape_count() == 0 ? "" : "the camera looks past all shapes"});
}

}  // namespace

Diagnostics lint(const Scene& scene) {
  Diagnostics all;
  lint_materials(scene, all);
  lint_cuts(scene, all);
  lint_insides(scene, all);
  lint_priorities(scene, all);
  lint_lights(scene, all);
  lint_places(scene, all);
  return all;
}

}  // namespace zraka
