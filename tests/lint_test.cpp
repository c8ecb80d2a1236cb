// SPDX-License-Identifier: Apache-2.0
// What zraka check finds odd.
#include <gtest/gtest.h>

#include <variant>
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

TEST(Lint, FindsCutsOfNothingAndLetsEyesIntoWhatIsTakenAway) {
  Scene scene = plain_scene();
  add_sphere(scene, {0, 0, 0}, 10, {});
  scene.lights[0].position = {20, 0, 0};
  scene.cuts = {{.point = {0, 0, -1}, .normal = {0, 0, 1}}, {.point = {}, .group = 4}};
  EXPECT_EQ(warnings(scene),
            "warning: cut 2: it cuts nothing, as no material has the cut_group 4\n");
  scene.cuts = {{.point = {0, 0, -1}, .normal = {0, 0, -1}}};
  EXPECT_EQ(warnings(scene), "warning: the eye is inside sphere 2\n");
}

TEST(Lint, FindsEyesAndLightsInAllClosedBodies) {
  const Frustum cone{{0, 0, 0}, 1, {0, 4, 0}, 0};
  const Frustum tube{{0, 0, 0}, 1, {0, 4, 0}, 1, false};
  const Csg hollow{CsgOperation::subtract,
                   {{Box{{-1, -1, -1}, {1, 1, 1}}}, {Ellipsoid{{0, 0, 0}, {0.5, 0.5, 0.5}}}}};
  const Csg half{CsgOperation::intersect,
                 {{Ellipsoid{{0, 0, 0}, {1, 1, 1}}}, {Plane{{0, 0, 0}, {0, 1, 0}}}}};
  const Csg both{CsgOperation::unite,
                 {{Box{{-1, -1, -1}, {0, 0, 0}}}, {Box{{1, 1, 1}, {2, 2, 2}}}}};
  const auto has = [](const AnyBody& body, const Vec3& point) {
    Scene scene = plain_scene();
    scene.lights[0].position = {50, 50, 50};
    scene.camera.eye = point;
    scene.transforms.push_back({{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {10, 0, 0}});
    std::visit(
        [&]<class Body>(const Body& shape) {
#define ZRAKA_PUT(Type, plural) \
  if constexpr (std::is_same_v<Body, Type>) scene.plural.push_back({shape, 0, 1});
          ZRAKA_BODIES(ZRAKA_PUT)
#undef ZRAKA_PUT
        },
        body);
    return warnings(scene).find("the eye is inside") != std::string::npos;
  };
  // In the body's space; the transform takes it to twice that and 10 to the right.
  const auto inside = [&](const AnyBody& body, const Vec3& p) {
    return has(body, {2 * p.x + 10, 2 * p.y, 2 * p.z});
  };
  EXPECT_TRUE(inside(Ellipsoid{{0, 0, 0}, {1, 2, 3}}, {0, 1.99, 0}));
  EXPECT_FALSE(inside(Ellipsoid{{0, 0, 0}, {1, 2, 3}}, {0, 2.01, 0}));
  EXPECT_TRUE(inside(Box{{0, 0, 0}, {1, 1, 1}}, {0.99, 0.99, 0.99}));
  EXPECT_FALSE(inside(Box{{0, 0, 0}, {1, 1, 1}, 0.1}, {0.99, 0.99, 0.99})) << "it is rounded";
  EXPECT_TRUE(inside(Box{{0, 0, 0}, {1, 1, 1}, 0.1}, {0.99, 0.5, 0.5}));
  EXPECT_TRUE(inside(cone, {0.49, 2, 0}));
  EXPECT_FALSE(inside(cone, {0.51, 2, 0}));
  EXPECT_FALSE(inside(tube, {0, 2, 0})) << "it has no caps";
  EXPECT_TRUE(inside(Capsule{{0, 0, 0}, {0, 2, 0}, 1}, {0, 2.99, 0}));
  EXPECT_FALSE(inside(Capsule{{0, 0, 0}, {0, 2, 0}, 1}, {0.8, 2.8, 0}));
  EXPECT_TRUE(inside(Torus{{0, 0, 0}, {0, 0, 1}, 2, 0.5}, {2.4, 0, 0}));
  EXPECT_FALSE(inside(Torus{{0, 0, 0}, {0, 0, 1}, 2, 0.5}, {0, 0, 0})) << "in its hole";
  EXPECT_TRUE(inside(Quadric{}, {0.99, 0, 0}));
  EXPECT_FALSE(inside(Quadric{}, {0.8, 0.8, 0}));
  EXPECT_TRUE(inside(Superellipsoid{{0, 0, 0}, {1, 1, 1}, 0.1, 0.1}, {0.9, 0.9, 0.9}));
  EXPECT_FALSE(inside(Superellipsoid{{0, 0, 0}, {1, 1, 1}, 2, 2}, {0.4, 0.4, 0.4}));
  EXPECT_TRUE(inside(hollow, {0.9, 0, 0}));
  EXPECT_FALSE(inside(hollow, {0.4, 0, 0}));
  EXPECT_TRUE(inside(half, {0, -0.9, 0}));
  EXPECT_FALSE(inside(half, {0, 0.1, 0}));
  EXPECT_TRUE(inside(both, {1.5, 1.5, 1.5}));
  EXPECT_FALSE(inside(both, {0.5, 0.5, 0.5}));
  EXPECT_FALSE(inside(Plane{{0, 0, 0}, {0, 1, 0}}, {0, -1, 0})) << "below the ground is no body";
}

TEST(Lint, FindsEyesAndLightsInGroups) {
  Scene scene = plain_scene();
  scene.groups.emplace_back().tori.push_back({Torus{{0, 0, 0}, {0, 0, 1}, 2, 0.5}, 0, 0});
  scene.transforms.push_back({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}});
  scene.instances.push_back({{0}, 0, 1});
  scene.lights = {{.position = {2, 0, 2}},
                  {.position = {}, .kind = LightKind::directional},
                  {.position = {1, -1, 2},
                   .kind = LightKind::rectangle,
                   .edge_u = {2, 0, 0},
                   .edge_v = {0, 2, 0}}};
  EXPECT_EQ(warnings(scene),
            "warning: light 1 is inside instance 1\nwarning: light 3 is inside instance 1\n");
  scene.camera.eye = {0, 2, 2};
  EXPECT_NE(warnings(scene).find("the eye is inside instance 1"), std::string::npos);
}

