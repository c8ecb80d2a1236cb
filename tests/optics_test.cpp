// SPDX-License-Identifier: Apache-2.0
// Light and glass beyond the lab's: closed forms, and the same bits everywhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <zraka/explain.hpp>
#include <zraka/render.hpp>

#include "engine/general/steps.hpp"
#include "engine/general/wavelengths.hpp"
#include "engine/hit_services.hpp"
#include "render/prepare.hpp"
#include "render/workspace.hpp"
#include "scenes.hpp"

namespace zraka {
namespace {

constexpr double kPi = 3.14159265358979323846;

Image rendered(const Scene& scene, const RenderOptions& options = {}) {
  Result<Rendering> rendering = render(scene, options);
  if (!rendering) ADD_FAILURE() << to_string(rendering.error().front());
  return rendering ? std::move(rendering->image) : Image(1, 1);
}

/// Looks down the z axis through a small window, so that all rays are nearly parallel.
Scene narrow_scene(Material material = {}) {
  Scene scene;
  scene.resolution = {5, 5};
  scene.camera = {{0, 0, 10}, {0, 0, 0}, {0.001, 0, 0}, {0, 0.001, 0}};
  scene.materials = {material};
  scene.ambient_light = {1, 1, 1};
  return scene;
}

std::array<float, 3> middle(const Image& image) {
  const float* p = image.row(image.height / 2) + 3 * (image.width / 2);
  return {p[0], p[1], p[2]};
}

/// A square in the plane z = const, seen from +z.
void add_wall(Scene& scene, double z, double half, std::uint32_t material) {
  scene.parallelograms.push_back(
      {Parallelogram{{-half, -half, z}, {2 * half, 0, 0}, {0, 2 * half, 0}}, material});
}

TEST(GeneralEngine, AgreesWithTheLabsOnItsScenes) {
  for (const NamedScene& named : test_scenes(100)) {
    for (const ProfileName profile : {ProfileName::lab, ProfileName::physical}) {
      for (const Highlight highlight : {Highlight::phong, Highlight::blinn}) {
        Scene scene = named.scene;
        for (Material& material : scene.materials) material.highlight = highlight;
        RenderOptions options{.profile = profile_of(profile)};
        ASSERT_FALSE(needs_general_engine(scene, options));
        const Image lean = rendered(scene, options);
        options.min_contribution = 1e-30;
        ASSERT_TRUE(needs_general_engine(scene, options));
        EXPECT_GT(agreement(lean, rendered(scene, options), 1e-4f), 0.995) << named.name;
      }
    }
  }
}

/// Of light that comes at an angle, the share that is reflected; eta is n1/n2.
double reflected_share(Fresnel by, double cosine, double eta) {
  WorkspaceMemory<double> memory({.batch = 1, .max_depth = 0, .general = true});
  Scratch<double>& hits = memory.workspace().scratch;
  hits.nx[0] = 1, hits.ny[0] = hits.nz[0] = 0;
  hits.vx[0] = cosine, hits.vy[0] = hits.vz[0] = 0;
  constexpr std::size_t kRoom = 1 + kArrayPadding;
  const std::int32_t hit[kRoom] = {};
  double n1[kRoom] = {eta}, n2[kRoom] = {1}, kind[kRoom] = {static_cast<double>(by)};
  double ratio[kRoom], quarter_d[kRoom], share[kRoom];
  isa_oracle::kServices.hits->find_bends(1, hits, {hit, n1, n2, kind, ratio, quarter_d, share});
  EXPECT_EQ(ratio[0], eta);
  return share[0];
}

TEST(Fresnel, HasItsClosedForms) {
  const auto exact = [](double cosine, double eta) {
    return reflected_share(Fresnel::exact, cosine, eta);
  };
  const auto schlick = [](double cosine, double eta) {
    return reflected_share(Fresnel::schlick, cosine, eta);
  };
  EXPECT_NEAR(exact(1, 1 / 1.5), 0.04, 1e-15);
  EXPECT_NEAR(exact(1, 1.5), 0.04, 1e-15);
  // At Brewster's angle light along the plane is not reflected: half of the other's remains.
  const double brewster = std::atan(1.5), c = std::cos(brewster), other = std::sin(brewster);
  const double across = std::pow((c / 1.5 - other) / (c / 1.5 + other), 2);
  EXPECT_NEAR(exact(c, 1 / 1.5), across / 2, 1e-15);
  EXPECT_EQ(exact(std::cos(std::asin(1 / 1.5) + 1e-9), 1.5), 1);
  EXPECT_LT(exact(std::cos(std::asin(1 / 1.5) - 1e-6), 1.5), 1);
  EXPECT_EQ(exact(0, 1 / 1.5), 1);
  for (double angle = 0; angle < 1.5; angle += 0.01)
    EXPECT_NEAR(schlick(std::cos(angle), 1 / 1.5), exact(std::cos(angle), 1 / 1.5), 0.04);
  EXPECT_NEAR(schlick(1, 1.5), 0.04, 1e-15);
  EXPECT_EQ(schlick(0.5, 1.5), 1);
  EXPECT_EQ(reflected_share(Fresnel::off, 0.5, 1.5), 0);
}

TEST(Wavelengths, MakeWhiteTogether) {
  for (const int count : {1, 2, 3, 7, 12, 64}) {
    const Wavelengths all = wavelengths_in(count);
    for (int c = 0; c < 3; ++c) {
      double sum = 0;
      for (int i = 0; i < count; ++i) sum += static_cast<double>(all.weight[i][c]);
      EXPECT_NEAR(sum, 1, 1e-6);
    }
  }
  const Wavelengths fine = wavelengths_in(64);
  const auto of = [&](double um, int c) {
    int nearest = 0;
    for (int i = 0; i < 64; ++i)
      if (std::fabs(fine.um[i] - um) < std::fabs(fine.um[nearest] - um)) nearest = i;
    return fine.weight[nearest][c];
  };
  EXPECT_GT(of(0.61, 0), 3 * std::fabs(of(0.61, 2)));
  EXPECT_GT(of(0.535, 1), 0);
  EXPECT_LT(of(0.51, 0), 0);  // beyond what red can be
  EXPECT_GT(of(0.45, 2), 3 * of(0.45, 1));
}

TEST(Shares, CountPerChannel) {
  Scene scene = narrow_scene({.ambient = {0.1, 0.1, 0.1},
                              .diffuse = {},
                              .reflection = Color{0.25, 0.5, 0.75},
                              .refraction = Color{0.5, 0.25, 0}});
  scene.background = {1, 0.5, 0.25};
  add_wall(scene, 0, 1, 0);
  const auto seen = middle(rendered(scene));
  EXPECT_NEAR(seen[0], 0.1 + 0.75 * 1, 1e-6);
  EXPECT_NEAR(seen[1], 0.1 + 0.75 * 0.5, 1e-6);
  EXPECT_NEAR(seen[2], 0.1 + 0.75 * 0.25, 1e-6);
}

TEST(Absorption, FollowsBeersLawThroughASlab) {
  Scene scene = narrow_scene(
      {.ambient = {}, .diffuse = {}, .refraction = 1, .ior = 1.3, .absorption = {0.1, 0.5, 2}});
  scene.background = {1, 1, 1};
  scene.boxes.push_back({Box{{-5, -5, -2}, {5, 5, 0.5}}, 0});
  const auto seen = middle(rendered(scene));
  EXPECT_NEAR(seen[0], std::exp(-0.25), 1e-5);
  EXPECT_NEAR(seen[1], std::exp(-1.25), 1e-5);
  EXPECT_NEAR(seen[2], std::exp(-5), 1e-5);
  // Something opaque stands in the middle of it.
  scene.materials.push_back({.ambient = {1, 1, 1}, .diffuse = {}});
  scene.spheres.push_back({Sphere{{0, 0, -1.5}, 1}, 1});
  EXPECT_NEAR(middle(rendered(scene))[1], std::exp(-0.5 * 1), 1e-5);
}

TEST(Highlights, AreBlinnsWhereAskedFor) {
  Scene scene = narrow_scene({.ambient = {},
                              .diffuse = {},
                              .specular = {1, 1, 1},
                              .shininess = 8,
                              .highlight = Highlight::blinn});
  add_wall(scene, 0, 1, 0);
  scene.lights = {{{3, 0, 4}}};
  // H is halfway between (0.6, 0, 0.8) and (0, 0, 1).
  const double n_h = std::sqrt((1 + 0.8) / 2);
  EXPECT_NEAR(middle(rendered(scene))[0], std::pow(n_h, 8), 1e-5);
}

TEST(Lights, FadeWithTheDistance) {
  Scene scene = narrow_scene({.ambient = {}, .diffuse = {1, 1, 1}});
  add_wall(scene, 0, 1, 0);
  scene.lights = {{{0, 0, 2}}};
  scene.lights[0].attenuation = {1, 0.5, 0.25};
  EXPECT_NEAR(middle(rendered(scene))[0], 1.0 / 3, 1e-6);
  // The same in other units.
  for (const double scale : {1e-6, 1e6}) {
    Scene other = scene;
    other.camera = {{0, 0, 10 * scale}, {}, {0.001 * scale, 0, 0}, {0, 0.001 * scale, 0}};
    other.parallelograms.clear();
    add_wall(other, 0, scale, 0);
    other.lights[0].position = {0, 0, 2 * scale};
    other.lights[0].attenuation = {1, 0.5 / scale, 0.25 / scale / scale};
    EXPECT_NEAR(middle(rendered(other))[0], 1.0 / 3, 1e-6);
  }
}

TEST(Lights, MayBeDirectional) {
  Scene scene = narrow_scene({.ambient = {}, .diffuse = {1, 1, 1}});
  add_wall(scene, 0, 1, 0);
  Light sun;
  sun.kind = LightKind::directional;
  sun.direction = {-3, 0, -4};
  scene.lights = {sun};
  EXPECT_NEAR(middle(rendered(scene))[0], 0.8, 1e-6);
  scene.spheres.push_back({Sphere{{300, 0, 400}, 1}, 0});
  EXPECT_EQ(middle(rendered(scene))[0], 0);
}

TEST(Lights, FromAfarAreTheLabEnginesToo) {
  Scene scene = mixed_scene(60);
  scene.lights = {{.position = {}, .kind = LightKind::directional, .direction = {-1, -3, -2}},
                  {.position = {4, 6, 5}}};
  RenderOptions options;
  EXPECT_FALSE(needs_general_engine(scene, options));
  const Image lab = rendered(scene, options);
  options.min_contribution = 1e-12;
  EXPECT_TRUE(needs_general_engine(scene, options));
  const Image general = rendered(scene, options);
  EXPECT_GT(agreement(lab, general, 1e-4f), 0.995);
}

TEST(Lights, MayBeSpots) {
  Scene scene = narrow_scene({.ambient = {}, .diffuse = {1, 1, 1}});
  add_wall(scene, 0, 1, 0);
  Light spot;
  spot.kind = LightKind::spot;
  spot.position = {0, 0, 5};
  spot.inner_deg = 20, spot.outer_deg = 40;
  const auto at = [&](double degrees) {
    spot.direction = {std::sin(degrees * kPi / 180), 0, -std::cos(degrees * kPi / 180)};
    scene.lights = {spot};
    return static_cast<double>(middle(rendered(scene))[0]);
  };
  EXPECT_NEAR(at(19), 1, 1e-6);
  EXPECT_EQ(at(41), 0);
  const double x = (std::cos(30 * kPi / 180) - std::cos(40 * kPi / 180)) /
                   (std::cos(20 * kPi / 180) - std::cos(40 * kPi / 180));
  EXPECT_NEAR(at(30), x * x * (3 - 2 * x), 1e-6);
}

/// A disc of radius r throws a penumbra of the width 2·r·b/a where the edge of what throws it is a
/// from the light and b from the screen.
TEST(Lights, ThatAreDiscsHaveTheirPenumbra) {
  Scene scene;
  scene.resolution = {200, 1};
  scene.camera = {{0, 1, 10}, {0, 0, 0}, {4, 0, 0}, {0, 0.02, 0}};
  scene.camera.eye = {0, 0, 100};
  scene.materials = {{.ambient = {}, .diffuse = {1, 1, 1}}};
  add_wall(scene, 0, 50, 0);
  Light disc;
  disc.kind = LightKind::disc;
  disc.position = {0, 0, 8};
  disc.normal = {0, 0, -1};
  disc.radius = 1;
  disc.samples = 1024;
  scene.lights = {disc};
  // Covers x < 0, at z = 2: a = 6, b = 2, so the penumbra is 2/3 wide. Out of the camera's way.
  scene.parallelograms.push_back({Parallelogram{{-60, -3, 2}, {60, 0, 0}, {0, 6, 0}}, 0});
  scene.camera.eye = {0, 0, 1.9};
  scene.camera.window_center = {0, 0, 0};
  const Image image = rendered(scene);
  double first = 9, last = -9;
  for (std::uint32_t i = 0; i < 200; ++i) {
    const double x = (i + 0.5) / 200 * 4 - 2;
    const double facing = 8 / std::sqrt(64 + x * x);
    const double light = image.row(0)[3 * i] / facing;
    if (light > 0.001) first = std::min(first, x);
    if (light < 0.995) last = std::max(last, x);
  }
  EXPECT_NEAR(first, -1.0 / 3, 0.03);
  EXPECT_NEAR(last, 1.0 / 3, 0.03);
}

TEST(AmbientOcclusion, IsOneUnderAnOpenSkyAndHalfAtAWall) {
  Scene scene = narrow_scene({.ambient = {1, 1, 1}, .diffuse = {}});
  scene.ambient_light = {1, 1, 1};
  scene.ambient_occlusion.samples = 256;
  add_wall(scene, 0, 1000, 0);
  EXPECT_EQ(middle(rendered(scene))[0], 1);
  // A wall that stands on it right beside the middle hides half of the sky.
  scene.parallelograms.push_back({Parallelogram{{-0.002, -1e4, -1}, {0, 2e4, 0}, {0, 0, 2e4}}, 0});
  EXPECT_NEAR(middle(rendered(scene))[0], 0.5, 0.004);
  // Within a distance that does not reach it, nothing is hidden.
  scene.ambient_occlusion.distance = 0.001;
  EXPECT_EQ(middle(rendered(scene))[0], 1);
}

/// Bumps bend light, but not the way that the sky is seen.
TEST(AmbientOcclusion, IsOneOnBumpsUnderAnOpenSky) {
  Scene scene = narrow_scene({.ambient = {1, 1, 1}, .diffuse = {}});
  scene.camera = {{0, 0, 10}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  scene.ambient_occlusion.samples = 64;
  scene.textures.emplace_back();
  scene.textures[0].kind = TextureKind::noise;
  scene.textures[0].size = 0.3;
  scene.materials[0].normals = {NormalUse::Kind::bump, 0, 0.3};
  add_wall(scene, 0, 1000, 0);
  const Image image = rendered(scene);
  for (const float v : image.pixels) EXPECT_EQ(v, 1);
}

TEST(TransparentShadows, AreProductsOverBodiesOnceEach) {
  Scene scene = narrow_scene({.ambient = {}, .diffuse = {1, 1, 1}});
  scene.materials.push_back({.ambient = {}, .diffuse = {}, .refraction = Color{0.5, 0.25, 1}});
  scene.materials.push_back({.ambient = {}, .diffuse = {}, .refraction = Color{0.5, 1, 0.5}});
  add_wall(scene, 0, 1, 0);
  scene.lights = {{{30, 0, 40}}};
  const RenderOptions options{.shadows = Shadows::transparent};
  // On the way to the light, overlapping.
  scene.spheres.push_back({Sphere{{6, 0, 8}, 1}, 1});
  scene.spheres.push_back({Sphere{{6.6, 0, 8.8}, 1}, 2});
  auto seen = middle(rendered(scene, options));
  EXPECT_NEAR(seen[0], 0.8 * 0.25, 1e-6);
  EXPECT_NEAR(seen[1], 0.8 * 0.25, 1e-6);
  EXPECT_NEAR(seen[2], 0.8 * 0.5, 1e-6);
  EXPECT_EQ(middle(rendered(scene))[0], 0);
  // The light inside of one of them.
  scene.lights[0].position = {6.6 + 0.3, 0, 8.8 + 0.4};
  EXPECT_NEAR(middle(rendered(scene, options))[0], 0.8 * 0.25, 1e-6);
  // A torus is passed twice, and counts once.
  scene.lights[0].position = {30, 0, 40};
  scene.spheres.clear();
  scene.tori.push_back({Torus{{12, 0, 16}, {0, 1, 0}, 2, 0.5}, 1});
  EXPECT_NEAR(middle(rendered(scene, options))[0], 0.8 * 0.5, 1e-6);
  // Something opaque behind it.
  scene.spheres.push_back({Sphere{{18, 0, 24}, 1}, 0});
  EXPECT_EQ(middle(rendered(scene, options))[0], 0);
}

TEST(TransparentShadows, LetThroughWhatATextureSays) {
  Scene scene = narrow_scene({.ambient = {}, .diffuse = {1, 1, 1}});
  Texture pattern;
  pattern.kind = TextureKind::checker;
  pattern.colors = {{0.25, 0.25, 0.25}, {0.25, 0.25, 0.25}};
  scene.textures = {pattern};
  scene.materials.push_back(
      {.ambient = {}, .diffuse = {}, .refraction = 1, .textures = {{Coefficient::refraction, 0}}});
  add_wall(scene, 0, 1, 0);
  scene.lights = {{{30, 0, 40}}};
  scene.spheres.push_back({Sphere{{6, 0, 8}, 1}, 1});
  EXPECT_NEAR(middle(rendered(scene, {.shadows = Shadows::transparent}))[0], 0.8 * 0.25, 1e-6);
}

TEST(TransparentShadows, AbsorbByTheLengthInside) {
  Scene scene = narrow_scene({.ambient = {}, .diffuse = {1, 1, 1}});
  scene.materials.push_back(
      {.ambient = {}, .diffuse = {}, .refraction = 0.5, .absorption = {1, 0.5, 0}});
  add_wall(scene, 0, 1, 0);
  scene.lights = {{{30, 0, 40}}};
  scene.spheres.push_back({Sphere{{6, 0, 8}, 0.75}, 1});
  const auto seen = middle(rendered(scene, {.shadows = Shadows::transparent}));
  EXPECT_NEAR(seen[0], 0.8 * 0.5 * std::exp(-1.5), 1e-5);
  EXPECT_NEAR(seen[1], 0.8 * 0.5 * std::exp(-0.75), 1e-5);
  EXPECT_NEAR(seen[2], 0.8 * 0.5, 1e-5);
}

/// A lamp, or the whole way to it, inside of what absorbs: the last stretch counts, too.
TEST(TransparentShadows, AbsorbUpToALightInside) {
  Scene scene = narrow_scene({.ambient = {}, .diffuse = {1, 1, 1}});
  scene.materials.push_back(
      {.ambient = {}, .diffuse = {}, .refraction = 1, .absorption = {0.5, 0.5, 0.5}});
  add_wall(scene, 0, 1, 0);
  scene.spheres.push_back({Sphere{{0, 0, 6}, 2}, 1});
  scene.lights = {{{0, 0, 6}}};
  scene.camera.eye = {3, 0, 4};
  const RenderOptions options{.shadows = Shadows::transparent};
  EXPECT_NEAR(middle(rendered(scene, options))[0], std::exp(-1.0), 1e-5);
  // Both under water, and the eye, too.
  scene.spheres.clear();
  scene.boxes.push_back({Box{{-50, -50, -1}, {50, 50, 20}}, 1});
  EXPECT_NEAR(middle(rendered(scene, options))[0], std::exp(-0.5 * 6) * std::exp(-0.5 * 5), 1e-5);
}

TEST(TransparentShadows, OfSheetsDoNotDependOnTheirSide) {
  Scene scene = narrow_scene({.ambient = {}, .diffuse = {1, 1, 1}});
  scene.materials.push_back(
      {.ambient = {}, .diffuse = {}, .refraction = 0.8, .absorption = {0.5, 0.5, 0.5}});
  add_wall(scene, 0, 1, 0);
  scene.lights = {{{30, 0, 40}}};
  const RenderOptions options{.shadows = Shadows::transparent};
  for (const double side : {-1.0, 1.0}) {
    scene.parallelograms.resize(1);
    scene.parallelograms.push_back({Parallelogram{{3, -side, 8}, {6, 0, 0}, {0, 2 * side, 0}}, 1});
    EXPECT_NEAR(middle(rendered(scene, options))[0], 0.8 * 0.8, 1e-6) << side;
  }
}

TEST(TransparentShadows, StopAtWhatIsOpaqueInABody) {
  for (const double where : {-0.8, 0.8}) {
    Scene scene = narrow_scene({.ambient = {}, .diffuse = {1, 1, 1}});
    scene.materials.push_back({.ambient = {}, .diffuse = {}, .refraction = 0.8});
    scene.materials.push_back({});
    add_wall(scene, 0, 1, 0);
    scene.lights = {{{30, 0, 40}}};
    Csg both{CsgOperation::unite, {}};
    both.of.push_back({Box{{5, -1, 7}, {7, 1, 9}}, 1, 0, ""});
    both.of.push_back(
        {Ellipsoid{{6 + where * 0.6, 0, 8 + where * 0.8}, {0.6, 0.6, 0.6}}, 2, 0, ""});
    scene.csgs.push_back({std::move(both), 1});
    EXPECT_EQ(middle(rendered(scene, {.shadows = Shadows::transparent}))[0], 0) << where;
  }
}

/// What has the index of what is around it cannot be seen, also where the eye is in it.
TEST(Priorities, KnowWhatTheEyeIsInsideOf) {
  Scene scene = narrow_scene({.ambient = {},
                              .diffuse = {},
                              .refraction = 1,
                              .ior = 1.33,
                              .absorption = {0.1, 0.1, 0.1},
                              .priority = 1});
  scene.materials.push_back(
      {.ambient = {}, .diffuse = {}, .refraction = 1, .ior = 1.33, .priority = 2});
  scene.background = {1, 1, 1};
  scene.camera = {{0.3, 0, 4}, {0.3, 0, 0}, {0.001, 0, 0}, {0, 0.001, 0}};
  scene.boxes.push_back({Box{{-9, -9, -5}, {9, 9, 5}}, 0});
  scene.spheres.push_back({Sphere{{0, 0, 0}, 1}, 1});
  RenderOptions options;
  options.max_depth = 6;
  // 9 of water, less the chord through the ball, which is clear.
  const double chord = 2 * std::sqrt(1 - 0.09);
  EXPECT_NEAR(middle(rendered(scene, options))[0], std::exp(-0.1 * (9 - chord)), 1e-4);
}

/// A sphere of air in glass does not bend light as one of glass in air does; with priorities the
/// air that is in the glass counts, or does not.
TEST(Priorities, SayWhichOfOverlappingBodiesCounts) {
  Scene scene;
  scene.resolution = {1, 1};
  scene.background = {1, 1, 1};
  // 9 above the uppermost face, so that the ray comes to (0, 0, 1).
  scene.camera = {{-4.5, 0, 10}, {0.5, 0, 0}, {1e-4, 0, 0}, {0, 1e-4, 0}};
  // Glass with water, which overlap: the ray meets glass, water's face within it, then water alone.
  scene.materials = {{.ambient = {}, .diffuse = {}, .refraction = 1, .ior = 1.5, .priority = 2},
                     {.ambient = {}, .diffuse = {}, .refraction = 1, .ior = 1.33, .priority = 1},
                     {.ambient = {1, 0, 0}, .diffuse = {}}};
  scene.boxes.push_back({Box{{-5, -5, 0}, {5, 5, 1}}, 0});
  scene.boxes.push_back({Box{{-6, -6, -2}, {6, 6, 0.4}}, 1});
  // Where it comes out of the water, at z = -2, by Snell's law through parallel faces.
  const double sine = 5 / std::sqrt(125.0);
  const auto step = [&](double n, double thickness) {
    const double s = sine / n;
    return thickness * s / std::sqrt(1 - s * s);
  };
  const double exit = step(1.5, 1) + step(1.33, 2);
  // A target that only that ray hits, just behind.
  const double beyond = exit + 0.1 * sine / std::sqrt(1 - sine * sine);
  scene.spheres.push_back({Sphere{{beyond, 0, -2.1}, 0.01}, 2});
  RenderOptions options;
  options.max_depth = 8;
  EXPECT_NEAR(middle(rendered(scene, options))[1], 0, 1e-6);
  // Without priorities each face bends as if air were on its other side.
  scene.materials[0].priority = scene.materials[1].priority = 0;
  EXPECT_NEAR(middle(rendered(scene, options))[1], 1, 1e-6);
}

/// C = a·(1 + k + k² + …), to the depth.
TEST(Mirrors, ThatFaceEachOtherGiveAGeometricSeries) {
  Scene scene = narrow_scene(
      {.ambient = {0.1, 0.2, 0.3}, .diffuse = {}, .reflection = Color{0.9, 0.5, 0.25}});
  scene.camera = {{0, 0, 1}, {0, 0, 0}, {0.001, 0, 0}, {0, 0.001, 0}};
  add_wall(scene, -2, 5, 0);
  add_wall(scene, 3, 5, 0);
  RenderOptions options;
  options.max_depth = 40;
  const auto seen = middle(rendered(scene, options));
  const double a[] = {0.1, 0.2, 0.3}, k[] = {0.9, 0.5, 0.25};
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(static_cast<double>(seen[static_cast<std::size_t>(c)]),
                a[c] * (1 - std::pow(k[c], 41)) / (1 - k[c]), 1e-5);
}

/// A prism of 60°, as what three planes have in common; its edges go along z.
void add_prism(Scene& scene, std::uint32_t material) {
  Csg prism{CsgOperation::intersect, {}};
  for (const double angle : {90.0, 210.0, 330.0}) {
    const double x = std::cos(angle * kPi / 180), y = std::sin(angle * kPi / 180);
    prism.of.push_back({Plane{{x, y, 0}, {x, y, 0}}, kMaterialOfWhole, 0, ""});
  }
  prism.of.push_back({Box{{-9, -9, -9}, {9, 9, 9}}, kMaterialOfWhole, 0, ""});
  scene.csgs.push_back({std::move(prism), material});
}

/// δ = i + e - 60°, sin e = n·sin(60° - asin(sin(i)/n)), for each wavelength.
TEST(Dispersion, DeviatesEachWavelengthByThePrismsFormula) {
  Scene scene;
  scene.resolution = {1, 1};
  scene.materials = {{.ambient = {},
                      .diffuse = {},
                      .refraction = 1,
                      .dispersion = {Dispersion::Kind::cauchy, {1.5046, 0.0042, 0, 0, 0, 0}}}};
  add_prism(scene, 0);
  // Into the face whose normal is at 210°, 49° off it; the next is the one at 330°.
  const double incidence = 49 * kPi / 180, toward = 210 * kPi / 180 + kPi + incidence;
  const Vec3 on{std::cos(210 * kPi / 180), std::sin(210 * kPi / 180), 0};
  const Vec3 way{std::cos(toward), std::sin(toward), 0};
  scene.camera = {
      {on.x - 5 * way.x, on.y - 5 * way.y, 0}, on, {0, 0, 1e-4}, {-1e-4 * way.y, 1e-4 * way.x, 0}};
  RenderOptions options;
  options.max_depth = 2;
  options.wavelengths = 16;
  const Result<Explanation> explanation = explain(scene, options, 0, 0);
  ASSERT_TRUE(explanation);
  int left = 0;
  for (const ExplainedRay& ray : explanation->trees.front().rays) {
    if (ray.depth != 2 || ray.kind != RayKind::refracted) continue;
    ASSERT_TRUE(ray.nm);
    const double um = *ray.nm / 1000, n = 1.5046 + 0.0042 / (um * um);
    const double inner = 60 * kPi / 180 - std::asin(std::sin(incidence) / n);
    const double deviation = incidence + std::asin(n * std::sin(inner)) - 60 * kPi / 180;
    const double cosine = static_cast<double>(ray.direction[0]) * way.x +
                          static_cast<double>(ray.direction[1]) * way.y;
    EXPECT_NEAR(std::acos(cosine), deviation, 1e-4) << *ray.nm;
    ++left;
  }
  EXPECT_EQ(left, 16);
}

TEST(Dispersion, LeavesWhiteWhite) {
  Scene scene;
  scene.resolution = {40, 40};
  scene.camera = {{0, 0, 5}, {0, 0, 0}, {2.2, 0, 0}, {0, 2.2, 0}};
  scene.background = {1, 1, 1};
  scene.materials = {{.ambient = {},
                      .diffuse = {},
                      .refraction = 1,
                      .dispersion = {Dispersion::Kind::abbe, {25, 0, 0, 0, 0, 0}}}};
  scene.materials[0].ior = 1.7;
  scene.spheres.push_back({Sphere{{0, 0, 0}, 1}, 0});
  RenderOptions options;
  options.max_depth = 2;
  options.terms.reflection = false;
  const Image image = rendered(scene, options);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    EXPECT_NEAR(image.pixels[i], image.pixels[i + 1], 0.001);
    EXPECT_NEAR(image.pixels[i], image.pixels[i + 2], 0.001);
  }
}

/// Everything at once: the same bits from any number of threads, tile and instruction set.
TEST(GeneralEngine, HasTheSameBitsEverywhere) {
#if defined(ZRAKA_SANITIZED)
  constexpr std::uint32_t kSide = 10;
#else
  constexpr std::uint32_t kSide = 20;
#endif
  Scene scene = mixed_scene(kSide);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    Material& m = scene.materials[i];
    m.fresnel = static_cast<Fresnel>(i % 3);
    m.highlight = static_cast<Highlight>(i % 2);
    m.absorption = {0.1 * static_cast<double>(i % 4), 0.2, 0};
    m.priority = static_cast<int>(i % 3);
    if (i % 4 == 1) m.dispersion = {Dispersion::Kind::abbe, {30, 0, 0, 0, 0, 0}};
    m.ior = 1.2 + 0.1 * static_cast<double>(i % 5);
    m.refraction = Color{0.5, 0.6, 0.7};
  }
  scene.lights.push_back(
      {.position = {1, 3, 2}, .kind = LightKind::disc, .radius = 0.5, .samples = 4});
  scene.lights.push_back(
      {.position = {-1, 3, 2}, .kind = LightKind::sphere, .radius = 0.3, .samples = 3});
  scene.lights.push_back({.position = {-1, 2, 3},
                          .kind = LightKind::spot,
                          .attenuation = {1, 0.1, 0},
                          .direction = {1, -1, -3}});
  scene.ambient_occlusion = {.samples = 8};
  scene.sky = {.kind = Sky::Kind::gradient, .bottom = {0.2, 0.1, 0}, .top = {0.3, 0.5, 1}};
  RenderOptions options{.max_depth = 3, .shadows = Shadows::transparent, .wavelengths = 3};
  options.min_contribution = 0.001;
  options.sampling.count = 2;
  options.sampling.filter = PixelFilter::mitchell;
  options.threads = 1;
  options.isa = Isa::portable;
  const std::string wanted = sha256(rendered(scene, options));
  for (const Isa isa : available_isas())
    for (const int threads : {1, 3})
      for (const int tile : {5, 64}) {
        options.isa = isa, options.threads = threads, options.tile = tile;
        EXPECT_EQ(sha256(rendered(scene, options)), wanted) << name_of(isa) << threads << tile;
      }
}

/// A light that is as bright as one likes close by has no bound, whatever else is 0.
TEST(Contributions, AreNotCutWhereNothingBoundsThem) {
  Scene scene = narrow_scene({.ambient = {}, .diffuse = {}, .reflection = 1});
  scene.materials.push_back({.ambient = {}, .diffuse = {0, 0.5, 0.5}});
  add_wall(scene, 0, 1, 0);
  add_wall(scene, 20, 30, 1);
  scene.lights = {{.position = {0, 0, 15}, .color = {0, 1, 0}, .attenuation = {0, 0, 1}}};
  RenderOptions options;
  const auto whole = middle(rendered(scene, options));
  EXPECT_GT(whole[1], 0.01);
  options.min_contribution = 1e-4;
  const auto uncut = middle(rendered(scene, options));
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(uncut[c], whole[c], 1e-6) << c;
}

TEST(Contributions, BelowTheThresholdAreBoundedByWhatWasCut) {
  for (const NamedScene& named : test_scenes(100)) {
    RenderOptions options{.profile = profile_of(ProfileName::physical)};
    options.max_depth = 8;
    options.min_contribution = 1e-30;
    const Result<Rendering> full = render(named.scene, options);
    options.min_contribution = 1.0 / 255;
    const Result<Rendering> cut = render(named.scene, options);
    ASSERT_TRUE(full && cut);
    double most = 0;
    for (std::size_t i = 0; i < full->image.pixels.size(); ++i)
      most = std::max(most, std::fabs(static_cast<double>(full->image.pixels[i]) -
                                      static_cast<double>(cut->image.pixels[i])));
    EXPECT_LE(most, cut->stats.most_cut * 1.0001 + 1e-6) << named.name;
    EXPECT_LE(cut->stats.rays.total(), full->stats.rays.total());
  }
}

}  // namespace
}  // namespace zraka
