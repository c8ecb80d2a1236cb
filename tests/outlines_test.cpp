// SPDX-License-Identifier: Apache-2.0
// Black lines where objects, depths or edges meet, the depth cue, and what is said of cuts and lines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <zraka/explain.hpp>
#include <zraka/render.hpp>

#include "explain/json.hpp"
#include "explain/page.hpp"
#include "explain/text.hpp"
#include "scene/depth_cue.hpp"

namespace zraka {
namespace {

Rendering rendered(const Scene& scene, const RenderOptions& options) {
  Result<Rendering> rendering = render(scene, options);
  if (!rendering) ADD_FAILURE() << to_string(rendering.error().front());
  return rendering ? std::move(*rendering) : Rendering();
}
bool is_black(const Image& image, std::uint32_t x, std::uint32_t y) {
  const float* const p = image.row(y) + 3 * x;
  return p[0] == 0 && p[1] == 0 && p[2] == 0;
}

/// Parallel rays along -z; everything is bright, so that what is black is a line.
Scene bright_scene(std::uint32_t side = 40) {
  Scene scene;
  scene.resolution = {side, side};
  scene.camera = {{0, 0, 10}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  scene.camera.kind = CameraKind::orthographic;
  scene.materials = {{.ambient = {1, 1, 1}, .diffuse = {}}};
  scene.ambient_light = {1, 1, 1};
  scene.background = {1, 1, 1};
  return scene;
}

TEST(Outlines, GoRoundWhatIsSeen) {
  Scene scene = bright_scene();
  scene.spheres = {{Sphere{{0, 0, 0}, 1.2}, 0}};
  const auto in_disc = [](int x, int y) {
    return std::hypot((x + 0.5) / 10 - 2, 2 - (y + 0.5) / 10) < 1.2;
  };
  for (const int width : {1, 2, 3, 6}) {
    const Rendering picture = rendered(scene, {.outlines = width});
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) {
        // By the definition: a pixel that differs from the one to its right or below is near.
        bool line = false;
        for (int j = y - width / 2; j <= y + (width - 1) / 2; ++j)
          for (int i = x - width / 2; i <= x + (width - 1) / 2; ++i)
            line = line || (i >= 0 && j >= 0 && i < 39 && in_disc(i, j) != in_disc(i + 1, j)) ||
                   (i >= 0 && j >= 0 && j < 39 && in_disc(i, j) != in_disc(i, j + 1));
        EXPECT_EQ(
            is_black(picture.image, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)),
            line)
            << x << ", " << y << ", " << width;
      }
  }
}

TEST(Outlines, AreAtEdgesAndGapsOfOneObjectAndNotWithinAMesh) {
  Scene scene = bright_scene();
  // A roof of two triangles and a floor far below; a step of a mesh in one more.
  scene.triangles = {{Triangle{{-2, -2, 0}, {0, -2, 2}, {0, 2, 2}}, 0},
                     {Triangle{{-2, -2, 0}, {0, 2, 2}, {-2, 2, 0}}, 0},
                     {Triangle{{0, -2, 2}, {2, -2, 0}, {2, 2, 0}}, 0},
                     {Triangle{{0, -2, 2}, {2, 2, 0}, {0, 2, 2}}, 0}};
  const Image roof = rendered(scene, {.outlines = 1}).image;
  for (std::uint32_t y = 0; y < 40; ++y)
    for (std::uint32_t x = 0; x < 40; ++x) EXPECT_EQ(is_black(roof, x, y), x == 19);
  scene.triangles = {{Triangle{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}, 0},
                     {Triangle{{-9, -9, 1}, {0, -9, 1}, {0, 99, 1}}, 0}};
  const Image step = rendered(scene, {.outlines = 1}).image;
  for (std::uint32_t x = 0; x < 40; ++x) EXPECT_EQ(is_black(step, x, 30), x == 19);
}

TEST(Outlines, AreAllThatAPartsPicturesHaveOfTheWhole) {
  Scene scene = bright_scene();
  scene.spheres = {{Sphere{{0, 0, 0}, 1.2}, 0}, {Sphere{{1, 1, 1}, 0.7}, 0}};
  scene.cuts = {{.point = {0.5, 0, 0}, .normal = {1, 0, 0.5}}};
  RenderOptions options{.outlines = 5};
  const Image whole = rendered(scene, options).image;
  EXPECT_GT(std::count(whole.pixels.begin(), whole.pixels.end(), 0.0f), 300);
  options.threads = 1;
  options.isa = Isa::portable;
  for (const PixelRect crop : {PixelRect{8, 9, 20, 13}, PixelRect{0, 0, 3, 40}, {39, 39, 1, 1}}) {
    options.crop = crop;
    const Image part = rendered(scene, options).image;
    for (std::uint32_t y = 0; y < crop.height; ++y)
      EXPECT_TRUE(std::equal(part.row(y), part.row(y) + 3 * crop.width,
                             whole.row(y + crop.y) + 3 * crop.x));
  }
}

TEST(Outlines, AreOpaqueInTransparentPictures) {
  Scene scene = bright_scene();
  scene.spheres = {{Sphere{{0, 0, 0}, 1.2}, 0}};
  const Rendering picture = rendered(scene, {.transparent = true, .outlines = 4});
  std::size_t lines = 0;
  for (std::size_t i = 0; i < 1600; ++i)
    if (picture.image.pixels[3 * i] == 0 && picture.layers.alpha()[i] == 1) ++lines;
  EXPECT_GT(lines, 200u);
}

TEST(Outlines, AreSaidByExplanations) {
  Scene scene = bright_scene();
  scene.camera.kind = CameraKind::pinhole;
  scene.spheres = {{Sphere{{0, 0, 0}, 1.2}, 0}};
  RenderOptions options{.outlines = 3};
  const Image picture = rendered(scene, options).image;
  Explainer explainer = Explainer::create(scene, options).value();
  std::size_t lines = 0;
  for (std::uint32_t x = 0; x < 40; ++x) {
    const Explanation e = explainer.pixel(x, 20).value();
    EXPECT_EQ(e.outlined, is_black(picture, x, 20)) << x;
    const std::string text = to_text(e, {});
    const auto json = nlohmann::json::parse(to_json(e, "s", "p", "w"));
    const bool said = text.find("An outline goes over this pixel") != std::string::npos;
    EXPECT_EQ(said, e.outlined);
    EXPECT_EQ(json.contains("outlined"), e.outlined);
    if (!e.outlined) continue;
    ++lines;
    EXPECT_NE(text.find("(0, 0, 0)\nAn outline"), std::string::npos) << text;
    EXPECT_EQ(json["bytes"], nlohmann::json({0, 0, 0}));
    EXPECT_NE(to_text(e, {.language = Language::croatian}).find("ide obris: na slici je crn"),
              std::string::npos);
  }
  EXPECT_EQ(lines, 6u);
  const Neighbourhood around = explainer.around(20, 8, 15);
  for (std::uint32_t y = 0; y < 15; ++y)
    EXPECT_TRUE(std::equal(around.image.row(y), around.image.row(y) + 45,
                           picture.row(around.top + y) + 3 * around.left));
}

TEST(Outlines, HaveALimit) {
  const Result<Rendering> failed = render(bright_scene(), {.outlines = 65});
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().front().message, "width of outlines 65 is out of range: 0 to 64");
}

