// SPDX-License-Identifier: Apache-2.0
// Instances against the same shapes written out, and what they take of memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <zraka/zraka.hpp>

#include "render/isa.hpp"
#include "render/prepare.hpp"

namespace zraka {
namespace {

Scene empty_scene() {
  Scene scene;
  scene.resolution = {96, 72};
  scene.camera.eye = {0, 1, 9};
  scene.camera.window_center = {0, 0, 0};
  scene.camera.window_right = {8, 0, 0};
  scene.camera.window_up = {0, 6, 0};
  scene.background = {0.1, 0.2, 0.3};
  scene.lights = {{{4, 6, 8}, {1, 1, 1}}};
  Material red, mirror;
  red.diffuse = {0.8, 0.2, 0.1};
  mirror.reflection = 0.7;
  scene.materials = {red, mirror};
  return scene;
}

/// A turn about z by a quarter, larger by a factor, and a move.
Transform quarter(double scale, const Vec3& to) {
  return {{0, scale, 0}, {-scale, 0, 0}, {0, 0, scale}, to};
}
Vec3 by(const Transform& t, const Vec3& p) {
  return {t.along_x.x * p.x + t.along_y.x * p.y + t.along_z.x * p.z + t.origin.x,
          t.along_x.y * p.x + t.along_y.y * p.y + t.along_z.y * p.z + t.origin.y,
          t.along_x.z * p.x + t.along_y.z * p.y + t.along_z.z * p.z + t.origin.z};
}

std::size_t pixels_that_differ(const Scene& a, const Scene& b) {
  const Result<Rendering> one = render(a, {}), two = render(b, {});
  EXPECT_TRUE(one && two);
  if (!one || !two) return ~std::size_t{0};
  std::size_t differ = 0;
  for (std::size_t i = 0; i < one->image.pixels.size(); i += 3) {
    float most = 0;
    for (std::size_t k = 0; k < 3; ++k)
      most = std::max(most, std::fabs(one->image.pixels[i + k] - two->image.pixels[i + k]));
    differ += most > 2e-3f ? 1 : 0;
  }
  return differ;
}

std::vector<Sphere> crowd(int count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-1, 1), size(0.05, 0.25);
  std::vector<Sphere> spheres;
  for (int i = 0; i < count; ++i) {
    const double x = place(random), y = place(random), z = place(random);
    spheres.push_back({{x, y, z}, size(random)});
  }
  return spheres;
}

TEST(Instances, LookLikeTheirShapesWrittenOut) {
  // With the shapes few enough for a list, and too many.
  for (const int count : {3, 60}) {
    Scene written = empty_scene(), instanced = empty_scene();
    Group inner, outer;
    const std::vector<Sphere> spheres = crowd(count);
    // The first without a material of its own: it has the instance's.
    for (const Sphere& s : spheres)
      inner.spheres.push_back({s, inner.spheres.empty() ? kMaterialOfWhole : 1});
    const Transform first = quarter(0.6, {0.3, 0.2, 0}), left = quarter(1.5, {-1.5, 0, 0}),
                    right = quarter(1, {1.8, 0.4, -1});
    instanced.transforms = {first, left, right};
    outer.instances.push_back({{0}, kMaterialOfWhole, 1});
    outer.instances.push_back({{0}, 1, 0});
    instanced.groups = {inner, outer};
    instanced.instances.push_back({{1}, 0, 2});
    instanced.instances.push_back({{1}, 1, 3});
    for (const auto& [place, scale, material] :
         {std::tuple{left, 1.5, 0u}, std::tuple{right, 1.0, 1u}})
      for (std::size_t i = 0; i < spheres.size(); ++i) {
        const Sphere& s = spheres[i];
        written.spheres.push_back(
            {{by(place, by(first, s.center)), s.radius * 0.6 * scale}, i == 0 ? material : 1u});
        written.spheres.push_back({{by(place, s.center), s.radius * scale}, 1});
      }
    EXPECT_LE(pixels_that_differ(written, instanced), 96u * 72 / 500) << count << " spheres";
  }
}

TEST(Instances, HoldPlanesAndNothingAtAll) {
  Scene written = empty_scene(), instanced = empty_scene();
  written.planes.push_back({{{0, -1, 0}, {0, 1, 0}}, 0});
  written.spheres.push_back({{{0, 0, 0}, 1}, 1});
  Group floor, nothing;
  floor.planes.push_back({{{0, 0, 0}, {0, 1, 0}}, 0});
  instanced.transforms = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}}};
  instanced.groups = {floor, nothing};
  instanced.instances.push_back({{0}, 0, 1});
  instanced.instances.push_back({{1}, 0, 1});
  instanced.spheres = written.spheres;
  EXPECT_LE(pixels_that_differ(written, instanced), 96u * 72 / 500);
}

