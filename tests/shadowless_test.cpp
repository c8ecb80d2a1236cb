// SPDX-License-Identifier: Apache-2.0
// What throws no shadow, and skies that rays see beyond the deepest level: in the lean engine as in
// the general one.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <zraka/explain.hpp>

#include "explain/json.hpp"
#include "fold.hpp"
#include "picture_of.hpp"
#include "render/isa.hpp"
#include "render/prepare.hpp"
#include "scenes.hpp"

namespace zraka {
namespace {

/// Balls on a floor, so many, and a light above; material 2 throws no shadow.
Scene lit_balls(int count) {
  Scene scene;
  scene.resolution = {64, 48};
  scene.camera = {{0, 3.5, 9}, {0, -0.5, 0}, {8, 0, 0}, {0, 6, 0}};
  scene.background = {0.2, 0.3, 0.5};
  scene.lights = {{{2, 6, 3}, {0.9, 0.8, 0.7}}, {{-5, 4, 6}, {0.3, 0.3, 0.4}}};
  scene.materials = {{.diffuse = {0.8, 0.4, 0.2}, .reflection = 0.3},
                     {.diffuse = {0.3, 0.6, 0.3}},
                     {.diffuse = {0.9, 0.9, 0.9}, .reflection = 0.2}};
  scene.materials[2].casts_shadow = false;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-2.5, 2.5), size(0.1, 0.5);
  for (int i = 0; i < count; ++i) {
    const double radius = size(random) * (count > 100 ? 0.2 : 1), x = place(random);
    scene.spheres.push_back({{{x, radius - 1, place(random)}, radius}, 0});
  }
  scene.triangles.push_back({{{-9, -1, -9}, {9, -1, -9}, {0, -1, 12}}, 1});
  return scene;
}

/// Shapes between the first light and what it shines on, above what the eye sees: few, or of all
/// kinds and many.
void add_screens(Scene& scene, std::uint32_t material, bool many) {
  const auto triangle = [](double y) {
    return Triangle{{-9, y, -9}, {9, y, -9}, {0, y, 12}};
  };
  scene.spheres.push_back({{{2, 6, 3}, 0.5}, material});
  scene.triangles.push_back({triangle(5), material});
  const Triangle at = triangle(4.5);
  scene.smooth_triangles.push_back(
      {{at.a, at.b, at.c, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}}, material});
  scene.cones.push_back({{{-4, 5, 0}, 0.8, {4, 5, 0}, 0.8}, material});
  if (!many) return;
  scene.boxes.push_back({{{-5, 5.2, -5}, {5, 5.4, 5}}, material});
  scene.planes.push_back({{{0, 5.5, 0}, {0, 1, 0}}, material});
  // What nothing can split stays in one leaf.
  for (int i = 0; i < 12; ++i) scene.spheres.push_back({{{1, 4.2, 1}, 0.3 + i * 1e-6}, material});
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-2, 4);
  for (int i = 0; i < 3000; ++i)
    scene.spheres.push_back(
        {{{place(random), 4.5 + 0.2 * place(random), place(random)}, 0.06}, material});
}

/// The same by the general engine: no ray brings less than nothing.
RenderOptions by_general(RenderOptions options) {
  options.min_contribution = 1e-30;
  return options;
}

TEST(Shadowless, ChangesNothingWhereItIsNotSeen) {
  for (const int count : {3, 60}) {
    Scene plain = lit_balls(count), with = lit_balls(count), opaque = lit_balls(count);
    // So that no ray sees them, either.
    for (Scene* scene : {&plain, &with, &opaque}) scene->materials[0].reflection = 0;
    add_screens(with, 2, count > 3);
    add_screens(opaque, 1, count > 3);
    ASSERT_FALSE(needs_general_engine(with, {}));
    std::vector<Isa> isas = available_isas();
    isas.push_back(Isa::oracle);
    for (const Isa isa : isas) {
      const RenderOptions options{.isa = isa};
      EXPECT_GE(agreement(picture_of(plain, options), picture_of(with, options), 1e-5f), 0.999)
          << count << " balls, " << name_of(isa);
      EXPECT_LE(agreement(picture_of(plain, options), picture_of(opaque, options), 1e-5f), 0.9);
    }
  }
}

TEST(Shadowless, IsAsTheGeneralEngineHasIt) {
  for (const int count : {3, 60, 2000}) {
    Scene scene = lit_balls(count);
    add_screens(scene, 2, count > 3);
    for (std::size_t i = 0; i < scene.spheres.size(); i += 3) scene.spheres[i].material = 2;
    EXPECT_GE(agreement(picture_of(scene, {}), picture_of(scene, by_general({})), 1e-4f), 0.999);
  }
}

