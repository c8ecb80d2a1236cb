// SPDX-License-Identifier: Apache-2.0
// Shadow rays of the general engine ask opaque shapes first: what they arrive with is what it is
// where the way of each is followed, as it is where there are cuts, and where somebody listens.
#include <gtest/gtest.h>

#include "optics_scenes.hpp"
#include "picture_of.hpp"
#include "render/prepare.hpp"

namespace zraka {
namespace {

/// All lights are seen as balls that throw no shadow, in one of which another light is; they may
/// absorb.
void show_lights(Scene& scene, const Color& absorption) {
  const auto ball = static_cast<std::uint32_t>(scene.materials.size());
  scene.materials.push_back({.ambient = {1, 1, 1}, .diffuse = {}, .refraction = 0.5});
  scene.materials.back().casts_shadow = false;
  scene.materials.back().absorption = absorption;
  const std::vector<Light> lights = scene.lights;
  for (const Light& light : lights)
    if (light.kind != LightKind::directional)
      scene.spheres.push_back({Sphere{light.position, 0.4}, ball});
  Light inner = lights.front();
  inner.kind = LightKind::point;
  inner.position.x += 0.1;
  scene.lights.push_back(inner);
}

/// A cut of materials that there are none of takes nothing away, but opaque shapes are not asked
/// first.
Scene with_idle_cut(Scene scene) {
  scene.cuts.push_back({.point = {0, 0, 0}, .normal = {0, 1, 0}, .caps = false, .group = 77});
  return scene;
}

/// All ways are followed where something absorbs, too, though nothing is made of it.
Scene all_followed(const Scene& scene) {
  Scene followed = with_idle_cut(scene);
  followed.materials.push_back({.absorption = {1, 2, 3}});
  return followed;
}

TEST(ShadowWays, ComeToTheSameWhetherFollowedOrNot) {
  int passed = 0;
  int number = 0;
  for (OpticsCase& one : optics_cases()) {
    show_lights(one.scene, ++number % 4 == 0 ? Color{0.9, 0.5, 0.1} : Color{});
    if (!needs_general_engine(one.scene, one.options)) one.options.min_contribution = 1e-30;
    for (const Shadows shadows : {Shadows::opaque, Shadows::transparent}) {
      one.options.shadows = shadows;
      const PreparedScene<float> prepared = prepare<float>(one.scene, one.options);
      passed += prepared.store->scene.opaque != nullptr ? 1 : 0;
      const Image followed = picture_of(all_followed(one.scene), one.options);
      EXPECT_EQ(picture_of(one.scene, one.options).pixels, followed.pixels) << one.name;
      EXPECT_EQ(picture_of(with_idle_cut(one.scene), one.options).pixels, followed.pixels)
          << one.name;
    }
  }
  EXPECT_GT(passed, 40);
}

TEST(ShadowWays, AreFollowedThroughPartsOfWholes) {
  Scene scene = room_with_glass();
  RenderOptions options{.profile = profile_of(ProfileName::physical),
                        .shadows = Shadows::transparent};
  const auto has_opaque = [&](const Scene& with) {
    return prepare<float>(with, options).store->scene.opaque != nullptr;
  };
  EXPECT_TRUE(has_opaque(scene));  // the box and the ball of glass are wholes by themselves
  options.shadows = Shadows::opaque;
  EXPECT_FALSE(has_opaque(scene));  // nothing is to be passed
  options.shadows = Shadows::transparent;
  Scene csg = scene;
  Csg pair{.operation = CsgOperation::unite,
           .of = {{.body = Ellipsoid{{0, 1, 0}, {1, 1, 1}}}, {.body = Box{{0, 0, 0}, {1, 1, 1}}}}};
  csg.csgs.push_back({pair, 0});
  EXPECT_TRUE(has_opaque(csg));
  csg.csgs[0].shape.of[1].material = 1;
  EXPECT_FALSE(has_opaque(csg));
  csg.csgs[0].shape.of[1].material = kMaterialOfWhole;
  csg.csgs[0].material = 1;
  EXPECT_FALSE(has_opaque(csg));
  Scene group = scene;
  group.groups.emplace_back().spheres.push_back({{{0, 1, 0}, 1}, 3});
  group.transforms = {Transform{}};
  group.instances.push_back({{0}, 0, 1});
  EXPECT_TRUE(has_opaque(group));
  EXPECT_EQ(picture_of(group, options).pixels, picture_of(all_followed(group), options).pixels);
  group.groups[0].spheres[0].material = 1;
  EXPECT_FALSE(has_opaque(group));
  EXPECT_EQ(picture_of(group, options).pixels, picture_of(all_followed(group), options).pixels);
}

}  // namespace
}  // namespace zraka
