// SPDX-License-Identifier: Apache-2.0
// What programs embed: a scene that is ready for many pictures, arrays of shapes, and pictures in
// the caller's memory.
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>
#include <vector>
#include <zraka/zraka.hpp>

namespace zraka {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A ball of small spheres on a mirror.
Scene some_spheres() {
  Scene scene;
  scene.resolution = {96, 64};
  scene.lights = {{.position = {2, 4, 3}}};
  scene.materials = {{.diffuse = {0.8, 0.3, 0.1}}, {.diffuse = {0.2, 0.2, 0.3}, .reflection = 0.6}};
  std::vector<float> centers;
  for (int i = 0; i < 500; ++i) {
    const double z = 1 - (i + 0.5) / 250, angle = i * 2.4, r = std::sqrt(1 - z * z);
    for (const double c : {r * std::cos(angle), r * std::sin(angle), z})
      centers.push_back(static_cast<float>(c));
  }
  SphereArrays arrays;
  arrays.centers = {centers.data(), 500};
  arrays.radius = 0.07;
  EXPECT_TRUE(add_spheres(scene, arrays));
  scene.spheres.push_back({{{0, -41.2, 0}, 40}, 1});
  return scene;
}

View around(double degrees, double distance = 4) {
  const double angle = degrees * kPi / 180;
  return *view_at({distance * std::sin(angle), 0.6, distance * std::cos(angle)}, {0, 0, 0},
                  {96, 64});
}

Scene seen(Scene scene, const View& view) {
  scene.camera = view.camera;
  scene.resolution = view.resolution;
  return scene;
}

std::string problem_of(const Result<void>& result) {
  return result ? "" : result.error()[0].message;
}

TEST(Renderer, HasTheBitsOfRenderFromEverySideAndBuildsOnce) {
  const Scene scene = some_spheres();
  const Result<Renderer> renderer = Renderer::create(seen(scene, around(0)));
  ASSERT_TRUE(renderer);
  for (const double degrees : {0.0, 40.0, 135.0, 260.0}) {
    const Result<Rendering> again = renderer->render(around(degrees));
    const Result<Rendering> once = render(seen(scene, around(degrees)));
    ASSERT_TRUE(again && once);
    EXPECT_EQ(sha256(again->image), sha256(once->image)) << degrees;
    EXPECT_EQ(again->stats.build_seconds, 0) << degrees;
    EXPECT_EQ(again->stats.rays.total(), once->stats.rays.total());
  }
}

TEST(Renderer, LooksIntoFogAlongEachView) {
  Scene scene = some_spheres();
  scene.fog = {
      .kind = Fog::Kind::linear, .start = 2, .end = 6, .color = {0.5, 0.6, 0.7}, .planar = true};
  const Result<Renderer> renderer = Renderer::create(seen(scene, around(0)));
  ASSERT_TRUE(renderer);
  const Result<Rendering> again = renderer->render(around(90));
  const Result<Rendering> once = render(seen(scene, around(90)));
  ASSERT_TRUE(again && once);
  EXPECT_EQ(sha256(again->image), sha256(once->image));
  EXPECT_EQ(again->stats.build_seconds, 0);
}

TEST(Renderer, BuildsAnewForViewsThatNeedAnotherFrame) {
  Scene scene = some_spheres();
  scene.triangles.push_back({{{-9, -1.2, -9}, {9, -1.2, -9}, {0, -1.2, 9}}, 0});
  const Result<Renderer> renderer = Renderer::create(seen(scene, around(0)));
  ASSERT_TRUE(renderer);
  const View near = *view_at({0, 0, 1.0701}, {0.001, 0.002, 1}, {48, 48}, 2);
  for (const View& view : {near, around(20, 300), around(0)}) {
    const Result<Rendering> again = renderer->render(view);
    const Result<Rendering> once = render(seen(scene, view));
    ASSERT_TRUE(again && once);
    EXPECT_EQ(sha256(again->image), sha256(once->image));
  }
}

TEST(Renderer, RendersForSeveralThreadsAtOnce) {
  const Result<Renderer> renderer = Renderer::create(seen(some_spheres(), around(0)));
  ASSERT_TRUE(renderer);
  std::vector<std::string> alone, together(6);
  for (int i = 0; i < 6; ++i) alone.push_back(sha256(renderer->render(around(50.0 * i))->image));
  std::vector<std::thread> threads;
  for (int i = 0; i < 6; ++i)
    threads.emplace_back([&, i] {
      RenderOptions options;
      options.threads = i % 3;
      together[static_cast<std::size_t>(i)] =
          sha256(renderer->render(around(50.0 * i), options)->image);
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(alone, together);
}

TEST(Renderer, StaysInTheArenaOfItsCaller) {
  const Result<Renderer> renderer = Renderer::create(seen(some_spheres(), around(0)));
  ASSERT_TRUE(renderer);
  tbb::task_arena arena(1);
  arena.execute([&] { EXPECT_EQ(renderer->render(around(10))->stats.threads, 1); });
}

TEST(Renderer, CanBeCancelledAndRefusesWhatItIsNotReadyFor) {
  const Result<Renderer> renderer = Renderer::create(seen(some_spheres(), around(0)));
  ASSERT_TRUE(renderer);
  const std::atomic<bool> cancel{true};
  RenderOptions options;
  options.cancel = &cancel;
  const auto message = [&](const RenderOptions& wanted, const View& view = around(0)) {
    const Result<Rendering> result = renderer->render(view, wanted);
    return result ? "" : result.error()[0].message;
  };
  EXPECT_EQ(message(options), "the render was cancelled");
  const Result<Renderer> unfinished = Renderer::create(some_spheres(), options);
  ASSERT_FALSE(unfinished);
  EXPECT_EQ(unfinished.error()[0].message, "the render was cancelled");
  options = {};
  options.profile = profile_of(ProfileName::lab);
  EXPECT_EQ(message(options),
            "the renderer was made for another profile, or other shadows or contributions");
  options = {};
  options.isa = Isa::oracle;
  EXPECT_EQ(message(options), "a renderer has no oracle");
  View bad = around(0);
  bad.resolution.width = 0;
  EXPECT_NE(message({}, bad), "");
  bad = around(0);
  bad.camera.eye.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message({}, bad), "");
  EXPECT_EQ(message({}), "");
}

TEST(RenderInto, WritesPixelsOfTheCallersAndNothingElse) {
  const Scene scene = seen(some_spheres(), around(0));
  const Result<Rendering> rendering = render(scene);
  ASSERT_TRUE(rendering);
  const Image& image = rendering->image;

  // Rows from below, gaps between pixels and rows, one byte off any alignment.
  constexpr std::ptrdiff_t kPixel = 19, kRow = 96 * kPixel + 5;
  std::vector<unsigned char> memory(64 * kRow + 1, 0xAB);
  PixelBuffer buffer{.data = memory.data() + 1 + 63 * kRow,
                     .channels = 4,
                     .pixel_stride = kPixel,
                     .row_stride = -kRow};
  ASSERT_TRUE(render_into(buffer, scene));
  for (std::uint32_t y = 0; y < 64; ++y)
    for (std::uint32_t x = 0; x < 96; ++x) {
      const unsigned char* at = memory.data() + 1 + (63 - y) * kRow + x * kPixel;
      float values[4];
      std::memcpy(values, at, sizeof values);
      for (std::uint32_t c = 0; c < 3; ++c) ASSERT_EQ(values[c], image.row(y)[3 * x + c]);
      ASSERT_EQ(values[3], 1);
      ASSERT_EQ(at[16], 0xAB);
      ASSERT_EQ(at[18], 0xAB);
    }
  ASSERT_EQ(memory[0], 0xAB);

  std::vector<unsigned char> bytes(96 * 64 * 3);
  ASSERT_TRUE(render_into({.data = bytes.data(), .type = PixelBuffer::Type::uint8}, scene));
  for (std::size_t i = 0; i < bytes.size(); ++i)
    ASSERT_EQ(bytes[i], quantize(image.pixels[i], Transfer::srgb, 8));
}

TEST(RenderInto, TellsOfEveryPixelOnce) {
  const Result<Renderer> renderer = Renderer::create(seen(some_spheres(), around(0)));
  ASSERT_TRUE(renderer);
  for (const auto kind : {Sampling::Kind::sobol, Sampling::Kind::adaptive})
    for (const bool transparent : {false, true}) {
      RenderOptions options;
      options.sampling.kind = kind;
      options.sampling.count = 2;
      options.sampling.most = 4;
      options.transparent = transparent;
      options.crop = PixelRect{10, 20, 50, 40};
      std::vector<float> pixels(50 * 40 * 4, -1);
      std::vector<std::atomic<int>> told(50 * 40);
      const auto tile_done = [&](const PixelRect& part) {
        for (std::uint32_t y = part.y; y < part.y + part.height; ++y)
          for (std::uint32_t x = part.x; x < part.x + part.width; ++x) ++told[y * 50 + x];
      };
      ASSERT_TRUE(renderer->render_into({.data = pixels.data(), .channels = 4}, around(30), options,
                                        tile_done));
      for (const std::atomic<int>& times : told) ASSERT_EQ(times, 1);
      const Result<Rendering> rendering = renderer->render(around(30), options);
      for (std::size_t i = 0; i < 50 * 40; ++i) {
        ASSERT_EQ(pixels[4 * i], rendering->image.pixels[3 * i]);
        ASSERT_EQ(pixels[4 * i + 3], transparent ? rendering->layers.alpha()[i] : 1.0f);
      }
    }
}

TEST(RenderInto, RefusesBuffersThatCannotBe) {
  const Scene scene = seen(some_spheres(), around(0));
  std::vector<float> pixels(96 * 64 * 4);
  const auto message = [&](PixelBuffer buffer) {
    const auto result = render_into(buffer, scene);
    return result ? "" : result.error()[0].message;
  };
  EXPECT_EQ(message({}), "the buffer has no memory");
  EXPECT_EQ(message({.data = pixels.data(), .channels = 2}),
            "2 channels: expected 3 (RGB) or 4 (RGBA)");
  EXPECT_EQ(message({.data = pixels.data(), .pixel_stride = 8}),
            "a pixel stride of 8 bytes: a pixel has 12");
  EXPECT_EQ(message({.data = pixels.data(), .row_stride = 100}),
            "a row stride of 100 bytes: a row has 1152");
}

TEST(Bulk, ReadsArraysOfAnyStride) {
  Scene scene;
  scene.materials = {{}};
  // x, y, z and the radius side by side; and each of them apart.
  const double together[] = {1, 2, 3, 0.5, 4, 5, 6, 0.25};
  const float apart[] = {1, 4, 2, 5, 3, 6};
  SphereArrays arrays;
  arrays.centers = {together, 2, 32};
  arrays.radii = {together + 3, 2, 32};
  ASSERT_TRUE(add_spheres(scene, arrays));
  arrays.centers = {apart, 2, 4, 8};
  ASSERT_TRUE(add_spheres(scene, arrays));
  ASSERT_EQ(scene.spheres.size(), 4u);
  for (const std::size_t i : {1u, 3u}) {
    EXPECT_EQ(scene.spheres[i].shape.center, (Vec3{4, 5, 6}));
    EXPECT_EQ(scene.spheres[i].shape.radius, 0.25);
  }
}

TEST(Bulk, MakesAMaterialOfEachColorThatDiffers) {
  Scene scene;
  scene.materials = {{}, {.ambient = {1, 1, 1}, .diffuse = {0.5, 0.5, 0.5}, .reflection = 0.25}};
  const float points[] = {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3};
  const float colors[] = {1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0};
  CylinderArrays arrays;
  arrays.starts = {points, 3};
  arrays.ends = {points + 3, 3};
  arrays.radius = 0.1;
  arrays.material = 1;
  arrays.colors = {colors, 3};
  ASSERT_TRUE(add_cylinders(scene, arrays));
  ASSERT_EQ(scene.materials.size(), 4u);
  EXPECT_EQ(scene.cones[0].material, scene.cones[2].material);
  const Material& green = scene.materials[scene.cones[1].material];
  EXPECT_EQ(green.ambient, (Color{0, 1, 0}));
  EXPECT_EQ(green.diffuse, (Color{0, 0.5, 0}));
  EXPECT_EQ(green.reflection, Share(0.25));
}

TEST(Bulk, NamesTheArrayAndTheIndexOfWhatIsWrong) {
  Scene scene;
  scene.materials = {{}};
  double points[] = {0, 0, 0, 1, 1, 1};
  const double radii[] = {1, -1};
  SphereArrays spheres;
  spheres.centers = {points, 2};
  spheres.radii = {radii, 2};
  EXPECT_EQ(problem_of(add_spheres(scene, spheres)),
            "radii[1] is -1: expected a finite number greater than 0");
  spheres.radii = {radii, 1};
  EXPECT_EQ(problem_of(add_spheres(scene, spheres)),
            "radii has 1 items: expected 2, one for each shape");
  spheres.radii = {};
  spheres.material = 3;
  EXPECT_EQ(problem_of(add_spheres(scene, spheres)),
            "material is 3: the scene has 1 materials, counted from 0");
  spheres.material = 0;
  points[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(problem_of(add_spheres(scene, spheres)),
            "centers[1, 1] is nan: expected a finite number");
  points[4] = 1;
  CylinderArrays cylinders;
  cylinders.starts = cylinders.ends = {points, 2};
  EXPECT_EQ(problem_of(add_cylinders(scene, cylinders)),
            "ends[0] is where starts[0] is: a cylinder has a length");
  TriangleArrays triangles;
  triangles.a = triangles.b = {points, 2};
  triangles.c = {points, 1};
  EXPECT_EQ(problem_of(add_triangles(scene, triangles)),
            "c has 1 items: expected 2, one for each shape");
  EXPECT_EQ(scene.shape_count(), 0u);
  EXPECT_EQ(scene.materials.size(), 1u);
}

TEST(View, FailsWhereItLooksNowhere) {
  EXPECT_FALSE(view_at({0, 0, 0}, {0, 0, 0}, {10, 10}));
  EXPECT_FALSE(view_at({0, 5, 0}, {0, 0, 0}, {10, 10}));
  EXPECT_FALSE(view_at({0, 0, 5}, {0, 0, 0}, {10, 10}, 180));
  EXPECT_FALSE(view_at({0, 0, 5}, {0, 0, 0}, {0, 10}));
}

}  // namespace
}  // namespace zraka
