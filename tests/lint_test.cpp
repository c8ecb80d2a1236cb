// SPDX-License-Identifier: Apache-2.0
// What zraka check finds odd.
#include <gtest/gtest.h>

#include <zraka/lint.hpp>

#include "scenes.hpp"

namespace zraka {
namespace {

std::string warnings(const Scene& scene) {
  std::string all;
  for (const Diagnostic& d : lint(scene)) all += to_string(d);
  return all;
}

/// A sphere before the lab's window, a light above.
Scene plain_scene() {
  Scene scene = lab_scene();
  add_sphere(scene, {0, 0, -2}, 0.5, {});
  return scene;
}

TEST(Lint, HasNothingAgainstThisProjectsScenes) {
  EXPECT_EQ(warnings(plain_scene()), "");
  for (const char* path : {"lab/input.txt", "lab/letter.txt", "nff/benzene.nff"})
    EXPECT_EQ(warnings(read_scene(std::string(ZRAKA_SOURCE_DIR "/scenes/") + path).value().scene),
              "")
        << path;
}

TEST(Lint, FindsMaterialsThatGiveBackMoreThanTheyGet) {
  Scene scene = plain_scene();
  scene.materials[0] = {.specular = {0, 1.5, 0}, .reflection = 0.75, .refraction = 0.5};
  EXPECT_EQ(
      warnings(scene),
      "warning: material 0: its specular share is 1.5, over 1\n"
      "warning: material 0: the shares of the reflected and the refracted ray are 1.25, over 1\n");
  scene.materials[0] = {.reflection = 1};
  scene.material_names[0] = "mirror";
  EXPECT_EQ(warnings(scene), "");
  scene.materials[0].specular = {2, 0, 0};
  EXPECT_EQ(warnings(scene), "warning: material mirror: its specular share is 2, over 1\n");
}

TEST(Lint, FindsEyesAndLightsInSpheres) {
  Scene scene = plain_scene();
  scene.names[{0, 1}] = "room";
  add_sphere(scene, {0, 0, 0}, 10, {});
  EXPECT_EQ(warnings(scene),
            "warning: the eye is inside sphere 2 (room)\n"
            "warning: light 1 is inside sphere 2 (room)\n");
  scene.lights[0].position = {20, 0, 0};
  scene.camera.eye = {0, 0, 11};
  EXPECT_EQ(warnings(scene), "");
}

TEST(Lint, FindsScenesOfWhichNothingIsSeen) {
  Scene scene = plain_scene();
  scene.spheres[0].shape.center = {0, 0, 5};
  EXPECT_EQ(warnings(scene), "warning: nothing is in view\n  the camera looks past all shapes\n")
      << "behind the eye";
  for (const Vec3& beside : {Vec3{4, 0, 0}, {-4, 0, 0}, {0, 4, 0}, {0, -4, 0}}) {
    scene.spheres[0].shape.center = beside;
    EXPECT_NE(warnings(scene), "");
  }
  scene.spheres.clear();
  scene.lights.clear();
  EXPECT_EQ(warnings(scene),
            "warning: there are no lights: only the ambient light is seen\n"
            "warning: there are no shapes\n");
}

TEST(Lint, FindsShapesTooSmallForFloats) {
  Scene scene = plain_scene();
  scene.camera.eye = {0, 0, 8};
  for (int i = 0; i < 5; ++i) add_sphere(scene, {0, 0, -2}, 1e-7, {});
  const std::string rest =
      " is too small for where it is: 2e-08 of the way there, where its edges blur\n";
  EXPECT_EQ(warnings(scene), "warning: sphere 2" + rest + "warning: sphere 3" + rest +
                                 "warning: sphere 4" + rest + "warning: and 2 more like this\n");
}

TEST(Lint, FindsNothingSmallOnAGroundOfAnySize) {
  for (const double radius : {1e3, 3e7, 1e11}) {
    Scene scene = plain_scene();
    add_sphere(scene, {0, -radius - 1, 0}, radius, {});
    EXPECT_EQ(warnings(scene), "") << radius;
  }
}

}  // namespace
}  // namespace zraka
