// SPDX-License-Identifier: Apache-2.0
// Pictures whose colours follow from the sheet's formulas in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "scenes.hpp"

namespace zraka {
namespace {

struct Pixel {
  float r, g, b;
};

RenderOptions lab(Stage stage = Stage::refraction) {
  return {.terms = terms_of(stage), .profile = profile_of(ProfileName::lab)};
}

Pixel pixel_of(const Scene& scene, const RenderOptions& options, std::uint32_t x, std::uint32_t y) {
  const Image image = render(scene, options).value().image;
  const float* p = image.row(y) + 3 * x;
  return {p[0], p[1], p[2]};
}

void expect_pixel(Pixel got, double r, double g, double b, double tolerance = 1e-5) {
  EXPECT_NEAR(got.r, r, tolerance);
  EXPECT_NEAR(got.g, g, tolerance);
  EXPECT_NEAR(got.b, b, tolerance);
}

/// One sphere of radius 1 at (0, 0, -1), touching the window; eye (0, 0, 2).
Scene one_sphere(Material material) {
  Scene scene = lab_scene();
  add_sphere(scene, {0, 0, -1}, 1, material);
  return scene;
}

TEST(Lab, LooksThroughThePixelsUpperLeftCorner) {
  // The sheet: of 400 pixels and a window of 2, pixel (-200, -200) is (-1, -1, 0). Row 0 is at the
  // top, y up; a tiny sphere in the window's plane covers just the pixel whose corner it sits on.
  for (const auto& [x, y, column, row] :
       {std::tuple{-1.0, 1.0, 0u, 0u}, {0.0, 0.0, 200u, 200u}, {0.5, 0.25, 300u, 150u}}) {
    Scene scene = lab_scene(400);
    add_sphere(scene, {x, y, 0}, 0.001, {});
    const Image image = render(scene, lab(Stage::silhouette)).value().image;
    std::size_t white = 0;
    for (const float v : image.pixels) white += v == 1.0f;
    EXPECT_EQ(white, 3u) << x << ", " << y;
    EXPECT_EQ(image.row(row)[3 * column], 1.0f) << x << ", " << y;
  }
}

TEST(Physical, LooksThroughPixelCenters) {
  Scene scene = lab_scene(400);
  add_sphere(scene, {0.5 / 200, -0.5 / 200, 0}, 0.001, {});
  const Image image = render(scene, {.terms = terms_of(Stage::silhouette),
                                     .profile = profile_of(ProfileName::physical)})
                          .value()
                          .image;
  EXPECT_EQ(image.row(200)[3 * 200], 1.0f);
}

TEST(Lab, HasAmbientLightOfAHalf) {
  expect_pixel(pixel_of(one_sphere({.ambient = {0.2, 0.4, 1}}), lab(Stage::ambient), 50, 50), 0.1,
               0.2, 0.5);
}

TEST(Lab, LightsByLambertsLaw) {
  // The middle ray hits (0, 0, 0), where N = (0, 0, 1); L is from there to (0, 2, 2).
  const Material m{.ambient = {0, 0, 0}, .diffuse = {0.2, 0.4, 1}};
  const double l_n = std::sqrt(0.5);
  expect_pixel(pixel_of(one_sphere(m), lab(Stage::diffuse), 50, 50), 0.2 * l_n, 0.4 * l_n, l_n);
}

TEST(Lab, ShinesByPhongsLaw) {
  // There R = (0, -1, 1)/√2 and V = (0, 0, 1): R·V = √½.
  const Material m{
      .ambient = {0, 0, 0}, .diffuse = {0, 0, 0}, .specular = {1, 0.5, 0}, .shininess = 6};
  expect_pixel(pixel_of(one_sphere(m), lab(Stage::specular), 50, 50), 0.125, 0.0625, 0);
}

TEST(Lab, LeavesTheFarSideOfTheLightDark) {
  // An even exponent of a negative R·V, and L·N < 0, must not light anything.
  Scene scene = one_sphere(
      {.ambient = {0, 0, 0}, .diffuse = {1, 1, 1}, .specular = {1, 1, 1}, .shininess = 2});
  scene.lights[0].position = {0, 0, -4};
  expect_pixel(pixel_of(scene, lab(), 50, 50), 0, 0, 0);
}

TEST(Lab, AddsLightsButAmbientOnce) {
  Scene scene = one_sphere({.ambient = {0.2, 0.2, 0.2}, .diffuse = {0.3, 0.3, 0.3}});
  scene.lights = {{{0, 0, 4}, {1, 0, 0}}, {{0, 0, 6}, {0.5, 1, 0}}};
  expect_pixel(pixel_of(scene, lab(), 50, 50), 0.1 + 0.45, 0.1 + 0.3, 0.1);
}

TEST(Shadow, LeavesAmbientLight) {
  Scene scene = one_sphere({.ambient = {0.4, 0.4, 0.4}, .diffuse = {1, 1, 1}});
  add_sphere(scene, {0, 1, 1}, 0.2, {});
  expect_pixel(pixel_of(scene, lab(Stage::shadows), 50, 50), 0.2, 0.2, 0.2);
}

TEST(Shadow, IsNotThrownByWhatIsBehindTheLight) {
  Scene scene = one_sphere({.ambient = {0, 0, 0}, .diffuse = {1, 1, 1}});
  add_sphere(scene, {0, 3, 3}, 0.2, {});
  const double l_n = std::sqrt(0.5);
  expect_pixel(pixel_of(scene, lab(Stage::shadows), 50, 50), l_n, l_n, l_n);
}

TEST(Shadow, IsThrownByTheShapeItself) {
  // Seen from inside, the light outside is behind the sphere's own wall.
  Scene scene = lab_scene();
  add_sphere(scene, {0, 0, 2}, 3, {.ambient = {0.4, 0.4, 0.4}, .diffuse = {1, 1, 1}});
  scene.lights[0].position = {0, 0, 9};
  expect_pixel(pixel_of(scene, lab(), 50, 50), 0.2, 0.2, 0.2);
  scene.lights[0].position = {0, 0, 3};
  expect_pixel(pixel_of(scene, lab(), 50, 50), 1, 1, 1);
}

TEST(Shadow, HasNoAcneOnAnySphere) {
  // A sphere that only lies in light: every lit pixel must keep its light, at grazing angles too,
  // wherever the scene is and whatever its scale.
  for (const double scale : {1e-6, 1.0, 1e6}) {
    Scene scene = lab_scene(200);
    const auto scaled = [&](Vec3 v) { return Vec3{v.x * scale, v.y * scale, v.z * scale}; };
    scene.camera = {scaled({0, 0, 2}), {}, scaled({2, 0, 0}), scaled({0, 2, 0})};
    scene.lights[0].position = scaled({5, 1, -1});
    add_sphere(scene, scaled({0, 0, -1}), scale, {.reflection = 0});
    const Image with = render(scene, lab(Stage::shadows)).value().image;
    const Image without = render(scene, lab(Stage::specular)).value().image;
    EXPECT_EQ(with.pixels, without.pixels) << scale;
  }
}

TEST(Reflection, ShowsWhatTheMirrorFaces) {
  // The middle ray comes straight back to the eye and goes on to the sphere behind it.
  Scene scene = one_sphere({.ambient = {0.2, 0.2, 0.2}, .diffuse = {0, 0, 0}, .reflection = 0.5});
  add_sphere(scene, {0, 0, 10}, 1, {.ambient = {0, 1, 0}, .diffuse = {0, 0, 0}});
  expect_pixel(pixel_of(scene, lab(Stage::shadows), 50, 50), 0.1, 0.1, 0.1);
  expect_pixel(pixel_of(scene, lab(Stage::reflection), 50, 50), 0.1, 0.1 + 0.5 * 0.5, 0.1);
}

TEST(Reflection, EndsAtTheGreatestDepth) {
  // Two mirrors face each other; each bounce adds 0.1·½^depth, and depth counts from 0.
  Scene scene = lab_scene();
  scene.camera.eye = {0, 0, 0.5};
  scene.lights.clear();
  const Material mirror{.ambient = {0.2, 0.2, 0.2}, .reflection = 0.5};
  add_sphere(scene, {0, 0, -1}, 1, mirror);
  add_sphere(scene, {0, 0, 2}, 1, mirror);
  RenderOptions options = lab();
  for (int depth = 0; depth <= 6; ++depth) {
    options.max_depth = depth;
    const double want = 0.2 * (1 - std::pow(0.5, depth + 1));
    expect_pixel(pixel_of(scene, options, 50, 50), want, want, want);
  }
}

TEST(Refraction, GoesStraightThroughTheMiddle) {
  // Entry, exit, and the sphere behind: three levels of rays.
  Scene scene =
      one_sphere({.ambient = {0, 0, 0}, .diffuse = {0, 0, 0}, .refraction = 0.8, .ior = 0.6});
  add_sphere(scene, {0, 0, -9}, 1, {.ambient = {1, 0, 0}, .diffuse = {0, 0, 0}});
  expect_pixel(pixel_of(scene, lab(), 50, 50), 0.8 * 0.8 * 0.5, 0, 0);
  RenderOptions shallow = lab();
  shallow.max_depth = 1;
  expect_pixel(pixel_of(scene, shallow, 50, 50), 0, 0, 0);
}

/// A beam into a sphere of index ratio b on entry, at distance x from its middle line, comes out
/// turned by 2(α - β), where sin α = x, sin β = b·x.
TEST(Refraction, TurnsTheRayBySnellsLaw) {
  constexpr double kX = 0.5, kB = 0.7;
  const double alpha = std::asin(kX), beta = std::asin(kB * kX);
  const double turn = 2 * (alpha - beta);
  // Where the ray leaves, in the plane y = 0 of a unit sphere around the origin, coming along -z.
  const double exit_angle = std::asin(kX) + (M_PI - 2 * beta);
  const Vec3 out{std::sin(exit_angle), 0, std::cos(exit_angle)};
  const Vec3 along{-std::sin(turn), 0, -std::cos(turn)};
  Scene scene = lab_scene(100);
  scene.lights.clear();
  scene.camera = {{kX, 0, 1000}, {kX, 0, 999}, {1e-4, 0, 0}, {0, 1e-4, 0}};
  add_sphere(scene, {0, 0, 0}, 1, {.ambient = {0, 0, 0}, .refraction = 1, .ior = kB});
  add_sphere(scene, {out.x + 5 * along.x, 0, out.z + 5 * along.z}, 0.01, {.ambient = {1, 1, 1}});
  expect_pixel(pixel_of(scene, lab(), 50, 50), 0.5, 0.5, 0.5);
  // The physical profile takes the index of the inside, 1/b.
  scene.materials[0].ior = 1 / kB;
  RenderOptions physical{.profile = profile_of(ProfileName::physical)};
  physical.profile.pixel_centers = false;
  expect_pixel(pixel_of(scene, physical, 50, 50), 0.5, 0.5, 0.5);
}

/// From inside a sphere of ratio 1.5 on entry (so 1/1.5 on exit … seen the lab's way: dense
/// outside), rays through a smaller inner sphere of ratio 1.5 reflect totally beyond sin α = 1/1.5.
TEST(Refraction, IsTotalReflectionBeyondTheCriticalAngle) {
  const auto center = [](double sine, ProfileName profile, double reflection) {
    Scene scene = lab_scene(100);
    scene.lights.clear();
    scene.background = {0, 1, 0};
    scene.camera = {{sine, 0, 1000}, {sine, 0, 999}, {1e-4, 0, 0}, {0, 1e-4, 0}};
    const double ior = profile == ProfileName::lab ? 1.5 : 1 / 1.5;
    add_sphere(scene, {0, 0, 0}, 1,
               {.ambient = {0.2, 0, 0}, .reflection = reflection, .refraction = 0.5, .ior = ior});
    RenderOptions options{.profile = profile_of(profile)};
    options.profile.pixel_centers = false;
    return pixel_of(scene, options, 50, 50);
  };
  // Just inside the critical angle the ray enters and leaves to the background; the second surface
  // counts too.
  expect_pixel(center(0.66, ProfileName::lab, 0), 0.1 + 0.5 * 0.1, 0.25, 0);
  expect_pixel(center(0.68, ProfileName::lab, 0), 0.1, 0, 0);         // its share is black
  expect_pixel(center(0.68, ProfileName::lab, 0.3), 0.1, 0.3, 0);     // the mirror's share stays
  expect_pixel(center(0.68, ProfileName::physical, 0), 0.1, 0.5, 0);  // a mirror takes it
  expect_pixel(center(0.68, ProfileName::physical, 0.3), 0.1, 0.8, 0);
}

TEST(Fold, ClampsAtEveryLevelInTheLab) {
  // A mirror at half strength sees something of brightness 2: the lab clamps it to 1 first.
  Scene scene = one_sphere({.ambient = {0, 0, 0}, .diffuse = {0, 0, 0}, .reflection = 0.5});
  scene.lights.clear();
  add_sphere(scene, {0, 0, 10}, 1, {.ambient = {4, 4, 4}});
  expect_pixel(pixel_of(scene, lab(), 50, 50), 0.5, 0.5, 0.5);
  RenderOptions physical{.profile = profile_of(ProfileName::physical)};
  physical.profile.pixel_centers = false;
  expect_pixel(pixel_of(scene, physical, 50, 50), 1, 1, 1);
}

TEST(Render, GivesTheBackgroundWhereNothingIs) {
  Scene scene = lab_scene();
  scene.background = {0.25, 0.5, 0.75};
  expect_pixel(pixel_of(scene, lab(), 3, 4), 0.25, 0.5, 0.75, 0);
}

TEST(Render, TakesTheNearestHit) {
  Scene scene = lab_scene();
  add_sphere(scene, {0, 0, -5}, 1, {.ambient = {1, 0, 0}});
  add_sphere(scene, {0, 0, -2}, 1, {.ambient = {0, 1, 0}});
  add_sphere(scene, {0, 0, -8}, 1, {.ambient = {0, 0, 1}});
  expect_pixel(pixel_of(scene, lab(Stage::ambient), 50, 50), 0, 0.5, 0);
}

TEST(Render, TakesTheFirstOfEqualShapes) {
  Scene scene = lab_scene();
  add_sphere(scene, {0, 0, -2}, 1, {.ambient = {0, 1, 0}});
  add_sphere(scene, {0, 0, -2}, 1, {.ambient = {1, 0, 0}});
  expect_pixel(pixel_of(scene, lab(Stage::ambient), 50, 50), 0, 0.5, 0);
}

TEST(Render, CountsRaysOfEachKind) {
  Scene scene = lab_scene(10);
  add_sphere(scene, {0, 0, 2}, 100,
             {.diffuse = {1, 1, 1}, .reflection = 0.5, .refraction = 0.5, .ior = 1});
  scene.lights[0].position = {0, 0, 2};
  RenderOptions options = lab();
  options.max_depth = 1;
  const RayCounts rays = render(scene, options).value().stats.rays;
  EXPECT_EQ(rays.camera, 100u);
  EXPECT_EQ(rays.reflected, 100u);
  EXPECT_EQ(rays.refracted, 100u);
  EXPECT_EQ(rays.hits, 200u)
      << "camera rays and reflected rays meet the sphere, refracted ones are outside";
  EXPECT_EQ(rays.shadow, 200u);
}

TEST(Render, BoundsItsMemoryHoweverTreesBranch) {
  // Glass and mirrors everywhere: thousands of rays a pixel, more than a level holds at once.
  Scene scene = tangled_scene(8);
  for (Material& m : scene.materials) m.reflection = m.refraction = 0.5;
  RenderOptions options = lab();
  options.max_depth = 16;
  const Rendering all = render(scene, options).value();
  options.tile = 1;
  const Rendering single = render(scene, options).value();
  EXPECT_GT(all.stats.rays.total(), 64u * 1000u);
  EXPECT_EQ(sha256(all.image), sha256(single.image));
  EXPECT_EQ(all.stats.rays.total(), single.stats.rays.total());
}

TEST(Render, EndsWhenItIsCancelled) {
  std::atomic<bool> cancel{true};
  RenderOptions options = lab();
  options.cancel = &cancel;
  const Result<Rendering> rendering = render(tangled_scene(), options);
  ASSERT_FALSE(rendering);
  EXPECT_EQ(rendering.error().front().message, "the render was cancelled");
}

TEST(Render, ReportsProgressUpToTheLastPixel) {
  RenderOptions options = lab();
  std::atomic<std::uint64_t> most{0}, all{0};
  options.progress = [&](std::uint64_t pixels, std::uint64_t of, std::uint64_t) {
    std::uint64_t before = most;
    while (before < pixels && !most.compare_exchange_weak(before, pixels)) {
    }
    all = of;
  };
  render(tangled_scene(), options).value();
  EXPECT_EQ(most, 10000u);
  EXPECT_EQ(all, 10000u);
}

TEST(Render, LightsFromAnyDistance) {
  Scene scene = one_sphere({.ambient = {0, 0, 0}, .diffuse = {1, 1, 1}});
  for (const double away : {1e3, 1e15, 1e25, 1e100}) {
    scene.lights[0].position = {0, 0, away};
    expect_pixel(pixel_of(scene, lab(), 50, 50), 1, 1, 1, 1e-4);
  }
}

TEST(Render, OutlivesScenesOfAnySize) {
  for (const double size : {1e-320, 1e-300, 1e-30, 1e30, 1e99}) {
    Scene scene = lab_scene(16);
    for (int i = 0; i < 17; ++i) add_sphere(scene, {0, size, 0}, size / 2, {});
    for (const Isa isa : available_isas()) {
      RenderOptions options = lab();
      options.isa = isa;
      const Result<Rendering> rendering = render(scene, options);
      // Shapes that no pixel can show, so far from the eye for their size, are told.
      EXPECT_EQ(
          rendering ? "" : rendering.error().front().message,
          size < 1 ? "the eye is so far from all shapes that floats cannot hold the distance" : "")
          << size << " with " << name_of(isa);
    }
  }
  Scene scene = lab_scene(16);
  for (int i = 0; i < 17; ++i) add_sphere(scene, {0, 1e308, 0}, 1e308, {});
  EXPECT_EQ(render(scene, lab()).error().front().message,
            "sphere 1: it reaches farther than 1e+100 from the origin");
}

TEST(Render, RefusesWhatMakesNoSense) {
  const auto error = [](const Scene& scene, const RenderOptions& options) {
    const Result<Rendering> rendering = render(scene, options);
    return rendering ? std::string("rendered") : rendering.error().front().message;
  };
  Scene scene = lab_scene();
  RenderOptions options = lab();
  options.max_depth = 201;
  EXPECT_EQ(error(scene, options), "depth 201 is out of range: 0 to 200");
  options = lab();
  options.tile = 65;
  EXPECT_EQ(error(scene, options), "tile side 65 is out of range: 0 to 64");
  options = lab();
  add_sphere(scene, {0, 0, 0}, -1, {});
  EXPECT_EQ(error(scene, options), "sphere 1: its radius is not a finite number above 0");
  scene.spheres[0] = {{{0, 0, std::nan("")}, 1}, 7};
  EXPECT_EQ(error(scene, options), "sphere 1: its centre is not finite");
  scene.spheres[0].shape.center.z = 0;
  EXPECT_EQ(error(scene, options), "sphere 1: it has material 7, but there are 1");
  scene = lab_scene();
  scene.resolution = {40000, 40000};
  EXPECT_EQ(error(scene, options),
            "a picture of 40000×40000 pixels is too large: at most 134217728 pixels fit");
}

}  // namespace
}  // namespace zraka