TEST(DepthCue, IsFogFromTheNearestToTheFarthestShape) {
  Scene scene = bright_scene(5);
  scene.background = {0.25, 0.5, 0.75};
  scene.planes = {{Plane{{0, -1, 0}, {0, 1, 0}}, 0}};  // without an end
  Scene nothing = scene;
  EXPECT_FALSE(add_depth_cue(nothing));
  EXPECT_EQ(nothing.fog.kind, Fog::Kind::none);
  scene.spheres = {{Sphere{{0, 0, 4}, 1}, 0}, {Sphere{{3, 0, -9}, 2}, 0}};
  ASSERT_TRUE(add_depth_cue(scene));
  EXPECT_EQ(scene.fog.color, scene.background);
  EXPECT_NEAR(scene.fog.start, 5, 1e-12);
  EXPECT_NEAR((scene.fog.end - 21) / (scene.fog.end - scene.fog.start), 0.2, 1e-12);
  scene.camera.eye.z = 4;  // in a shape
  ASSERT_TRUE(add_depth_cue(scene));
  EXPECT_EQ(scene.fog.start, 0);
  scene.camera.eye.z = -20;  // behind all
  scene.camera.window_center.z = -30;
  EXPECT_FALSE(add_depth_cue(scene));
}

TEST(ExplainedCuts, SayWhichCapIsSeen) {
  for (const bool eye_only : {false, true}) {
    Scene scene = bright_scene();
    scene.spheres = {{Sphere{{0, 0, 0}, 1.2}, 0}};
    scene.cuts = {{.point = {9, 0, 0}, .normal = {1, 0, 0}},
                  {.point = {0, 0, 0.5}, .normal = {0, 0, 1}, .eye_only = eye_only}};
    const Explanation cap = explain(scene, {}, 20, 20).value();
    EXPECT_EQ(nlohmann::json::parse(to_json(cap, "s", "p", "w"))["tree"]["hit"]["cap"],
              nlohmann::json({{"cut", 2}, {"eye_only", eye_only}}));
    const std::string english = eye_only
                                    ? "this is the cap of cut 2, which only rays from the eye see"
                                    : "this is the cap of cut 2, not a surface of its own";
    const std::string croatian = eye_only
                                     ? "ovo je presječna ploha reza 2, koji vide samo zrake iz oka"
                                     : "ovo je presječna ploha reza 2, a ne površina tijela";
    EXPECT_NE(to_text(cap, {}).find(english), std::string::npos) << to_text(cap, {});
    EXPECT_NE(to_text(cap, {.language = Language::croatian}).find(croatian), std::string::npos);
    const PagePictures pictures{Image(4, 4), {0, 0, Image(4, 4)}};
    EXPECT_NE(to_page(scene, cap, pictures, {}).value().find(english), std::string::npos);
    const Explanation beside = explain(scene, {}, 20, 8).value();
    EXPECT_FALSE(beside.trees[0].rays[0].hit->cap);
    EXPECT_EQ(to_text(beside, {}).find("cap of cut"), std::string::npos);
  }
}

}  // namespace
}  // namespace zraka
