// SPDX-License-Identifier: Apache-2.0
// What is wrong with scenes that programs put together: how their parts refer to each other.
#include "scene/check_bodies.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <zraka/zraka.hpp>

#include "scene/csg_size.hpp"

namespace zraka {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::string problems(const Scene& scene) {
  std::string all;
  const bool good = check_references(scene, [&](std::string message, const std::string& hint) {
    all += message + (hint.empty() ? "" : " (" + hint + ")") + "\n";
  });
  EXPECT_EQ(good, all.empty());
  return all;
}

Scene plain_scene() {
  Scene scene;
  scene.materials.push_back({});
  scene.transforms.push_back({});
  scene.groups.resize(2);
  scene.textures.push_back({});
  return scene;
}

TEST(CheckBodies, HasNothingAgainstWhatIsRight) {
  Scene scene = plain_scene();
  EXPECT_EQ(problems(scene), "");
  scene.spheres.push_back({{{0, 0, 0}, 1}, 0, 1});
  scene.instances.push_back({{1}, 0, 1});
  scene.groups[0].spheres.push_back({{{0, 0, 0}, 1}, kMaterialOfWhole, 1});
  scene.groups[1].instances.push_back({{0}, kMaterialOfWhole, 0});
  scene.csgs.push_back({{CsgOperation::subtract, {{Ellipsoid{}}, {Plane{}, 0, 1, "cut"}}}, 0, 1});
  scene.materials[0].textures = {{Coefficient::diffuse, 0}};
  scene.materials[0].normals = {NormalUse::Kind::bump, 0};
  scene.triangles.push_back({});
  scene.triangle_uvs.push_back({});
  EXPECT_EQ(problems(scene), "");
}

TEST(CheckBodies, FindsTransformsThatAreNone) {
  Scene scene = plain_scene();
  scene.transforms.push_back({{1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {}});
  scene.transforms.push_back({{1, 0, 0}, {0, 1, 0}, {0, 0, kNaN}, {}});
  scene.boxes.push_back({{}, 0, 4});
  scene.planes.push_back({{}, 0, 3});
  EXPECT_EQ(problems(scene),
            "transform 2: it makes all that it moves flat\n"
            "transform 3: it is not finite\n"
            "box 1: it has transform 4, but there are 3\n");
}

TEST(CheckBodies, IsPartOfTheWholeCheck) {
  Scene scene = plain_scene();
  scene.planes.push_back({{{}, {0, 0, 0}}, 0, 0});
  scene.spheres.push_back({{{0, 0, 0}, 1}, 0, 4});
  std::string all;
  for (const Diagnostic& d : check(scene)) all += d.message + "\n";
  EXPECT_EQ(all,
            "sphere 1: it has transform 4, but there are 1\n"
            "plane 1: its normal is 0\n");
  scene.transforms.push_back({{}, {}, {}, {}});
  all = to_string(check(scene).front());
  EXPECT_EQ(all, "error: transform 2: it makes all that it moves flat\n");
}

TEST(CheckBodies, FindsGroupsThatAreNotThereOrInThemselves) {
  Scene scene = plain_scene();
  scene.instances.push_back({{2}, 0, 0});
  EXPECT_EQ(problems(scene), "instance 1: it is of group 2, but there are 2\n");
  scene.instances[0].shape.group = 1;
  scene.groups[0].instances.push_back({{1}, kMaterialOfWhole, 0});
  EXPECT_EQ(problems(scene), "");
  scene.groups[1].instances.push_back({{0}, kMaterialOfWhole, 0});
  EXPECT_EQ(problems(scene), "group 1 has itself in it\n");
  scene.groups.clear();
  scene.groups.resize(33);
  scene.instances.clear();
  for (std::uint32_t i = 0; i + 2 < 33; ++i)
    scene.groups[i].instances.push_back({{i + 1}, kMaterialOfWhole, 0});
  EXPECT_EQ(problems(scene), "");
  scene.groups[31].instances.push_back({{32}, kMaterialOfWhole, 0});
  EXPECT_EQ(problems(scene), "group 1 has groups in it 33 deep: at most 32 fit\n");
}

TEST(CheckBodies, FindsWrongShapesInGroups) {
  Scene scene = plain_scene();
  scene.groups[1].spheres = {{{{0, 0, 0}, 0}, kMaterialOfWhole}, {{{0, 0, 0}, 1}, 1}};
  scene.groups[1].planes.push_back({{{1e101, 0, 0}, {0, 1, 0}}, 0, 1});
  scene.groups[1].triangles.resize(2);
  scene.groups[1].triangle_uvs.resize(1);
  scene.groups[1].triangle_uvs[0][1][0] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(problems(scene),
            "sphere 1 of group 2: its radius is not a finite number above 0\n"
            "sphere 2 of group 2: it has material 1, but there are 1\n"
            "plane 1 of group 2: it reaches farther than 1e+100 from the origin\n"
            "2 triangles of group 2 have texture coordinates for 1 (expected none, or as many)\n"
            "texture coordinates of triangles 1 of group 2 are not finite\n");
}

TEST(CheckBodies, FindsMembersOfCsgThatAreNoClosedBodies) {
  const auto with = [](CsgMember member) {
    Scene scene = plain_scene();
    scene.csgs.push_back({{CsgOperation::unite, {{Ellipsoid{}}, std::move(member)}}, 0, 0});
    return problems(scene);
  };
  EXPECT_EQ(with({Instance{0}}), "csg 1: member 2: instance is no closed body\n");
  EXPECT_EQ(with({}), "csg 1: member 2: it is nothing\n");
  EXPECT_EQ(with({Ellipsoid{{}, {1, 0, 1}}}),
            "csg 1: member 2: ellipsoid: its radii are not finite numbers above 0\n");
  EXPECT_EQ(with({Plane{}, 7}), "csg 1: member 2: it has material 7, but there are 1\n");
  EXPECT_EQ(with({Plane{}, 0, 2}), "csg 1: member 2: it has transform 2, but there are 1\n");
  EXPECT_EQ(with({Frustum{{}, 1, {0, 1, 0}, 1, false}}),
            "csg 1: member 2: frustum: without caps it has no inside\n");
  EXPECT_EQ(with({Quadric{}}), "");
  EXPECT_EQ(with({Quadric{.max = {0.5, 1, 1}}}),
            "csg 1: member 2: quadric: its box cuts its surface off, so it has no inside\n");
  EXPECT_EQ(with({Csg{}}), "csg 1: member 2: it has no members\n");
  EXPECT_EQ(with({Csg{CsgOperation::unite, {{Instance{}}}}}),
            "csg 1: member 2: member 1: instance is no closed body\n");
}

TEST(CheckBodies, CountsWhatCsgNeedsRoomFor) {
  Csg pair{CsgOperation::unite, {{Ellipsoid{}}, {Plane{}}}};
  EXPECT_EQ(size_of(pair).crossings, 4);
  EXPECT_EQ(size_of(pair).waiting, 2);
  const Csg last{CsgOperation::unite, {{Ellipsoid{}}, {pair}}},
      first{CsgOperation::unite, {{pair}, {Ellipsoid{}}}};
  EXPECT_EQ(size_of(last).waiting, 3);
  EXPECT_EQ(size_of(first).waiting, 2);
  EXPECT_EQ(size_of(first).depth, 2);
  Scene scene = plain_scene();
  scene.csgs.push_back({{CsgOperation::unite, std::vector<CsgMember>(65, {Plane{}})}, 0, 0});
  EXPECT_EQ(problems(scene), "csg 1: 65 of its members wait for each other: at most 64 fit\n");
  Csg deep = pair;
  for (int i = 0; i < 64; ++i) deep = {CsgOperation::unite, {{deep}}};
  scene.csgs[0].shape = deep;
  EXPECT_NE(problems(scene).find("CSG shapes are 65 deep in each other: at most 64 fit"),
            std::string::npos);
}

TEST(CheckBodies, FindsTexturesThatAreNone) {
  Scene scene = plain_scene();
  scene.materials[0].textures = {{Coefficient::diffuse, 3}, {Coefficient::diffuse, 0}};
  scene.materials[0].normals = {NormalUse::Kind::bump, 4, kNaN};
  Texture& texture = scene.textures[0];
  texture.kind = TextureKind::noise;
  texture.transform = {{}, {}, {}, {}};
  texture.colors.resize(1);
  texture.size = 0;
  texture.direction = {};
  texture.turbulence = -1;
  texture.octaves = 0;
  scene.textures.emplace_back().kind = TextureKind::image;
  EXPECT_EQ(problems(scene),
            "texture 1: its transform: it makes all that it moves flat\n"
            "texture 1: it has fewer than two colours\n"
            "texture 1: its size is no finite number above 0\n"
            "texture 1: its direction is 0, or not finite\n"
            "texture 1: its turbulence is no finite number of 0 or more\n"
            "texture 1: its octaves are none from 1 to 32\n"
            "texture 2: it has no picture\n"
            "material 1 has texture 3, but there are 2\n"
            "material 1 has two textures for one coefficient\n"
            "material 1 has texture 4, but there are 2\n"
            "material 1: how high its bumps are is not finite\n");
}

}  // namespace
}  // namespace zraka