/// Of equal hits the first in the file counts, in whatever order groups are gone through.
TEST(Instances, ThatCoincideLookTheSameToAllTilesAndInstructionSets) {
  Scene scene = empty_scene();
  scene.camera.eye = {1, 7, 6};
  Material green;
  green.diffuse = {0.1, 0.8, 0.1};
  scene.materials.push_back(green);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-3, 3), size(0.2, 1.4);
  for (int g = 0; g < 2; ++g) {
    Group boxes;
    for (int i = 0; i < 20; ++i) {
      const double x = place(random) / 6, z = place(random) / 6, w = size(random) / 4;
      boxes.boxes.push_back({{{x, -1, z}, {x + w, 0, z + w}, 0}, kMaterialOfWhole});
    }
    scene.groups.push_back(boxes);
  }
  for (int i = 0; i < 200; ++i) {
    scene.transforms.push_back({{size(random), 0, 0},
                                {0, size(random), 0},
                                {0, 0, size(random)},
                                {place(random), 0, place(random)}});
    scene.instances.push_back({{static_cast<std::uint32_t>(random() % 2)},
                               static_cast<std::uint32_t>(random() % 3),
                               static_cast<std::uint32_t>(i + 1)});
  }
  std::string first;
  for (const Isa isa : available_isas())
    for (const int tile : {0, 9}) {
      RenderOptions options;
      options.isa = isa;
      options.tile = tile;
      options.threads = 2;
      const Result<Rendering> rendering = render(scene, options);
      ASSERT_TRUE(rendering);
      if (first.empty()) first = sha256(rendering->image);
      EXPECT_EQ(sha256(rendering->image), first) << name_of(isa) << ", tile " << tile;
    }
}

TEST(Instances, OfInstancesOfInstancesAreFramedAtOnce) {
  Scene scene = empty_scene();
  scene.transforms.push_back({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.001, 0, 0}});
  Group box;
  box.boxes.push_back({{{-50, -50, -50}, {50, 50, 50}, 0}, kMaterialOfWhole});
  scene.groups.push_back(box);
  for (std::uint32_t level = 0; level < 24; ++level) {
    Group next;
    for (int i = 0; i < 8; ++i) next.instances.push_back({{level}, kMaterialOfWhole, 1});
    scene.groups.push_back(next);
  }
  scene.instances.push_back({{24}, 0, 0});
  // 8^24 boxes, seen from within.
  EXPECT_TRUE(check(scene).empty());
}

TEST(Instances, OfOneMeshCostItsMemoryOnce) {
  Scene scene = empty_scene();
  Group mesh;
  constexpr int kSide = 70;  // 9800 triangles
  const auto corner = [](int x, int z) {
    return Vec3{x / 35.0 - 1, 0.1 * std::sin(0.3 * x) * std::cos(0.2 * z), z / 35.0 - 1};
  };
  for (int z = 0; z < kSide; ++z)
    for (int x = 0; x < kSide; ++x) {
      mesh.triangles.push_back({{corner(x, z), corner(x + 1, z), corner(x, z + 1)}, 0});
      mesh.triangles.push_back({{corner(x + 1, z), corner(x + 1, z + 1), corner(x, z + 1)}, 0});
    }
  scene.groups = {mesh};
  const auto bytes_of = [&](int instances) {
    scene.instances.clear();
    scene.transforms.clear();
    for (int i = 0; i < instances; ++i) {
      scene.transforms.push_back({{0.02, 0, 0},
                                  {0, 0.02, 0},
                                  {0, 0, 0.02},
                                  {(i % 100) * 0.05 - 2.5, (i / 100) * 0.05 - 2.5, 0}});
      scene.instances.push_back({{0}, 0, static_cast<std::uint32_t>(i + 1)});
    }
    return prepare<float>(scene, RenderOptions{}).store->bytes();
  };
  const std::uint64_t one = bytes_of(1), many = bytes_of(10000);
  EXPECT_GT(one, 9800u * 9 * sizeof(float));
  // Each instance: its numbers and a few words.
  EXPECT_LT(many - one, 10000u * 256);
}

TEST(Textures, MoveWithMembersOfCsgAsWithShapes) {
  const auto scene_of = [](bool member) {
    Scene scene = empty_scene();
    Texture checker;
    checker.size = 0.5;
    scene.textures = {checker};
    scene.materials[0].textures = {{Coefficient::diffuse, 0}};
    scene.transforms = {quarter(0.9, {0.3, 0.2, 0.1})};
    const Box box{{-1.01, -1.02, -1.03}, {1, 1, 1}, 0};
    if (member) {
      Csg csg;
      csg.of = {{box, kMaterialOfWhole, 1, {}},
                {Ellipsoid{{0, 9, 0}, {1, 1, 1}}, kMaterialOfWhole, 0, {}}};
      scene.csgs.push_back({csg, 0});
    } else {
      scene.boxes.push_back({box, 0, 1});
    }
    return scene;
  };
  EXPECT_LE(pixels_that_differ(scene_of(true), scene_of(false)), 3u);
}

TEST(Planes, AloneOrByTheDozenAreSeen) {
  for (const int count : {1, 3, 20}) {
    Scene scene = empty_scene();
    for (int i = 0; i < count; ++i) scene.planes.push_back({{{0, -1.0 - i, 0}, {0, 1, 0}}, 0});
    const Result<Rendering> rendering = render(scene, {});
    ASSERT_TRUE(rendering) << rendering.error().front().message;
    const float* const below = rendering->image.row(71);
    EXPECT_NE(below[0], static_cast<float>(scene.background.r)) << count;
    EXPECT_EQ(rendering->image.row(0)[0], static_cast<float>(scene.background.r)) << count;
  }
}

}  // namespace
}  // namespace zraka
