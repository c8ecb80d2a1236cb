// SPDX-License-Identifier: Apache-2.0
// Sizes far apart in one scene: what floats are spent on, and what is said where they do not do.
#include <gtest/gtest.h>

#include <cmath>

#include "picture_of.hpp"
#include "scene/freeze.hpp"
#include "scenes.hpp"

namespace zraka {
namespace {

#ifdef ZRAKA_SANITIZED
constexpr std::uint32_t kSide = 32;
#else
constexpr std::uint32_t kSide = 120;
#endif

double against_oracle(const Scene& scene) {
  return agreement(picture_of(scene), picture_of(scene, {.isa = Isa::oracle}), 1.0f / 255);
}

/// What is wrong with a scene, each problem a line.
std::string problems_of(const Scene& scene) {
  std::string all;
  for (const Diagnostic& problem : check(scene)) all += to_string(problem);
  return all;
}

/// An eye 5 in front of small balls, which lie on y = -1; light from the right and above.
Scene balls(int count) {
  Scene scene;
  scene.resolution = {kSide, kSide};
  scene.camera = {{0, 0, 5}, {0, 0, 4}, {1, 0, 0}, {0, 1, 0}};
  scene.lights = {{{3, 6, 4}, {0.8, 0.8, 0.8}}};
  scene.background = {0.3, 0.4, 0.6};
  scene.materials = {{.diffuse = {0.8, 0.4, 0.2}, .specular = {0.3, 0.3, 0.3}, .reflection = 0.2},
                     {.diffuse = {0.3, 0.6, 0.3}, .reflection = 0.1}};
  const double radius = count == 1 ? 1 : count < 4 ? 0.6 : 0.2;
  for (int i = 0; i < count; ++i) {
    const double x = count < 4 ? 1.3 * (i - (count - 1) / 2.0) : 0.5 * (i % 10 - 4.5);
    scene.spheres.push_back({{{x, radius - 1, count < 4 ? 0 : 1 - 0.6 * (i / 10)}, radius}, 0});
  }
  return scene;
}

void add_ground_sphere(Scene& scene, double radius) {
  scene.spheres.push_back({{{0, -1 - radius, 0}, radius}, 1});
}

/// The scene mirrored up and down: its picture is the same, but of two values the median is the
/// upper one.
Scene upside_down(Scene scene) {
  const auto turn = [](Vec3& v) { v.y = -v.y; };
  turn(scene.camera.eye), turn(scene.camera.window_center), turn(scene.camera.window_up);
  for (Light& light : scene.lights) turn(light.position);
  for (auto& sphere : scene.spheres) turn(sphere.shape.center);
  return scene;
}

/// The plane y = -1, tilted about the z axis.
void add_ground_triangle(Scene& scene, double reach, double tilt = 0) {
  const auto point = [&](double x, double z) {
    return Vec3{x * std::cos(tilt), x * std::sin(tilt) - 1, z};
  };
  scene.triangles.push_back({{point(-reach, -reach), point(reach, -reach), point(0, reach)}, 1});
}

TEST(Frame, HoldsGroundSpheresOfAnySizeUnderSmallOnes) {
  for (const int count : {1, 2, 3, 100}) {
    Scene plane = balls(count);
    add_ground_triangle(plane, 1e4);
    const Image want = picture_of(plane);
    for (double radius = 1e2; radius < 2e12; radius *= 10) {
      Scene scene = balls(count);
      add_ground_sphere(scene, radius);
      EXPECT_GE(against_oracle(scene), 0.9995) << count << " on " << radius;
      EXPECT_GE(agreement(picture_of(scene), picture_of(upside_down(scene)), 1.0f / 255), 0.9995)
          << count << " under " << radius;
      // The horizon lies √(2·4/r) lower than a plane's; the view is 1/5 of a right angle high.
      const double lower = std::sqrt(8 / radius);
      if (radius >= 1e4) {
        EXPECT_GE(agreement(picture_of(scene), want, 2.0f / 255), 0.985 - lower)
            << count << " on " << radius;
      }
    }
  }
}

TEST(Frame, HoldsLargeTriangles) {
  for (const int count : {1, 3, 100})
    for (const double tilt : {0.0, 0.1}) {
      Scene plane = balls(count);
      add_ground_triangle(plane, 1e3, tilt);
      const Image want = picture_of(plane);
      for (double reach = 1e3; reach < 2e12; reach *= 1000) {
        Scene scene = balls(count);
        add_ground_triangle(scene, reach, tilt);
        EXPECT_GE(against_oracle(scene), 0.999) << count << " on " << reach;
        EXPECT_GE(agreement(picture_of(scene), want, 2.0f / 255), 0.985)
            << count << " on " << reach;
      }
    }
}

TEST(Frame, HoldsLargeSmoothTriangles) {
  // With equal normals they are flat; with others the pieces of one are shaded as it would be.
  for (const double bend : {0.0, 1e-4}) {
    const auto add = [&](Scene& scene, double reach) {
      const double by = bend * reach;
      scene.smooth_triangles.push_back({{{-reach, -1, -reach},
                                         {reach, -1, -reach},
                                         {0, -1, reach},
                                         {-by, 1, 0},
                                         {by, 1, 0},
                                         {0, 1, by}},
                                        1});
    };
    Scene small = balls(2), large = balls(2);
    add(small, 1e2);
    add(large, 1e5);
    EXPECT_GE(against_oracle(large), 0.999);
    // So far away its normals are the middle's.
    if (bend == 0) {
      EXPECT_GE(agreement(picture_of(large), picture_of(small), 2.0f / 255), 0.97);
    }
  }
}

TEST(Frame, HoldsRoomsOfLargeSpheres) {
  Image before;
  for (const double radius : {1e5, 1e6, 1e9, 1e12}) {
    Scene scene = balls(2);
    add_ground_sphere(scene, radius);
    for (const Vec3 way : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, -1}})
      scene.spheres.push_back(
          {{{way.x * (radius + 4), way.y * (radius + 8), way.z * (radius + 4)}, radius}, 1});
    EXPECT_GE(against_oracle(scene), 0.9995) << radius;
    const Image now = picture_of(scene);
    EXPECT_GE(agreement(now, picture_of(upside_down(scene)), 1.0f / 255), 0.9995) << radius;
    if (!before.pixels.empty()) {
      EXPECT_GE(agreement(now, before, 2.0f / 255), 0.99) << radius;
    }
    before = now;
  }
}

