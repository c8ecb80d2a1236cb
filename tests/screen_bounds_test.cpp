// SPDX-License-Identifier: Apache-2.0
// Pixels that are not asked for show nothing but background.
#include "render/screen_bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>
#include <zraka/formats.hpp>

#include "render/corners.hpp"
#include "render/isa.hpp"
#include "render/prepare.hpp"
#include "render/sample_rays.hpp"
#include "render/workspace.hpp"
#include "scenes.hpp"

namespace zraka {
namespace {

/// Every pixel asked for, by the renderer's own arithmetic.
Image every_ray_traced(const PreparedScene<float>& prepared, const Resolution& resolution,
                       const RenderOptions& options) {
  const bool average = options.profile.average_corners;
  const std::uint32_t width = resolution.width + (average ? 1 : 0),
                      height = resolution.height + (average ? 1 : 0);
  Image image(width, height);
  WorkspaceMemory<float> memory(static_cast<std::int32_t>(width * height), options.max_depth, false);
  RayCounts counts;
  kernel_of(*options.isa)
      .trace_tile(prepared.store->scene, settings_of(options, prepared),
                  {0, 0, static_cast<std::int32_t>(width), static_cast<std::int32_t>(height)},
                  memory.workspace(), counts, image.pixels.data(), width);
  return average ? means_of_corners(std::move(image)) : image;
}

RenderOptions one_level(ProfileName profile) {
  RenderOptions options;
  options.profile = profile_of(profile);
  options.isa = *choose_isa(std::nullopt);
  options.max_depth = 1;
  options.tile = 16;
  return options;
}

/// Renders, and compares with every ray; of how many pixels rays were traced, or none where the
/// pictures differ.
std::optional<int> traced_alike(const Scene& scene, const RenderOptions& options) {
  const auto prepared = prepare<float>(scene, options);
  const Image want = every_ray_traced(prepared, scene.resolution, options);
  const Result<Rendering> got = render(scene, options);
  if (!got || got->image.pixels.size() != want.pixels.size() ||
      std::memcmp(got->image.pixels.data(), want.pixels.data(),
                  want.pixels.size() * sizeof(float)) != 0)
    return std::nullopt;
  const auto [width, height] = scene.resolution;
  const TileRect part =
      ScreenBounds(prepared.store->scene, width, height)
          .part_of({0, 0, static_cast<std::int32_t>(width), static_cast<std::int32_t>(height)});
  return part.width * part.height;
}

/// An eye in the scene, close to it or far from it; windows of all widths, not all of them upright
/// or rectangular.
Camera random_camera(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto vector = [&](double length) {
    const double x = normal(random), y = normal(random), z = normal(random);
    return Vec3{x * length, y * length, z * length};
  };
  const double away = std::pow(10.0, std::uniform_real_distribution<double>(-1, 2)(random));
  const double wide = std::pow(10.0, std::uniform_real_distribution<double>(-1, 1.5)(random));
  const Vec3 offset = vector(away), off_center = vector(0.7);
  Camera camera;
  camera.eye = {offset.x, offset.y, offset.z - 2};
  camera.window_center = {off_center.x, off_center.y, off_center.z - 2};
  camera.window_right = vector(wide);
  camera.window_up = vector(wide);
  return camera;
}

TEST(ScreenBounds, LeaveOutNothingThatARayMeets) {
  std::mt19937 random(23);
  Scene few = lab_scene();
  for (const double x : {-1.0, 0.2, 0.9})
    add_sphere(few, {x, 0.3 * x, -2 - x}, 0.4, {.ambient = {1, 1, 1}, .diffuse = {1, 0, 0}});
  int partly = 0;
  for (Scene scene : {few, tangled_scene(), mixed_scene(), noisy_scene()}) {
    scene.resolution = {61, 47};
    scene.background = {0.1, 0.2, 0.3};
    scene.ambient_light = {0.5, 0.5, 0.5};
    for (int i = 0; i < 40; ++i) {
      scene.camera = random_camera(random);
      const auto traced =
          traced_alike(scene, one_level(i % 2 == 0 ? ProfileName::physical : ProfileName::spd));
      ASSERT_TRUE(traced) << "camera " << i;
      partly += *traced > 0 && *traced < 61 * 47;
    }
  }
  EXPECT_GT(partly, 25) << "too many of these cameras tell nothing";
}

/// Traces a sample of each pixel; whether all that hit something are in the part that bounds leave.
/// Adds how many pixels that part has.
bool hold_all_hits(const Scene& scene, const Sampling& sampling, int& left) {
  const auto profile = profile_of(ProfileName::physical);
  const auto prepared = prepare<float>(scene, RenderOptions{.profile = profile});
  const FrozenScene<float>& frozen = prepared.store->scene;
  const auto width = static_cast<std::int32_t>(scene.resolution.width),
             height = static_cast<std::int32_t>(scene.resolution.height);
  const TileRect part = ScreenBounds(frozen, scene.resolution.width, scene.resolution.height,
                                     PixelFilterShape::of(sampling.filter).radius())
                            .part_of({0, 0, width, height});
  left += part.width * part.height;
  WorkspaceMemory<float> memory(width * height, 0, false);
  Workspace<float>& workspace = memory.workspace();
  const SampleRays<float> samples(frozen.camera, profile, sampling, false);
  RenderOptions options;
  options.terms = terms_of(Stage::silhouette);
  options.max_depth = 0;
  for (std::uint32_t number = 0; number < 4; ++number) {
    for (std::int32_t y = 0, i = 0; y < height; ++y)
      for (std::int32_t x = 0; x < width; ++x, ++i) samples.make(x, y, number, workspace, i);
    workspace.levels[0].ray_count = width * height;
    RayCounts counts;
    kernel_of(*choose_isa(std::nullopt))
        .trace_rays(frozen, settings_of(options, prepared), workspace, counts);
    for (std::int32_t y = 0, i = 0; y < height; ++y)
      for (std::int32_t x = 0; x < width; ++x, ++i) {
        const bool inside =
            x >= part.x && y >= part.y && x < part.x + part.width && y < part.y + part.height;
        if (!inside && workspace.levels[0].rays.r[i] > 0) return false;
      }
  }
  return true;
}

TEST(ScreenBounds, LeaveOutNothingThatASampleOfAnyCameraMeets) {
  std::mt19937 random(24);
  Scene few = lab_scene();
  for (const double x : {-1.0, 0.2, 0.9}) add_sphere(few, {x, 0.3 * x, -2 - x}, 0.4, {});
  int partly = 0;
  for (Scene scene : {few, tangled_scene(), mixed_scene()}) {
    scene.resolution = {61, 47};
    scene.background = {0, 0, 0};
    for (int i = 0; i < 60; ++i) {
      scene.camera = random_camera(random);
      scene.camera.kind = i % 6 == 0   ? CameraKind::fisheye
                          : i % 6 == 1 ? CameraKind::panorama
                          : i % 2 == 0 ? CameraKind::orthographic
                                       : CameraKind::pinhole;
      if (i % 6 == 3) scene.camera.aperture = 0.2;
      const Sampling sampling{.count = 4,
                              .filter = i % 3 == 0 ? PixelFilter::mitchell : PixelFilter::gauss};
      int left = 0;
      ASSERT_TRUE(hold_all_hits(scene, sampling, left)) << "camera " << i;
      partly += left > 0 && left < 61 * 47;
    }
  }
  EXPECT_GT(partly, 20) << "too many of these cameras tell nothing";
}

void expect_rect(const TileRect& rect, const TileRect& want) {
  EXPECT_EQ(rect.x, want.x);
  EXPECT_EQ(rect.y, want.y);
  EXPECT_EQ(rect.width, want.width);
  EXPECT_EQ(rect.height, want.height);
}

TEST(ScreenBounds, OfParallelRaysAreABoxAndAPixelMore) {
  Scene scene = lab_scene();
  scene.camera.kind = CameraKind::orthographic;
  scene.camera.eye = {0, 0, 0};
  scene.camera.window_center = {0, 0, -1};
  scene.camera.window_right = {10, 0, 0};
  scene.camera.window_up = {0, 10, 0};
  scene.materials = {{}};
  scene.spheres.push_back({{{2, 1, -30}, 1}, 0});
  const auto prepared = prepare<float>(scene, RenderOptions{.profile = profile_of(ProfileName::lab)});
  // x from 1 to 3: columns 60 to 80; y from 0 to 2: rows 30 to 50.
  const TileRect part = ScreenBounds(prepared.store->scene, 100, 100).part_of({0, 0, 100, 100});
  expect_rect(part, {59, 29, 23, 23});
  // Samples reach farther.
  expect_rect(ScreenBounds(prepared.store->scene, 100, 100, 2).part_of({0, 0, 100, 100}),
              {57, 27, 27, 27});
  // Behind the eye.
  scene.spheres[0].shape.center.z = 3;
  const auto behind = prepare<float>(scene, RenderOptions{.profile = profile_of(ProfileName::lab)});
  EXPECT_EQ(ScreenBounds(behind.store->scene, 100, 100).part_of({0, 0, 100, 100}).width, 0);
}

TEST(ScreenBounds, CountTheRaysThatTheyAnswer) {
  Scene scene = lab_scene();
  scene.resolution = {61, 47};
  add_sphere(scene, {0, 0, -2}, 0.1, {});
  EXPECT_EQ(render(scene, one_level(ProfileName::physical))->stats.rays.camera, 61u * 47u);
  EXPECT_EQ(render(scene, one_level(ProfileName::spd))->stats.rays.camera, 62u * 48u);
}

/// Half a turn wide or hardly less: rounding turns some rays to what is behind the eye.
TEST(ScreenBounds, AreEverywhereWhereRoundingTurnsRaysBack) {
  const std::pair<std::string, std::string> views[] = {
      {"at -0.9 0.7 -0.1\nup 0 1 0\nangle 179.9999999", "2.4 -1.8 0.3"},
      {"at -0.1 -0.2 0.6\nup 0 1 0\nangle 179.999999", "0.5 0.9 -2.8"},
      {"at 0.9 -0.3 0.1\nup 0 1 0\nangle 179.999999", "-2.8 0.9 -0.3"}};
  for (const auto& [view, center] : views) {
    const auto read = parse_scene("v\nfrom 0 0 0\n" + view +
                                      "\nhither 1\nresolution 21 21\nb 0.1 0.2 0.3\nl 5 5 5\n"
                                      "f 1 0 0 1 0 0 0 0\ns " +
                                      center + " 2\n",
                                  "wide.nff");
    ASSERT_TRUE(read);
    EXPECT_EQ(traced_alike(read->scene, one_level(ProfileName::physical)), 21 * 21) << view;
  }
}

/// The part of a tile in a picture of 100×100 pixels that spheres can be seen in, from the origin
/// through a window from (-1, -1, -1) to (1, 1, -1).
TileRect part_with(const std::vector<Sphere>& spheres, const TileRect& tile = {0, 0, 100, 100}) {
  Scene scene = lab_scene();
  scene.camera.eye = {0, 0, 0};
  scene.camera.window_center = {0, 0, -1};
  scene.camera.window_right = {2, 0, 0};
  scene.camera.window_up = {0, 2, 0};
  scene.materials = {{}};
  for (const Sphere& sphere : spheres) scene.spheres.push_back({sphere, 0});
  const auto prepared = prepare<float>(scene, {.profile = profile_of(ProfileName::lab)});
  return ScreenBounds(prepared.store->scene, 100, 100).part_of(tile);
}

TEST(ScreenBounds, AreABoxAsItIsSeenAndAPixelMore) {
  // x from 0.9 to 2.7, y from -0.9 to 0.9, z from -3 to -4.8: from column 50 + 50·0.9/4.8 = 59.4 to
  // 50 + 50·2.7/3 = 95, from row 50 - 50·0.9/3 = 35 to 65.
  const std::vector<Sphere> sphere = {{{1.8, 0, -3.9}, 0.9}};
  expect_rect(part_with(sphere), {59, 34, 38, 33});
  expect_rect(part_with(sphere, {48, 48, 30, 30}), {59, 48, 19, 19});
}

TEST(ScreenBounds, GrowByWhatFiltersReach) {
  Scene scene = lab_scene();
  scene.camera.eye = {0, 0, 0};
  scene.camera.window_center = {0, 0, -1};
  scene.materials = {{}};
  scene.spheres.push_back({{{1.8, 0, -3.9}, 0.9}, 0});
  const auto prepared = prepare<float>(scene, RenderOptions{.profile = profile_of(ProfileName::lab)});
  expect_rect(ScreenBounds(prepared.store->scene, 100, 100, 2).part_of({0, 0, 100, 100}),
              {57, 32, 42, 37});
}

TEST(ScreenBounds, AreNothingBehindTheEyeAndAllAroundIt) {
  expect_rect(part_with({{{0, 0, 5}, 1}}), {0, 0, 0, 0});
  expect_rect(part_with({{{0, 0, -1}, 3}}), {0, 0, 100, 100});
  // Before the eye and behind it.
  expect_rect(part_with({{{5, 0, 0}, 1}}), {0, 0, 100, 100});
}

TEST(ScreenBounds, LeaveRoomBetweenPartsOfTheHierarchy) {
  std::vector<Sphere> spheres;
  for (int i = 0; i < 40; ++i)
    spheres.push_back({{(i % 2 == 0 ? -3.0 : 3.0) + 0.01 * i, 0.05 * i, -5}, 0.1});
  expect_rect(part_with(spheres, {40, 0, 20, 100}), {40, 0, 0, 0});
  // All together from column 50 - 50·3.1/4.9 = 18.4 to 50 + 50·3.49/4.9 = 85.6.
  EXPECT_EQ(part_with(spheres).x, 18);
  EXPECT_EQ(part_with(spheres).width, 69);
}

}  // namespace
}  // namespace zraka
