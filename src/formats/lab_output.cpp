// SPDX-License-Identifier: Apache-2.0
// Writer of the course's input.txt.
#include <fmt/format.h>

#include "core/append.hpp"
#include "formats/losses.hpp"
#include "formats/writers.hpp"

namespace zraka {

Result<std::string> write_lab_input(const Scene& scene) {
  const Camera& camera = scene.camera;
  const double size = camera.window_right.x;
  const auto refuse = [](const char* what) {
    return failure("", fmt::format("the course's input.txt format cannot say {}", what));
  };
  if (camera.window_center != Vec3{} || camera.window_right != Vec3{size, 0, 0} ||
      camera.window_up != Vec3{0, size, 0} || scene.resolution.width != scene.resolution.height)
    return refuse(
        "where this scene's window is: it knows squares in the plane z = 0 around the origin");
  if (camera.kind != CameraKind::pinhole)
    return refuse("what this scene's camera is: it knows pinholes alone");
  if (scene.lights.size() != 1 || scene.lights[0].color != Color{1, 1, 1})
    return refuse("these lights: it knows one white light");
  if (scene.lights[0].kind != LightKind::point)
    return refuse("this light: it knows those that shine from a point into all directions");
  if (scene.sky.kind != Sky::Kind::flat || scene.background != Color{} ||
      scene.ambient_light != Color{0.5, 0.5, 0.5})
    return refuse("another background than black or another ambient light than 0.5");
  if (scene.shape_count() != scene.spheres.size()) return refuse("other shapes than spheres");

  std::string text;
  const Vec3 &eye = camera.eye, &light = scene.lights[0].position;
  append(text, "<polozaj oka => {}, {}, {}:\n\n", eye.x, eye.y, eye.z);
  append(text, "<velicina prozora => {}:\n<rezolucija prozora => {}:\n\n", size,
         scene.resolution.width);
  append(text, "<pozicija svijetla => {}, {}, {}:\n<broj objekata u sceni => {}:\n", light.x,
         light.y, light.z, scene.spheres.size());
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    const Sphere& s = scene.spheres[i].shape;
    const Material& m = scene.materials.at(scene.spheres[i].material);
    const auto name = scene.names.find({0, static_cast<std::uint32_t>(i)});
    const bool named = name != scene.names.end() && name->second.find('>') == std::string::npos;
    append(text, "\n<parametri {}. kugle{}>\n", i + 1, named ? ": " + name->second : "");
    append(text, "\t<polozaj => {}, {}, {}:\n\t<radius => {}:\n", s.center.x, s.center.y,
           s.center.z, s.radius);
    append(text, "\t<udio reflektirane zrake => {}:\n\t<udio refraktirane zrake => {}:\n",
           m.reflection.r, m.refraction.r);
    const auto color = [&](const char* label, const Color& c) {
      append(text, "\t<{} => {}, {}, {}:\n", label, c.r, c.g, c.b);
    };
    color("ambientna komponenta ka", m.ambient);
    color("difuzna komponenta kd", m.diffuse);
    color("spekularna komponenta ks", m.specular);
    append(text, "\t<n => {}:\n\t<faktor refrakcije ni => {}:\n", m.shininess, m.ior);
  }
  return text;
}

Result<WrittenScene> write_lab_scene(const Scene& scene) {
  const Result<std::string> text = write_lab_input(scene);
  if (!text) return tl::make_unexpected(text.error());
  Losses losses;
  losses.defaults(scene, {.profile = ProfileName::lab});
  losses.light(scene.lights[0]);
  losses.surroundings(scene);
  for (const Object<Sphere>& sphere : scene.spheres)
    losses.material(scene.materials[sphere.material]);
  return WrittenScene{*text, losses.diagnostics("input.txt")};
}

}  // namespace zraka
