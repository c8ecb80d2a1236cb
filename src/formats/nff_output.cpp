// SPDX-License-Identifier: Apache-2.0
// Writer of NFF, and of what a scene loses by it.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>

#include "formats/losses.hpp"
#include "formats/vectors.hpp"
#include "formats/writers.hpp"
#include "shapes/bodies.hpp"

namespace zraka {
namespace {

double plain_length(const Vec3& a) {
  return std::sqrt(dot(a, a));
}

std::string words(const Vec3& v) {
  return fmt::format("{} {} {}", v.x, v.y, v.z);
}

std::string words(const Color& c) {
  return fmt::format("{} {} {}", c.r, c.g, c.b);
}

/// The view of a window that the eye looks at straight, in pixels that are square; none of others.
std::optional<std::string> view_of(const Scene& scene) {
  constexpr double kExact = 1e-9;
  const Camera& c = scene.camera;
  const Vec3 along{c.window_center.x - c.eye.x, c.window_center.y - c.eye.y,
                   c.window_center.z - c.eye.z};
  const double away = plain_length(along), wide = plain_length(c.window_right),
               tall = plain_length(c.window_up);
  const double aspect = static_cast<double>(scene.resolution.width) / scene.resolution.height;
  const auto askew = [&](const Vec3& a, const Vec3& b) {
    return !(std::fabs(dot(a, b)) <= kExact * plain_length(a) * plain_length(b));
  };
  // The reader's right is where along × up points.
  const Vec3 right{along.y * c.window_up.z - along.z * c.window_up.y,
                   along.z * c.window_up.x - along.x * c.window_up.z,
                   along.x * c.window_up.y - along.y * c.window_up.x};
  if (!(away > 0 && tall > 0) || askew(along, c.window_right) || askew(along, c.window_up) ||
      askew(c.window_right, c.window_up) || !(dot(right, c.window_right) > 0) ||
      !(std::fabs(wide - aspect * tall) <= kExact * wide))
    return std::nullopt;
  const double angle = std::atan2(tall / 2, away) * 360 / 3.14159265358979323846;
  return fmt::format("v\nfrom {}\nat {}\nup {}\nangle {}\nhither 0\nresolution {} {}\n",
                     words(c.eye), words(c.window_center), words(c.window_up), angle,
                     scene.resolution.width, scene.resolution.height);
}

Vec3 middle_of(const Light& light) {
  const Vec3 &p = light.position, &u = light.edge_u, &v = light.edge_v;
  if (light.kind != LightKind::rectangle) return p;
  return {p.x + (u.x + v.x) / 2, p.y + (u.y + v.y) / 2, p.z + (u.z + v.z) / 2};
}

class Writer {
 public:
  explicit Writer(const Scene& scene) : scene_(scene) {}

  Result<WrittenScene> write();

 private:
  void write_material(std::uint32_t index);
  template <class Shape>
  void write_all(const std::vector<Object<Shape>>& objects);
  void write(const Sphere& s);
  void write(const Cone& c);
  void write(const Triangle& t);
  void write(const SmoothTriangle& t);
  void put(std::string_view text) { written_.text += text; }

  const Scene& scene_;
  WrittenScene written_;
  Losses losses_;
  std::optional<std::uint32_t> material_;
};

void Writer::write_material(std::uint32_t index) {
  if (material_ == index) return;
  material_ = index;
  const Material& m = scene_.materials[index];
  const Color& c = m.diffuse;
  const double ks = m.specular.r;
  losses_.count("materials: another ambient share than the diffuse one", m.ambient != c);
  losses_.count("materials: the highlight's colour", m.specular != Color{ks, ks, ks});
  losses_.count("materials: another share of the reflected ray than of the highlight",
                m.reflection.r != ks);
  losses_.material(m);
  put(fmt::format("f {} 1 {} {} {} {}\n", words(c), ks, m.shininess, m.refraction.r, m.ior));
}

void Writer::write(const Sphere& s) {
  put(fmt::format("s {} {}\n", words(s.center), s.radius));
}

void Writer::write(const Cone& c) {
  put(fmt::format("c\n{} {}\n{} {}\n", words(c.base), c.base_radius, words(c.apex), c.apex_radius));
}

void Writer::write(const Triangle& t) {
  put(fmt::format("p 3\n{}\n{}\n{}\n", words(t.a), words(t.b), words(t.c)));
}

void Writer::write(const SmoothTriangle& t) {
  put(fmt::format("pp 3\n{} {}\n{} {}\n{} {}\n", words(t.a), words(t.normal_a), words(t.b),
                  words(t.normal_b), words(t.c), words(t.normal_c)));
}

template <class Shape>
void Writer::write_all(const std::vector<Object<Shape>>& objects) {
  for (const Object<Shape>& object : objects) {
    write_material(object.material);
    write(object.shape);
  }
}

Result<WrittenScene> Writer::write() {
  if (scene_.camera.kind != CameraKind::pinhole)
    return failure("", "NFF cannot say what this scene's camera is: it knows pinholes alone");
  const std::optional<std::string> view = view_of(scene_);
  if (!view)
    return failure("",
                   "NFF cannot say where this scene's window is: it knows those that the eye "
                   "looks at straight");
  put(fmt::format("b {}\n{}", words(scene_.background), *view));
  for (const Light& light : scene_.lights) {
    losses_.light(light);
    if (light.kind == LightKind::directional) continue;
    put(fmt::format("l {} {}\n", words(middle_of(light)), words(light.color)));
  }
  losses_.surroundings(scene_);
  const auto n = static_cast<double>(std::max<std::size_t>(1, scene_.lights.size()));
  const double ambient = std::sqrt(n) / (2 * n);
  losses_.count("the ambient light, which NFF's rule gives",
                scene_.ambient_light != Color{ambient, ambient, ambient});
  losses_.count("names", scene_.names.size());
  losses_.defaults(scene_, {});
#define ZRAKA_WRITE(Type, plural) write_all(scene_.plural);
  ZRAKA_PRIMITIVES(ZRAKA_WRITE)
#undef ZRAKA_WRITE
#define ZRAKA_COUNT(Type, plural) \
  losses_.count(fmt::format("shapes: {}", ShapeTraits<Type>::kName), scene_.plural.size());
  ZRAKA_BODIES(ZRAKA_COUNT)
#undef ZRAKA_COUNT
  written_.losses = losses_.diagnostics("NFF");
  return std::move(written_);
}

}  // namespace

Result<WrittenScene> write_nff(const Scene& scene) {
  return Writer(scene).write();
}

}  // namespace zraka