TEST(Frame, IsNotMovedByWhatNothingCanSee) {
  for (const double radius : {10.0, 1e2, 1e4, 1e6, 3e7, 1e9, 1e12}) {
    Scene scene = balls(1);
    add_ground_sphere(scene, radius);
    const Image want = picture_of(scene);
    // Just above the eye the ground is nearest, 1 away.
    const auto frame_is_on_what_is_seen = [](const Scene& one) {
      return std::fabs(frame_of(one).center.z - 4) < 0.01;
    };
    EXPECT_FALSE(frame_is_on_what_is_seen(scene));
    EXPECT_EQ(frame_is_on_what_is_seen(upside_down(scene)), radius >= 1e4);
    Scene inside = scene, below = scene, behind = scene;
    for (const double x : {0.0, 0.1}) inside.spheres.push_back({{{x, 0, 0}, 0.3}, 0});
    for (int i = 0; i < 5; ++i)
      below.spheres.push_back({{{0, -1 - radius, 0.01 * radius * i}, 0.1 * radius}, 0});
    for (int i = 0; i < 40; ++i) behind.spheres.push_back({{{1e9 + 1e7 * i, 1e9, 1e9}, 2e6}, 0});
    for (const Scene* more : {&inside, &below, &behind}) {
      EXPECT_GE(agreement(picture_of(*more), want, 1.0f / 255), 0.9995) << radius;
      const Scene turned = upside_down(*more);
      EXPECT_GE(agreement(picture_of(turned), want, 1.0f / 255), 0.9995) << radius;
      // With those inside the ball the median is the ball's; no bit moves where it is not.
      if (more == &inside || radius < 1e4) continue;
      EXPECT_TRUE(frame_is_on_what_is_seen(turned));
      EXPECT_EQ(sha256(picture_of(turned)), sha256(picture_of(upside_down(scene)))) << radius;
    }
  }
}

