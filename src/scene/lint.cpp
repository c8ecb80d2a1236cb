// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <zraka/lint.hpp>

#include "scene/freeze.hpp"
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
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The sides of what a camera sees: normals that point inwards, of planes through the eye, or
/// through the window's edges where rays are parallel.
class View {
 public:
  explicit View(const Camera& camera)
      : knows_(camera.kind == CameraKind::pinhole || camera.kind == CameraKind::orthographic) {
    if (!knows_) return;
    const bool parallel = camera.kind == CameraKind::orthographic;
    const Vec3 ahead = minus(camera.window_center, camera.eye);
    const auto corner = [&](double right, double up) {
      const Vec3 &c = camera.window_center, &r = camera.window_right, &u = camera.window_up;
      return minus({c.x + right * r.x + up * u.x, c.y + right * r.y + up * u.y,
                    c.z + right * r.z + up * u.z},
                   parallel ? c : camera.eye);
    };
    const Vec3 corners[] = {corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5),
                            corner(-0.5, 0.5)};
    for (int i = 0; i < 4; ++i) {
      const Vec3 &from = corners[i], &to = corners[(i + 1) % 4], &beyond = corners[(i + 2) % 4];
      const Vec3 side = parallel ? cross(ahead, minus(to, from)) : cross(from, to);
      const double inwards = dot(side, parallel ? minus(beyond, from) : corner(0, 0)) < 0 ? -1 : 1;
      const Vec3& eye = camera.eye;
      points_[i] = parallel ? Vec3{eye.x + from.x, eye.y + from.y, eye.z + from.z} : eye;
      sides_[i] = {side.x * inwards, side.y * inwards, side.z * inwards};
    }
  }

  /// True for some boxes beyond an edge of the view, too.
  bool may_see(const Bounds& box) const {
    if (!knows_) return true;
    for (int i = 0; i < 4; ++i) {
      const Vec3& n = sides_[i];
      const Vec3 farthest{n.x > 0 ? box.upper.x : box.lower.x, n.y > 0 ? box.upper.y : box.lower.y,
                          n.z > 0 ? box.upper.z : box.lower.z};
      if (dot(n, minus(farthest, points_[i])) < 0) return false;
    }
    return true;
  }

 private:
  bool knows_;  ///< others look all round
  Vec3 points_[4], sides_[4];
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

void lint_materials(const Scene& scene, Diagnostics& all) {
  Warnings specular(all), shares(all);
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
  }
}

void lint_insides(const Scene& scene, Diagnostics& all) {
  Warnings eyes(all), lights(all);
  const auto inside = [](const Vec3& p, const Sphere& s) {
    const Vec3 d = minus(p, s.center);
    return dot(d, d) < s.radius * s.radius;
  };
  for (std::uint32_t i = 0; i < scene.spheres.size(); ++i) {
    const Sphere& s = scene.spheres[i].shape;
    if (inside(scene.camera.eye, s))
      eyes.say([&] {
        return fmt::format("the eye is inside {}", name_of(scene, "sphere", {0, i}));
      });
    for (std::size_t l = 0; l < scene.lights.size(); ++l)
      if (inside(scene.lights[l].position, s))
        lights.say([&] {
          return fmt::format("light {} is inside {}", l + 1, name_of(scene, "sphere", {0, i}));
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
  lint_insides(scene, all);
  if (scene.lights.empty())
    all.push_back({.severity = Severity::warning,
                   .message = "there are no lights: only the ambient light is seen"});
  lint_places(scene, all);
  return all;
}

}  // namespace zraka
