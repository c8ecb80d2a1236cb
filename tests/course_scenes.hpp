// SPDX-License-Identifier: Apache-2.0
// Scenes that show students' mistakes.
#pragma once

#include <zraka/school/school.hpp>

#include "scenes.hpp"

namespace zraka {

#ifdef ZRAKA_SANITIZED
inline constexpr std::uint32_t kSide = 48;
#else
inline constexpr std::uint32_t kSide = 128;
#endif

inline Material glassy(Color color, double k1, double k2, double ratio) {
  return {.ambient = {color.r * 0.3, color.g * 0.3, color.b * 0.3},
          .diffuse = color,
          .specular = {0.6, 0.7, 0.8},
          .shininess = 12,
          .reflection = k1,
          .refraction = k2,
          .ior = ratio};
}

/// A ground, glass in front of coloured spheres, mirrors that face each other, and a body behind
/// the light: all that mistakes need to be seen.
inline Scene course_scene() {
  Scene scene = lab_scene(kSide);
  scene.lights = {{{-1.5, 2.5, 1}, {1, 1, 1}}};
  scene.ambient_light = {0.5, 0.5, 0.5};
  add_sphere(scene, {0, -101, -3}, 100, glassy({0.5, 0.5, 0.6}, 0.2, 0, 1));
  add_sphere(scene, {0.1, 0.1, -2}, 0.8, glassy({0.1, 0.1, 0.1}, 0.1, 0.8, 0.67));
  add_sphere(scene, {-1.2, 0, -3.5}, 0.9, glassy({0.6, 0.2, 0.2}, 0.7, 0, 1));
  add_sphere(scene, {1.4, 0.2, -3}, 0.9, glassy({0.2, 0.7, 0.3}, 0.6, 0, 1));
  add_sphere(scene, {0.3, 0.9, -5}, 0.8, glassy({0.8, 0.7, 0.1}, 0, 0, 1));
  add_sphere(scene, {-2.6, 4.2, 2}, 0.7, glassy({0.9, 0.9, 0.9}, 0, 0, 1));  // behind the light
  add_sphere(scene, {0.5, 0.2, -1}, 0.25, glassy({0.1, 0.2, 0.6}, 0.3, 0.5, 1.4));
  return scene;
}

/// Two lights, glass in glass.
inline Scene second_scene() {
  Scene scene = course_scene();
  scene.lights.push_back({{2, 1, 2}, {0.6, 0.5, 0.4}});
  scene.spheres[1].shape = {{-0.3, 0, -1.6}, 0.7};
  add_sphere(scene, {-0.3, 0, -1.6}, 0.3, glassy({0.2, 0.05, 0.05}, 0.2, 0.6, 1.6));
  return scene;
}

inline Scene third_scene() {
  Scene scene = lab_scene(kSide);
  scene.ambient_light = {0.4, 0.5, 0.6};
  scene.lights = {{{1.5, 1.2, -1}, {0.9, 1, 0.8}}};
  add_sphere(scene, {0, 0, -4}, 1.2, glassy({0.7, 0.3, 0.1}, 0.4, 0, 1));
  for (int i = 0; i < 5; ++i)
    add_sphere(
        scene, {-1.1 + 0.55 * i, -0.5 + 0.2 * (i % 3), -1.2 - 0.3 * i}, 0.35,
        glassy({0.1 * i, 0.3, 0.6 - 0.1 * i}, 0.15 * i, i % 2 == 0 ? 0.7 : 0, 0.7 + 0.15 * i));
  add_sphere(scene, {2.4, 2.0, -0.5}, 0.4, glassy({0.9, 0.9, 0.9}, 0, 0, 1));
  return scene;
}

inline RenderOptions lab_options(Stage stage = Stage::refraction) {
  return {.terms = terms_of(stage), .profile = profile_of(ProfileName::lab)};
}

}  // namespace zraka
