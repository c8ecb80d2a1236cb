// SPDX-License-Identifier: Apache-2.0
// What must not change a picture: threads, tiles, instruction sets; a scene's place and unit.
#include <gtest/gtest.h>

#include <cstdlib>

#include "scenes.hpp"

namespace zraka {
namespace {

// A sanitizer looks at how, not at how much.
#ifdef ZRAKA_SANITIZED
constexpr std::uint32_t kSide = 24;
#else
constexpr std::uint32_t kSide = 80;
#endif

TEST(Picture, HasTheSameBitsHoweverItIsComputed) {
  std::vector<NamedScene> scenes = test_scenes(kSide);
  scenes.push_back({"noise", noisy_scene(kSide)});
  for (const NamedScene& named : scenes)
    for (const ProfileName profile : {ProfileName::lab, ProfileName::physical}) {
      RenderOptions options{.profile = profile_of(profile)};
      options.isa = Isa::portable;
      options.threads = 1;
      const std::string want = sha256(render(named.scene, options).value().image);
      struct Way {
        int threads, tile;
      };
      for (const Isa isa : available_isas())
        for (const Way way : {Way{1, 0}, {2, 0}, {3, 7}, {2, 16}, {1, 64}, {2, 1}}) {
          options.isa = isa;
          options.threads = way.threads;
          options.tile = way.tile;
          ASSERT_EQ(sha256(render(named.scene, options).value().image), want)
              << named.name << ", " << name_of(isa) << ", " << way.threads << " threads, tile "
              << way.tile;
        }
    }
}

TEST(Picture, HasTheBitsThatItAlwaysHad) {
  // Changes with a reason only, in words, in the commit: these are the same for every compiler and
  // machine.
  const std::vector<NamedScene> scenes = test_scenes();
  EXPECT_EQ(
      sha256(render(scenes[0].scene, {.profile = profile_of(ProfileName::lab)}).value().image),
      "d7231f82c37b7e2db344c7390508511880fbef6ea87e99864c424db8b9a562ce");
  EXPECT_EQ(
      sha256(render(scenes[1].scene, {.profile = profile_of(ProfileName::lab)}).value().image),
      "abe69bf4fc7362f9eaa95297b13f6c34baf9c6d014479a9657b54b75ce0ac895");
}

TEST(Picture, IsWhatTheDoubleOracleComputes) {
  double agreeing = 0, pixels = 0;
  for (const NamedScene& named : test_scenes())
    for (const ProfileName profile : {ProfileName::lab, ProfileName::physical}) {
      RenderOptions options{.profile = profile_of(profile)};
      const Image lanes = render(named.scene, options).value().image;
      options.isa = Isa::oracle;
      const Image oracle = render(named.scene, options).value().image;
      const double share = agreement(lanes, oracle, 1.0f / 255);
      const double count = static_cast<double>(lanes.pixels.size()) / 3;
      // The scenes of the project, as they are drawn.
      if (named.name == "input" || named.name == "letter")
        agreeing += share * count, pixels += count;
      EXPECT_GE(share, 0.997) << named.name;
    }
  EXPECT_GE(agreeing / pixels, 0.9999);
}

Scene moved(Scene scene, double by, double scale) {
  const auto point = [&](Vec3& v) {
    v = {v.x * scale + by, v.y * scale - by, v.z * scale + 2 * by};
  };
  const auto vector = [&](Vec3& v) { v = {v.x * scale, v.y * scale, v.z * scale}; };
  point(scene.camera.eye);
  point(scene.camera.window_center);
  vector(scene.camera.window_right);
  vector(scene.camera.window_up);
  for (Light& light : scene.lights) point(light.position);
  for (auto& sphere : scene.spheres) {
    point(sphere.shape.center);
    sphere.shape.radius *= scale;
  }
  for (auto& t : scene.triangles) point(t.shape.a), point(t.shape.b), point(t.shape.c);
  for (auto& t : scene.smooth_triangles) point(t.shape.a), point(t.shape.b), point(t.shape.c);
  for (auto& cone : scene.cones) {
    point(cone.shape.base), point(cone.shape.apex);
    cone.shape.base_radius *= scale, cone.shape.apex_radius *= scale;
  }
  return scene;
}

TEST(Picture, DoesNotDependOnPlaceAndUnit) {
  for (const NamedScene& named : test_scenes()) {
    const RenderOptions options{.profile = profile_of(ProfileName::lab)};
    const Image here = render(named.scene, options).value().image;
    for (const auto& [by, scale] : {std::pair{1e6, 1.0}, {0.0, 1e6}, {0.0, 1e-6}, {-3e5, 1024.0}}) {
      const Image there = render(moved(named.scene, by, scale), options).value().image;
      EXPECT_GE(agreement(here, there, 1.0f / 255), 0.998)
          << named.name << " by " << by << ", scale " << scale;
    }
  }
}

TEST(Isa, IsForcedByTheEnvironment) {
  for (const Isa isa : available_isas()) {
    ::setenv("ZRAKA_ISA", std::string(name_of(isa)).c_str(), 1);
    EXPECT_EQ(render(lab_scene(8), {}).value().stats.isa, isa);
  }
  ::setenv("ZRAKA_ISA", "mmx", 1);
  EXPECT_EQ(render(lab_scene(8), {}).error().front().message,
            "the environment's ZRAKA_ISA names 'mmx', which is no instruction set");
  ::unsetenv("ZRAKA_ISA");
  EXPECT_EQ(render(lab_scene(8), {}).value().stats.isa, available_isas().front());
}

}  // namespace
}  // namespace zraka