TEST(Lint, FindsOpticsThatChangeNothing) {
  Scene scene = plain_scene();
  Material& m = scene.materials[0];
  m.fresnel = Fresnel::exact;
  EXPECT_EQ(warnings(scene),
            "warning: material 0: its fresnel changes nothing, as it refracts no light\n");
  m.absorption = {0, 0, 1};
  m.priority = 1;
  m.dispersion = {Dispersion::Kind::abbe, {60}};
  EXPECT_EQ(warnings(scene),
            "warning: material 0: its fresnel, absorption, priority, dispersion change nothing, as "
            "it refracts no light\n");
  m.refraction = Color{0, 0.5, 0};
  EXPECT_EQ(warnings(scene),
            "warning: material 0: its dispersion changes nothing, as its ior is 1\n");
  m.ior = 1.5;
  EXPECT_EQ(warnings(scene), "");
  m.reflection = Color{0, 0.75, 0};
  EXPECT_EQ(
      warnings(scene),
      "warning: material 0: the shares of the reflected and the refracted ray are 1.25, over 1\n");
}

TEST(Lint, FindsOverlapsThatPrioritiesDoNotSettle) {
  Scene scene = plain_scene();
  const Material glass{.refraction = 0.5, .ior = 1.5, .priority = 1};
  scene.materials[0] = glass;
  add_sphere(scene, {0.9, 0, -2}, 0.5, glass);
  scene.names[{0, 1}] = "lens";
  EXPECT_EQ(warnings(scene),
            "warning: sphere 1 and sphere 2 (lens) overlap, and have the same priority, 1\n");
  scene.spheres[1].shape.center = {0.8, 0.8, -2};
  EXPECT_EQ(warnings(scene), "") << "their boxes overlap, they do not";
  scene.boxes.push_back({Box{{-1, -1, -2}, {1, 1, -1}}, 0, 0});
  EXPECT_NE(warnings(scene).find("sphere 1 and box 1 overlap"), std::string::npos);
  scene.spheres[1].shape.center.x = 5;
  scene.boxes[0].shape = {{0.4, 0.4, -2}, {1, 1, -1}};
  EXPECT_EQ(warnings(scene), "") << "a corner that the sphere does not reach";
  scene.spheres[1].shape.center = {0.9, 0, -2};
  scene.boxes.clear();
  scene.materials[1].priority = 2;
  EXPECT_EQ(warnings(scene), "");
  for (Material& m : scene.materials) m.priority = 0;
  EXPECT_EQ(warnings(scene), "") << "the scene has no priorities";
}

TEST(Lint, FindsNoisyLights) {
  Scene scene = plain_scene();
  scene.lights.push_back({.position = {5, 5, 5}, .kind = LightKind::disc, .samples = 1});
  EXPECT_EQ(warnings(scene), "warning: light 2: its soft shadows are noise, as it has 1 sample\n");
  scene.lights[1].samples = 2;
  EXPECT_EQ(warnings(scene), "");
}

TEST(Lint, KnowsWhatOtherCamerasSee) {
  Scene scene = plain_scene();
  const std::string nothing = "warning: nothing is in view\n  the camera looks past all shapes\n";
  scene.camera.kind = CameraKind::orthographic;  // from (0, 0, 2) to -z, 2 wide and tall
  for (const Vec3& seen : {Vec3{0.9, 0, -2}, {0, -1.4, -50}}) {
    scene.spheres[0].shape.center = seen;
    EXPECT_EQ(warnings(scene), "");
  }
  for (const Vec3& beside :
       {Vec3{1.6, 0, -2}, {-1.6, 0, -2}, {0, 1.6, -50}, {0, -1.6, 0}, {0, 0, 3}}) {
    scene.spheres[0].shape.center = beside;
    EXPECT_EQ(warnings(scene), nothing);
  }
  scene.camera.kind = CameraKind::panorama;
  EXPECT_EQ(warnings(scene), "") << "all round";
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
