// SPDX-License-Identifier: Apache-2.0
// What is wrong with lights, cameras, skies and materials that a program has put together, and
// with what it asks for.
#include <gtest/gtest.h>

#include <limits>

#include "render/prepare.hpp"
#include "scenes.hpp"

namespace zraka {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string all_of(const Diagnostics& found) {
  std::string all;
  for (const Diagnostic& d : found) all += to_string(d);
  return all;
}

Scene plain_scene() {
  Scene scene = lab_scene();
  add_sphere(scene, {0, 0, -2}, 0.5, {});
  return scene;
}

std::string problem_of(const Light& light) {
  Scene scene = plain_scene();
  scene.lights = {light};
  return all_of(check(scene));
}
std::string problem_of(const Camera& camera) {
  Scene scene = plain_scene();
  scene.camera = camera;
  return all_of(check(scene));
}
std::string problem_of(const Material& material) {
  Scene scene = plain_scene();
  scene.materials = {material};
  return all_of(check(scene));
}
template <class Change>
std::string problem_of_sky(const Change& change) {
  Scene scene = plain_scene();
  scene.textures.emplace_back();
  change(scene);
  return all_of(check(scene));
}

TEST(Check, FindsNothingWrongWithGoodLights) {
  for (int kind = 0; kind <= static_cast<int>(LightKind::sphere); ++kind)
    EXPECT_EQ(problem_of(Light{.position = {3, 3, 3}, .kind = static_cast<LightKind>(kind)}), "");
  EXPECT_EQ(problem_of(Light{.position = {kNan, 0, 0}, .kind = LightKind::directional}), "")
      << "it has no position";
  EXPECT_EQ(problem_of(Light{.position = {}, .attenuation = {0, 0, 1}, .radius = 0}), "")
      << "a point has no radius";
}

TEST(Check, FindsWhatIsWrongWithLights) {
  using enum LightKind;
  EXPECT_EQ(problem_of(Light{.position = {kNan, 0, 0}}), "error: light 1 is not finite\n");
  EXPECT_EQ(problem_of(Light{.position = {}, .color = {kInfinity, 0, 0}, .kind = directional}),
            "error: light 1 is not finite\n");
  EXPECT_EQ(problem_of(Light{.position = {0, 1e101, 0}, .kind = disc}),
            "error: light 1 is farther than 1e+100 from the origin\n");
  const std::string attenuation =
      "error: light 1 has an attenuation that is not finite, below 0, or 0\n";
  EXPECT_EQ(problem_of(Light{.position = {}, .attenuation = {0, 0, 0}}), attenuation);
  EXPECT_EQ(problem_of(Light{.position = {}, .attenuation = {1, -1, 0}}), attenuation);
  EXPECT_EQ(problem_of(Light{.position = {}, .attenuation = {1, kNan, 0}}), attenuation);
  const std::string direction = "error: light 1 has a direction that is 0, or not finite\n";
  EXPECT_EQ(problem_of(Light{.position = {}, .kind = directional, .direction = {}}), direction);
  EXPECT_EQ(problem_of(Light{.position = {}, .kind = spot, .direction = {0, kNan, 0}}), direction);
  EXPECT_EQ(problem_of(Light{.position = {}, .kind = spot, .inner_deg = 50, .outer_deg = 40}),
            "error: light 1 shines from 50 to 40 degrees: expected angles up to 180, in order\n");
  EXPECT_EQ(problem_of(Light{.position = {}, .kind = spot, .inner_deg = kNan}),
            "error: light 1 shines from nan to 45 degrees: expected angles up to 180, in order\n");
  EXPECT_EQ(problem_of(
                Light{.position = {}, .kind = rectangle, .edge_u = {0, 1, 0}, .edge_v = {0, 2, 0}}),
            "error: light 1 has edges that span no plane\n");
  EXPECT_EQ(problem_of(Light{.position = {}, .kind = rectangle, .edge_u = {kNan, 1, 0}}),
            "error: light 1 has an edge that is not finite\n");
  EXPECT_EQ(problem_of(Light{.position = {}, .kind = disc, .normal = {}}),
            "error: light 1 has a normal that is 0, or not finite\n");
  EXPECT_EQ(problem_of(Light{.position = {}, .kind = sphere, .radius = 0}),
            "error: light 1 has a radius that is not a finite number above 0\n");
  EXPECT_EQ(problem_of(Light{.position = {}, .kind = disc, .radius = 1e101}),
            "error: light 1 is larger than 1e+100\n");
  EXPECT_EQ(problem_of(Light{.position = {}, .kind = sphere, .samples = 0}),
            "error: light 1 has 0 samples: expected 1 to 65536\n");
}

TEST(Check, FindsWhatIsWrongWithCameras) {
  EXPECT_EQ(problem_of(Camera{.window_center = {}, .aperture = kNan}),
            "error: the lens' diameter is nan: 0 or more is possible\n");
  EXPECT_EQ(problem_of(Camera{.window_center = {}, .focus_distance = kNan}), "")
      << "a pinhole has no focus";
  EXPECT_EQ(problem_of(Camera{.window_center = {}, .aperture = 1, .focus_distance = 0}),
            "error: the camera is in focus at the distance 0: it has to be more than 0\n");
  const std::string nowhere =
      "error: the camera looks nowhere, or straight up: its eye, its window's middle and up span no "
      "plane\n";
  EXPECT_EQ(problem_of(Camera{.window_center = {0, 0, 2}, .kind = CameraKind::panorama}), nowhere);
  EXPECT_EQ(problem_of(Camera{
                .window_center = {}, .window_right = {0, 1, 0}, .kind = CameraKind::orthographic}),
            nowhere);
  EXPECT_EQ(problem_of(Camera{.window_center = {}, .kind = CameraKind::fisheye, .fov_deg = 0}),
            "error: the fisheye camera's angle of view is 0°: more than 0 and at most 360 are "
            "possible\n");
}

TEST(Check, FindsWhatIsWrongWithSkies) {
  const auto sky = [](const Sky& made) {
    return problem_of_sky([&](Scene& scene) { scene.sky = made; });
  };
  EXPECT_EQ(sky({.kind = Sky::Kind::gradient, .bottom = {kNan, 0, 0}}),
            "error: a colour of the sky is not finite\n");
  EXPECT_EQ(sky({.kind = Sky::Kind::gradient, .up = {}}),
            "error: the sky's up is 0, or not finite\n");
  EXPECT_EQ(sky({.kind = Sky::Kind::image, .texture = 1}),
            "error: the sky has texture 1, but there are 1\n");
  EXPECT_EQ(sky({.kind = Sky::Kind::image}), "error: the sky's texture is no image\n");
  const auto occlusion = [](const AmbientOcclusion& made) {
    return problem_of_sky([&](Scene& scene) { scene.ambient_occlusion = made; });
  };
  EXPECT_EQ(occlusion({.samples = 64}), "");
  EXPECT_EQ(occlusion({.samples = -1}),
            "error: ambient occlusion has -1 samples: expected 0 to 65536\n");
  EXPECT_EQ(occlusion({.distance = -1}),
            "error: ambient occlusion is not finite, or its distance below 0\n");
}

TEST(Check, FindsWhatIsWrongWithMaterials) {
  EXPECT_EQ(problem_of(Material{.reflection = Color{0, kNan, 0}}),
            "error: material 0 is not finite\n");
  EXPECT_EQ(problem_of(Material{.absorption = {0, 0, kInfinity}}),
            "error: material 0 is not finite\n");
  EXPECT_EQ(problem_of(Material{.absorption = {0, -1, 0}}),
            "error: material 0 has an absorption below 0\n");
  EXPECT_EQ(problem_of(Material{.ior = 1.5, .dispersion = {Dispersion::Kind::abbe, {60}}}), "");
  EXPECT_EQ(problem_of(Material{.dispersion = {Dispersion::Kind::cauchy, {}}}),
            "error: material 0 has no index of refraction above 0 for some of the light that is "
            "seen\n");
}

TEST(Check, FindsWhatIsOutOfRangeInARequest) {
  const Scene scene = plain_scene();
  const auto problem = [&](const RenderOptions& options) {
    return all_of(check_request(scene, options));
  };
  const auto sampled = [&](const Sampling& sampling) {
    RenderOptions options;
    options.sampling = sampling;
    return problem(options);
  };
  using Kind = Sampling::Kind;
  EXPECT_EQ(problem({}), "");
  EXPECT_EQ(problem({.min_contribution = -1}),
            "error: least contribution -1 is out of range: 0 or more\n");
  EXPECT_EQ(problem({.min_contribution = kNan}),
            "error: least contribution nan is out of range: 0 or more\n");
  EXPECT_EQ(problem({.wavelengths = 0}),
            "error: number of wavelengths 0 is out of range: 1 to 64\n");
  EXPECT_EQ(sampled({.count = 65536}), "");
  EXPECT_EQ(sampled({.count = 65537}),
            "error: number of samples 65537 is out of range: 1 to 65536\n");
  EXPECT_EQ(sampled({.kind = Kind::grid, .count = 257}),
            "error: grid 257 is out of range: 1 to 256\n");
  EXPECT_EQ(sampled({.kind = Kind::adaptive, .count = 4, .most = 3}),
            "error: greatest number of samples 3 is out of range: 4 to 65536\n");
  EXPECT_EQ(sampled({.kind = Kind::adaptive, .contrast = -1}),
            "error: contrast -1 is out of range: 0 to 1\n");
}

}  // namespace
}  // namespace zraka