TEST(Shadowless, IsLeftToTheGeneralEngineWithinWholes) {
  Scene scene = lit_balls(3);
  EXPECT_FALSE(needs_general_engine(scene, {}));
  Scene csg = scene, group = scene, instance = scene;
  Csg pair{.operation = CsgOperation::unite,
           .of = {{.body = Ellipsoid{{0, 1, 0}, {1, 1, 1}}}, {.body = Box{{0, 0, 0}, {1, 1, 1}}}}};
  csg.csgs.push_back({pair, 0});
  EXPECT_FALSE(needs_general_engine(csg, {}));
  csg.csgs[0].shape.of[1].material = 2;
  EXPECT_TRUE(needs_general_engine(csg, {}));
  group.groups.emplace_back().spheres.push_back({{{0, 1, 0}, 1}, kMaterialOfWhole});
  group.transforms = {Transform{}};
  group.instances.push_back({{0}, 0, 1});
  EXPECT_FALSE(needs_general_engine(group, {}));
  group.instances[0].material = 2;
  EXPECT_TRUE(needs_general_engine(group, {}));
  group.instances[0].material = 0;
  group.groups[0].spheres[0].material = 2;
  EXPECT_TRUE(needs_general_engine(group, {}));
}

TEST(Shadowless, IsPassedByWhatIsExplained) {
  // The light's own ball and a screen lie before what really blocks it.
  Scene scene = lit_balls(3);
  add_screens(scene, 2, true);
  scene.materials[0].reflection = 0;
  const RenderOptions options;
  const Image image = picture_of(scene, options);
  Explainer explainer = Explainer::create(scene, options).value();
  int blocked = 0, lit = 0;
  for (std::uint32_t y = 16; y < 48; ++y)
    for (std::uint32_t x = 0; x < 64; ++x) {
      const Result<Explanation> explanation = explainer.pixel(x, y);
      ASSERT_TRUE(explanation) << to_string(explanation.error().front());
      const ExplainedRay& ray = explanation->trees.front().rays.front();
      if (!ray.hit) continue;
      for (const LightTerms& light : ray.hit->lights) {
        lit += light.reach == Reach::lit ? 1 : 0;
        if (!light.blocker) continue;
        ++blocked;
        EXPECT_LT(light.blocker->shape.id.index, 3u);
        const Vec3& c = scene.spheres[light.blocker->shape.id.index].shape.center;
        const Vec3& from = ray.hit->point;
        const double away = std::hypot(c.x - from.x, c.y - from.y, c.z - from.z);
        EXPECT_NEAR(light.blocker->distance, away, 0.51);
      }
    }
  EXPECT_GT(blocked, 10);
  EXPECT_GT(lit, 100);
}

TEST(SkyBeyond, IsWhatTheDeepestMirrorsShow) {
  // Nothing but sky is seen in one ball: a level more or less makes no difference.
  Scene scene = lit_balls(1);
  scene.triangles.clear();
  RenderOptions none{.profile = profile_of(ProfileName::tachyon), .max_depth = 0};
  RenderOptions one = none;
  one.max_depth = 1;
  EXPECT_FALSE(needs_general_engine(scene, none));
  const Image deep = picture_of(scene, one);
  EXPECT_GE(agreement(picture_of(scene, none), deep, 1e-6f), 1);
  none.profile.sky_beyond = false;
  EXPECT_LT(agreement(picture_of(scene, none), deep, 1e-2f), 1);
}

TEST(SkyBeyond, IsAsTheGeneralEngineHasIt) {
  for (const int depth : {0, 1, 3}) {
    Scene scene = lit_balls(60);
    scene.materials[0].refraction = 0.4;
    const RenderOptions options{.profile = profile_of(ProfileName::tachyon), .max_depth = depth};
    EXPECT_GE(agreement(picture_of(scene, options), picture_of(scene, by_general(options)), 1e-4f),
              0.995)
        << depth;
  }
}

TEST(SkyBeyond, FoldsToThePicturesBits) {
  Scene scene = lit_balls(60);
  scene.materials[0].refraction = 0.4;
  add_screens(scene, 2, true);
  for (const int depth : {0, 2}) {
    const RenderOptions options{.profile = profile_of(ProfileName::tachyon), .max_depth = depth};
    const Image image = picture_of(scene, options);
    Explainer explainer = Explainer::create(scene, options).value();
    int beyond = 0;
    for (std::uint32_t y = 1; y < 48; y += 5)
      for (std::uint32_t x = 1; x < 64; x += 5) {
        const Explanation explanation = explainer.pixel(x, y).value();
        for (const ExplainedRay& ray : explanation.trees.front().rays)
          beyond += ray.hit && ray.hit->sky_beyond ? 1 : 0;
        const nlohmann::json read =
            nlohmann::json::parse(to_json(explanation, "scene", "profile", "words"));
        const Float3 color = Fold{read}.color();
        const float* pixel = image.row(y) + 3 * x;
        EXPECT_EQ(color, (Float3{pixel[0], pixel[1], pixel[2]})) << x << ", " << y;
      }
    EXPECT_GT(beyond, 20);
  }
}

}  // namespace
}  // namespace zraka
