// SPDX-License-Identifier: Apache-2.0
// Scenes that several tests look at.
#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>
#include <zraka/zraka.hpp>

namespace zraka {

struct NamedScene {
  std::string name;
  Scene scene;
};

/// The lab's window and eye, one light; spheres and materials are for the test to add.
inline Scene lab_scene(std::uint32_t resolution = 100) {
  Scene scene;
  scene.resolution = {resolution, resolution};
  scene.lights = {{{0, 2, 2}, {1, 1, 1}}};
  scene.defaults.profile = ProfileName::lab;
  return scene;
}

inline void add_sphere(Scene& scene, Vec3 center, double radius, Material material) {
  scene.spheres.push_back({{center, radius}, static_cast<std::uint32_t>(scene.materials.size())});
  scene.materials.push_back(material);
}

/// Spheres inside and through each other, glass that reflects totally, mirrors, two lights.
inline Scene tangled_scene(std::uint32_t resolution = 100) {
  Scene scene = lab_scene(resolution);
  scene.lights.push_back({{-3, 1, 0}, {0.3, 0.5, 0.9}});
  scene.background = {0.1, 0.2, 0.3};
  std::mt19937 random(3);
  const auto unit = [&] { return static_cast<double>(random() % 1000) / 1000; };
  for (int i = 0; i < 40; ++i) {
    const Material m{.ambient = {unit() / 3, unit() / 3, unit() / 3},
                     .diffuse = {unit(), unit(), unit()},
                     .specular = {unit(), unit(), unit()},
                     .shininess = 1 + 100 * unit(),
                     .reflection = i % 3 == 0 ? 0.5 * unit() : 0,
                     .refraction = i % 2 == 0 ? 0.9 * unit() : 0,
                     .ior = 0.5 + unit()};
    add_sphere(scene, {3 * unit() - 1.5, 3 * unit() - 1.5, -1 - 3 * unit()}, 0.1 + 0.5 * unit(), m);
  }
  add_sphere(scene, {0, 0, -2}, 0.8, {.reflection = 0.1, .refraction = 0.8, .ior = 0.667});
  add_sphere(scene, {0, 0, -2}, 0.4, {.diffuse = {1, 0, 0}});
  return scene;
}

/// Shapes of all kinds, matt, mirrors and glass.
inline Scene mixed_scene(std::uint32_t resolution = 100) {
  Scene scene = lab_scene(resolution);
  scene.lights.push_back({{-3, 1, 0}, {0.3, 0.5, 0.9}});
  std::mt19937 random(9);
  const auto unit = [&] { return static_cast<double>(random() % 1000) / 1000; };
  const auto near = [&](const Vec3& v, double by) {
    const double x = unit(), y = unit(), z = unit();
    return Vec3{v.x + by * (x - 0.5), v.y + by * (y - 0.5), v.z + by * (z - 0.5)};
  };
  for (int i = 0; i < 200; ++i) {
    const Vec3 at = near({0, 0, -2.5}, 3), b = near(at, 1), c = near(at, 1);
    const auto material = static_cast<std::uint32_t>(scene.materials.size());
    const double red = unit(), green = unit(), blue = unit();
    scene.materials.push_back({.diffuse = {red, green, blue},
                               .specular = {0.4, 0.4, 0.4},
                               .shininess = 30,
                               .reflection = i % 3 == 0 ? 0.4 : 0,
                               .refraction = i % 5 == 0 ? 0.7 : 0,
                               .ior = 1.3});
    if (i % 4 == 0) scene.spheres.push_back({{at, 0.05 + 0.2 * unit()}, material});
    if (i % 4 == 1) scene.triangles.push_back({{at, b, c}, material});
    if (i % 4 == 2)
      scene.smooth_triangles.push_back(
          {{at, b, c, {0.3, 0, 1}, {0, 0.2, 1}, {-0.3, 0.1, 1}}, material});
    if (i % 4 == 3) scene.cones.push_back({{at, 0.1, b, 0.1 * unit()}, material});
  }
  return scene;
}

/// Cones as flat as paper and triangles seen edge-on: their intersections are all rounding.
inline Scene noisy_scene(std::uint32_t resolution = 100) {
  Scene scene = lab_scene(resolution);
  scene.materials = {{.diffuse = {0.7, 0.5, 0.3}, .reflection = 0.3}};
  std::mt19937 random(4);
  const auto unit = [&] { return static_cast<double>(random() % 100000) / 100000; };
  for (int i = 0; i < 600; ++i) {
    const double x = 3 * unit() - 1.5, y = 3 * unit() - 1.5, z = -1 - 2 * unit();
    const double height = std::pow(10.0, -8 + 6 * unit());
    scene.cones.push_back({{{x, y, z},
                            0.05 + 0.15 * unit(),
                            {x + height * unit(), y + height, z + height * unit()},
                            0},
                           0});
  }
  // In a plane through the eye at (0, 0, 2).
  const auto in_plane = [&] {
    const double a = 4 * unit() - 2, b = -4 * unit();
    return Vec3{a, 0.3 * a + 0.2 * b, 2 + b};
  };
  for (int i = 0; i < 1000; ++i) {
    const Vec3 a = in_plane(), b = in_plane(), c = in_plane();
    scene.triangles.push_back({{a, b, c}, 0});
  }
  return scene;
}

/// The project's own scenes, and some that are made here.
inline std::vector<NamedScene> test_scenes(std::uint32_t resolution = 200) {
  std::vector<NamedScene> scenes;
  for (const char* name : {"input", "letter"}) {
    const std::string path = std::string(ZRAKA_SOURCE_DIR "/scenes/lab/") + name + ".txt";
    scenes.push_back({name, read_scene(path).value().scene});
    scenes.back().scene.resolution = {resolution, resolution};
  }
  scenes.push_back({"tangled", tangled_scene(resolution)});
  scenes.push_back({"mixed", mixed_scene(resolution)});
  Scene other_eye = tangled_scene(resolution);
  other_eye.camera.eye = {0.7, -0.4, 3};
  other_eye.camera.window_right = {3, 0, 0};
  other_eye.camera.window_up = {0, 3, 0};
  other_eye.resolution = {157, 157};
  scenes.push_back({"tangled from another eye", other_eye});
  return scenes;
}

/// Share of the pixels whose channels all agree to within `tolerance`, after clamping to 0…1.
inline double agreement(const Image& a, const Image& b, float tolerance) {
  std::size_t good = 0;
  const auto clamped = [](float v) { return std::fmin(std::fmax(v, 0.0f), 1.0f); };
  for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
    bool same = true;
    for (std::size_t c = i; c < i + 3; ++c)
      same = same && std::fabs(clamped(a.pixels[c]) - clamped(b.pixels[c])) <= tolerance;
    good += same;
  }
  return static_cast<double>(3 * good) / static_cast<double>(a.pixels.size());
}

}  // namespace zraka
