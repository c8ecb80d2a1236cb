// SPDX-License-Identifier: Apache-2.0
// What particles look like: bonds, radii, colours; and the scenes that are made of them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "language_helpers.hpp"
#include "particles/bonds.hpp"
#include "particles/look.hpp"
#include "test_folder.hpp"

namespace zraka {
namespace {

using Pairs = std::vector<std::array<std::uint32_t, 2>>;

TEST(Bonds, AreThoseOfEveryPairThatIsNearEnough) {
  std::mt19937 random(1);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<Object<Sphere>> atoms;
  for (int i = 0; i < 2000; ++i)
    atoms.push_back({{{-1e6 + 20 * number(), 20 * number(), 20 * number()}, 1},
                     static_cast<std::uint32_t>(random() % 3)});
  const std::vector<float> covalent = {0.3f, 0.76f, 0};
  Pairs expected;
  for (std::uint32_t i = 0; i < atoms.size(); ++i)
    for (std::uint32_t j = i + 1; j < atoms.size(); ++j) {
      const float a = covalent[atoms[i].material], b = covalent[atoms[j].material];
      const Vec3 &p = atoms[i].shape.center, &q = atoms[j].shape.center;
      const double distance = std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
      if (a > 0 && b > 0 && distance >= 0.4 && distance <= static_cast<double>(a) + b + 0.45)
        expected.push_back({i, j});
    }
  EXPECT_GT(expected.size(), 500u);
  EXPECT_EQ(find_bonds(atoms, covalent), expected);
}

TEST(Bonds, AreNotSoughtAmongAtomsInOnePlace) {
  const std::vector<Object<Sphere>> atoms(100000, {{{0, 0, 0}, 1}, 0});
  EXPECT_EQ(find_bonds(atoms, {0.76f}), std::nullopt);
}

TEST(ColorMaps, BeginAndEndAsPublished) {
  EXPECT_EQ(color_at(ColorMap::viridis, 0), 0x440154u);
  EXPECT_EQ(color_at(ColorMap::viridis, 1), 0xFDE725u);
  EXPECT_EQ(color_at(ColorMap::coolwarm, 0.5), 0xDDDDDDu);
  EXPECT_EQ(color_at(ColorMap::grey, 0.5), 0x808080u);
  EXPECT_EQ(color_at(ColorMap::grey, -1), 0x000000u);
}

/// Particles of a file of XYZ as a scene with the look.
Scene drawn(const std::string& text, const ParticleStyle& style, const std::string& column = "") {
  Scene scene;
  Result<Particles> particles = parse_particles(text, "p", {.column = column});
  EXPECT_TRUE(particles);
  const auto notes =
      add_particles(std::move(*particles), style, particle_material(), 0, "p", scene, scene);
  EXPECT_TRUE(notes) << to_string(notes.error().front());
  return scene;
}

const std::string kHydroxide = "2\n\nO 0 0 0\nH 1 0 0\n";

TEST(Looks, HaveRadiiAndBonds) {
  const Scene full = drawn(kHydroxide, {.scale = 2});
  ASSERT_EQ(full.spheres.size(), 2u);
  EXPECT_NEAR(full.spheres[0].shape.radius, 2 * 1.52, 1e-6);
  EXPECT_NEAR(full.spheres[1].shape.radius, 2 * 1.2, 1e-6);
  EXPECT_TRUE(full.cones.empty());
  EXPECT_EQ(full.materials[full.spheres[0].material].diffuse, linear_color(0xFF0D0D));

  const Scene balls = drawn(kHydroxide, {.look = ParticleLook::ball_and_stick});
  EXPECT_NEAR(balls.spheres[0].shape.radius, 0.38, 1e-6);
  ASSERT_EQ(balls.cones.size(), 2u) << "half of it in each colour";
  EXPECT_EQ(balls.cones[0].shape.apex, (Vec3{0.5, 0, 0}));
  EXPECT_EQ(balls.cones[1].material, balls.spheres[1].material);

  const Scene sticks = drawn(kHydroxide, {.look = ParticleLook::sticks, .radius = 0.3});
  EXPECT_EQ(sticks.spheres[0].shape.radius, 0.3);
  EXPECT_EQ(sticks.cones[0].shape.base_radius, 0.3);
  EXPECT_EQ(
      drawn(kHydroxide, {.look = ParticleLook::points, .radius = 0.1}).spheres[1].shape.radius,
      0.1);
  // Eight on a grid whose corners are the box: two along each side of 1.
  EXPECT_EQ(drawn("x y z\n0 0 0\n1 1 1\n0 1 1\n1 0 1\n1 1 0\n0 0 1\n0 1 0\n1 0 0\n", {})
                .spheres[0]
                .shape.radius,
            0.25);
}

TEST(Looks, ColorByColumns) {
  const std::string text = "x,y,z,e\n0,0,0,5\n1,0,0,15\n2,0,0,25\n";
  const Scene scene = drawn(text, {.color_by = "e", .color_map = ColorMap::grey}, "e");
  EXPECT_EQ(scene.materials.size(), 256u);
  EXPECT_EQ(scene.materials[scene.spheres[0].material].diffuse, linear_color(0));
  EXPECT_EQ(scene.materials[scene.spheres[1].material].diffuse, linear_color(0x808080));
  const Scene ranged =
      drawn(text, {.color_by = "e", .color_map = ColorMap::grey, .range = {{0, 10}}}, "e");
  EXPECT_EQ(ranged.spheres[2].material, 255u);
}

TEST(Looks, KeepTheColorsOfTheFileAndRoundMany) {
  const Scene few = drawn("x,y,z,r,g,b\n0,0,0,0,0,0\n1,0,0,1,0.5,0\n2,0,0,1,0.5,0\n", {});
  EXPECT_EQ(few.materials.size(), 2u);
  EXPECT_EQ(few.materials[few.spheres[2].material].diffuse, linear_color(0xFF8000));
  std::string many = "x,y,z,r,g,b\n";
  for (int i = 0; i < 70000; ++i)
    many += fmt::format("{},0,0,{},{},{}\n", i, i % 256, i / 256 % 256, i / 65536);
  const Scene rounded = drawn(many, {});
  EXPECT_LE(rounded.materials.size(), 65536u);
  EXPECT_NEAR(rounded.materials[rounded.spheres[255].material].diffuse.r, 1, 1e-6);
  // Half of a step of 5 bits, as a share of the sRGB curve's steepest rise.
  for (std::size_t i = 0; i < 70000; i += 777)
    EXPECT_NEAR(rounded.materials[rounded.spheres[i].material].diffuse.r,
                linear_color(static_cast<std::uint32_t>(i % 256) << 16).r, 0.05);
}

TEST(ParticleScenes, ShowAllOfTheFile) {
  Result<ReadScene> read = parse_scene("4\n\nC 0 0 0\nC 30 0 0\nC 0 20 0\nC 7 7 5\n", "p.xyz");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->scene.format, "particles");
  ASSERT_EQ(read->warnings.size(), 1u);
  EXPECT_EQ(to_string(read->warnings[0]),
            "p.xyz: note: 4 particles; light, camera and colours are chosen here\n"
            "  a scene with a shape of kind 'particles' chooses otherwise: zraka help particles\n");
  const Camera& camera = read->scene.camera;
  // Each sphere's centre, seen from the eye, is within the window.
  const auto dot = [](const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
  const auto minus = [](const Vec3& a, const Vec3& b) {
    return Vec3{a.x - b.x, a.y - b.y, a.z - b.z};
  };
  const Vec3 view = minus(camera.window_center, camera.eye);
  double widest = 0;
  for (const auto& sphere : read->scene.spheres) {
    const Vec3 way = minus(sphere.shape.center, camera.eye);
    const double depth = dot(way, view) / dot(view, view);
    const double right =
        dot(way, camera.window_right) / dot(camera.window_right, camera.window_right) / depth;
    const double up = dot(way, camera.window_up) / dot(camera.window_up, camera.window_up) / depth;
    EXPECT_LT(std::fabs(right), 0.5);
    EXPECT_LT(std::fabs(up), 0.5);
    widest = std::max({widest, std::fabs(right), std::fabs(up)});
  }
  EXPECT_GT(widest, 0.35) << "and they fill it";
}

TEST(ParticleScenes, AreColoredByAColumnThatALegendExplains) {
  const std::string csv = "x,y,z,heat\n0,0,0,-2\n1,0,0,1\n0,1,0,6\n";
  const Result<ReadScene> read =
      parse_scene(csv, "p.csv", {.color_by = "heat", .color_map = "grey"});
  ASSERT_TRUE(read);
  ASSERT_EQ(read->legends.size(), 1u);
  const ColorLegend& legend = read->legends[0];
  EXPECT_EQ(legend.title, "heat");
  EXPECT_EQ(legend.low, -2);
  EXPECT_EQ(legend.high, 6);
  ASSERT_EQ(legend.colors.size(), 256u);
  EXPECT_EQ(legend.colors[255], 0xFFFFFFu);
  EXPECT_EQ(read->scene.materials[read->scene.spheres[2].material].diffuse, linear_color(0xFFFFFF));
  const auto problem = [&](const ReadOptions& options) {
    const Result<ReadScene> failed = parse_scene(csv, "p.csv", options);
    return failed ? std::string() : to_string(failed.error().front());
  };
  EXPECT_EQ(problem({.color_by = "heat", .color_map = "rainbow"}),
            "p.csv: error: no map of colours is called 'rainbow'\n"
            "  known are viridis, plasma, inferno, magma, coolwarm, grey\n");
  EXPECT_NE(problem({.color_by = "cold"}).find("'cold'"), std::string::npos);
  EXPECT_TRUE(parse_scene(csv, "p.csv")->legends.empty());
}

/// A folder with files of particles in it.
const std::string& folder() {
  static TestFolder made("particles");
  static const std::string& path =
      made.with("a.xyz",
                "2\nLattice=\"2 0 0 0 2 0 0 0 2\" Properties=species:S:1:pos:R:3:e:R:1\n"
                "O 0 0 0 1\nH 1 0 0 2\n")
          .with("bad.xyz", "2\n\nO 0 0 0\nH 1 x 0\n")
          .path();
  return path;
}
const ReadOptions kHere{.folder = folder()};

std::string shape_of(const std::string& rest) {
  return "[[shape]]\nkind = \"particles\"\nfile = \"a.xyz\"\n" + rest;
}

/// What is read is written, with names for the materials, and reads as the equal scene.
void expect_equal_again(const std::string& text) {
  const Scene scene = scene_of(text, kHere);
  expect_equal(scene, scene_of(write_toml(scene).value()));
}

TEST(ParticlesOfScenes, AreSpheresAndCones) {
  const Scene scene =
      scene_of(shape_of("look = \"ball_and_stick\"\ncolor_by = \"e\"\ncell = true\n"), kHere);
  EXPECT_EQ(scene.spheres.size(), 2u + 8u);
  EXPECT_EQ(scene.cones.size(), 2u + 12u);
  EXPECT_EQ(scene.materials.size(), 256u + 1u + 1u);
  expect_equal_again(shape_of("look = \"sticks\"\n"));
  const Result<ReadScene> read =
      parse_scene(shape_of("color_by = \"e\"\nrange = [0, 4]\n"), "s.toml", kHere);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->legends.size(), 1u);
  EXPECT_EQ(read->legends[0].title, "e");
  EXPECT_EQ(read->legends[0].high, 4);
}

TEST(ParticlesOfScenes, HaveSolidBondsForCaps) {
  const Scene scene = scene_of(shape_of("look = \"sticks\"\nsolid = true\n"), kHere);
  EXPECT_EQ(scene.cones.size(), 0u);
  ASSERT_EQ(scene.frustums.size(), 2u);
  EXPECT_TRUE(scene.frustums[0].shape.caps);
  EXPECT_EQ(scene.frustums[0].shape.top, (Vec3{0.5, 0, 0}));
}

TEST(ParticlesOfScenes, TakeMaterialsAndTransforms) {
  const std::string red = "[material.red]\ndiffuse = [1, 0, 0]\nreflection = 0.25\n";
  const Scene plain = scene_of(red + shape_of("material = \"red\"\n"), kHere);
  EXPECT_EQ(plain.materials.size(), 1u);
  const Scene colored =
      scene_of(red + shape_of("material = \"red\"\ncolor_by = \"element\"\n"), kHere);
  const Material& oxygen = colored.materials[colored.spheres[0].material];
  EXPECT_EQ(oxygen.reflection.r, 0.25);
  EXPECT_EQ(oxygen.diffuse, linear_color(0xFF0D0D));
  const Scene moved = scene_of(shape_of("transform = [{scale = [1, 2, 3]}]\n"), kHere);
  EXPECT_EQ(moved.instances.size(), 1u);
  EXPECT_EQ(moved.groups.at(0).spheres.size(), 2u);
  expect_equal_again(shape_of("transform = [{translate = [1, 2, 3]}]\nname = \"all\"\n"));
}

TEST(ParticlesOfScenes, SayWhatIsWrong) {
  EXPECT_EQ(
      first_answer(shape_of("color_by = \"f\"\n"), kHere),
      "s.toml:3:8: error: file of particles: a.xyz:2:1: the frame has no column 'f': there are "
      "species, x, y, z, e");
  EXPECT_EQ(
      first_answer("[[shape]]\nkind = \"particles\"\nfile = \"bad.xyz\"\n", kHere),
      "s.toml:3:8: error: file of particles: bad.xyz:4:5: 'x' is not a finite number: expected "
      "y");
  EXPECT_EQ(first_answer(shape_of("frame = 2\n"), kHere),
            "s.toml:3:8: error: file of particles: a.xyz:2:1: there is no frame 2: the last one is "
            "1");
}

}  // namespace
}  // namespace zraka