TEST(Frame, StaysOnTheMedianOfShapesThatAreSeenFromAmongThem) {
  for (const NamedScene& named : test_scenes(8)) {
    std::vector<double> x;
    const auto add = [&](const auto& objects) {
      for (const auto& object : objects) {
        const Bounds box =
            ShapeTraits<std::remove_cvref_t<decltype(object.shape)>>::bounds(object.shape);
        x.push_back(box.lower.x / 2 + box.upper.x / 2);
      }
    };
#define ZRAKA_ADD(Type, plural) add(named.scene.plural);
    ZRAKA_PRIMITIVES(ZRAKA_ADD)
#undef ZRAKA_ADD
    std::sort(x.begin(), x.end());
    EXPECT_EQ(frame_of(named.scene).center.x, x[x.size() / 2]) << named.name;
  }
}

TEST(Frame, FollowsANarrowViewToWhatItSees) {
  // From ten thousand away, through a window as wide as the balls.
  Scene near = balls(3), far = balls(3);
  for (Scene* scene : {&near, &far}) add_ground_sphere(*scene, 1e7);
  near.camera = {{0, 20, 100}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  far.camera = {{0, 2e3, 1e4}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  // Eye and directions are rounded by a fiftieth of a pixel.
  EXPECT_GE(against_oracle(far), 0.97);
  EXPECT_GE(agreement(picture_of(far), picture_of(near), 3.0f / 255), 0.95);
}

TEST(Frame, HoldsWhatIsFarBesideWhatIsNear) {
  for (const double away : {1e3, 1e9, 1e15, 1e20, 1e23}) {
    Scene near = balls(3), both = balls(3), round = balls(3);
    for (Scene* scene : {&near, &both}) add_ground_triangle(*scene, 1e2);
    // Out of sight: everything is as it was. A planet in sight: it looks the same at any distance.
    both.spheres.push_back({{{away, away, -away}, away / 100}, 1});
    EXPECT_GE(agreement(picture_of(both), picture_of(near), 1.0f / 255), 0.9995) << away;
    round.spheres.push_back({{{0, 0.3 * away, 5 - away}, away / 10}, 1});
    EXPECT_GE(against_oracle(round), 0.999) << away;
    double planet = 0;  // its area, in pixels of the background that are none any more
    const Image with = picture_of(round), without = picture_of(balls(3));
    for (std::size_t i = 0; i < with.pixels.size(); i += 3)
      planet += without.pixels[i] == 0.3f && with.pixels[i] != 0.3f;
    // A cone of half angle a, t off the view: π sin² a cos t / (cos² t - sin² a)^1.5.
    const double sin2 = 0.01 / 1.09, cosine = 1 / std::sqrt(1.09);
    EXPECT_NEAR(planet / (kSide * kSide),
                M_PI * sin2 * cosine / std::pow(cosine * cosine - sin2, 1.5), 0.003)
        << away;
  }
}

TEST(Frame, HoldsFarLights) {
  Scene scene = balls(3);
  add_ground_sphere(scene, 1e3);
  scene.lights[0].position = {1e6, 1e6, 1e6};
  const Image want = picture_of(scene);
  for (const double away : {1e9, 1e15, 1e30, 1e90}) {
    scene.lights[0].position = {away, away, away};
    EXPECT_GE(agreement(picture_of(scene), want, 1.0f / 255), 0.999) << away;
  }
}

TEST(Frame, LooksFromASurfaceAtWhatLiesBeforeIt) {
  // From the front of a ball of glass-like walls into it, at a small ball; from anywhere on it.
  for (const Vec3 from : {Vec3{0, 0, 1}, Vec3{0.6, 0, 0.8},
                          Vec3{1 / std::sqrt(3.0), 1 / std::sqrt(3.0), 1 / std::sqrt(3.0)}}) {
    Scene scene = balls(0);
    scene.spheres = {{{{0, 0, 0}, 1}, 0}, {{{0, 0, 0}, 0.3}, 1}};
    scene.lights[0].position = {0, 0.5, 0.1};
    scene.camera = {from, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Image on = picture_of(scene);
    scene.camera.eye = {from.x * 0.999, from.y * 0.999, from.z * 0.999};
    EXPECT_GE(agreement(on, picture_of(scene), 3.0f / 255), 0.97);
    // And away from it, at nothing.
    scene.camera = {from, {2 * from.x, 2 * from.y, 2 * from.z}, {1, 0, 0}, {0, 1, 0}};
    for (const float v : picture_of(scene).pixels) ASSERT_TRUE(v == 0.3f || v == 0.4f || v == 0.6f);
  }
  // Through a triangle that the eye lies on.
  Scene scene = balls(1);
  const Image want = picture_of(scene);
  scene.triangles.push_back({{{-3, -3, 5}, {3, -3, 5}, {0, 3, 5}}, 1});
  scene.lights[0].position.z = 4;
  EXPECT_GE(agreement(picture_of(scene), want, 1.0f / 255), 0.95);
}

TEST(Frame, SaysWhatFloatsCannotHold) {
  EXPECT_EQ(problems_of(balls(3)), "");
  Scene scene = balls(2);
  scene.spheres.push_back({{{0, 1e26, 0}, 1}, 0});
  EXPECT_EQ(problems_of(scene),
            "error: sphere 3: it reaches 1e+26 from what the camera sees, which is so small that "
            "floats cannot hold both\n"
            "  move it nearer, make it smaller or leave it out\n");
  scene = balls(2);
  add_ground_triangle(scene, 1e20);
  EXPECT_EQ(problems_of(scene),
            "error: triangle 1: it reaches 1e+20 from what the camera sees, which is so small that "
            "floats cannot hold both\n"
            "  move it nearer, make it smaller or leave it out\n");
  scene = balls(2);
  scene.cones.push_back({{{-1e7, -1e7 - 1, 0}, 1e7, {1e7, -1e7 - 1, 0}, 1e7}, 0});
  EXPECT_EQ(
      problems_of(scene),
      "error: cone 1: it is 7e+06 times as large as what the camera sees of it; floats cannot "
      "hold that\n"
      "  triangles or a sphere in its place can be as large\n");
  scene = balls(2);
  scene.camera = {{1e20, 1e20, 1e20}, {0, 0, 0}, {1e20, 0, 0}, {0, 1e20, 0}};
  EXPECT_EQ(problems_of(scene),
            "error: the eye is so far from all shapes that floats cannot hold the distance\n"
            "  move it nearer\n");
  scene = balls(2);
  scene.camera.window_right = {1e-6, 0, 0};
  EXPECT_EQ(problems_of(scene),
            "error: the view is too narrow: floats cannot tell the rays of neighbouring pixels "
            "apart\n"
            "  from nearer by, or with fewer pixels, they can\n");
  scene = balls(2);
  scene.camera.window_center.x = scene.lights[0].position.y = 1e101;
  EXPECT_EQ(problems_of(scene),
            "error: the camera reaches farther than 1e+100 from the origin\n"
            "error: light 1 is farther than 1e+100 from the origin\n");
}

TEST(Frame, LetsARayIntoTheGlassOfABallSeenFromClose) {
  // The ray through the middle enters the ball in the very point that its numbers are kept from.
  Scene scene;
  scene.resolution = {5, 5};
  scene.camera = {{0, 0, 10}, {0, 0, 0}, {0.001, 0, 0}, {0, 0.001, 0}};
  scene.background = {1, 1, 1};
  scene.materials = {{.ambient = {}, .diffuse = {}, .refraction = 1, .absorption = {0.5, 1, 2}}};
  for (const double radius : {1.0, 2.0, 8.0}) {
    scene.spheres = {{{{0, 0, 0}, radius}, 0}};
    for (const Isa isa : available_isas()) {
      const Image image = picture_of(scene, {.isa = isa});
      const float* middle = image.row(2) + 6;
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(middle[k], std::exp(-2 * radius * (0.5 * (1 << k))), 1e-5) << name_of(isa);
    }
  }
}

}  // namespace
}  // namespace zraka
