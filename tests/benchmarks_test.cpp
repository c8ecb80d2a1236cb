// SPDX-License-Identifier: Apache-2.0
// Generated scenes hold what their names promise, and rays through one of them are counted against
// published figures.
#include "generate/benchmarks.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <zraka/zraka.hpp>

namespace zraka {
namespace {

Scene generated(const std::string& name, int size, std::uint32_t seed = 1) {
  std::string path = (std::filesystem::temp_directory_path() / "benchmark-XXXXXX").string();
  close(mkstemp(path.data()));
  EXPECT_TRUE(generate_benchmark(name, size, seed, path));
  Scene scene = read_scene(path).value().scene;
  std::filesystem::remove(path);
  return scene;
}

TEST(Benchmarks, HoldAsManyShapesAsTheySay) {
  EXPECT_EQ(generated("sphereflake", 0).spheres.size(), 1u);
  EXPECT_EQ(generated("sphereflake", 3).spheres.size(), 820u);
  const Scene lattice = generated("lattice", 4);
  EXPECT_EQ(lattice.spheres.size(), 64u);
  EXPECT_EQ(lattice.cones.size(), 3u * 4 * 4 * 3);
  const Scene rings = generated("rings", 3);
  EXPECT_EQ(rings.spheres.size(), 30u * (9 + 4 + 1));
  EXPECT_EQ(rings.cones.size(), rings.spheres.size());
  EXPECT_EQ(generated("spheres", 3).spheres.size(), 1000u);
  EXPECT_EQ(generated("terrain", 3).triangles.size(), 128u);
  EXPECT_EQ(generated("tetra", 1).triangles.size(), 4u);
  EXPECT_EQ(generated("tetra", 4).triangles.size(), 256u);
}

TEST(Benchmarks, AreTheSameForTheSameSeedOnly) {
  const auto first = [](std::uint32_t seed) {
    return generated("spheres", 1, seed).spheres[0].shape.center;
  };
  EXPECT_EQ(first(1), first(1));
  EXPECT_FALSE(first(1) == first(2));
}

/// Havran and Sixta, "Comparison of hierarchical grids" (1999): 49 950 rays from the eye hit,
/// 46 262 feelers are sent.
TEST(Benchmarks, TetraSendsThePublishedRays) {
  const Rendering rendering =
      render(generated("tetra", 6), {.profile = profile_of(ProfileName::spd)}).value();
  EXPECT_EQ(rendering.stats.rays.camera, 513u * 513);
  EXPECT_EQ(rendering.stats.rays.hits, 49950u);
  EXPECT_EQ(rendering.stats.rays.shadow, 46262u);
  EXPECT_EQ(rendering.stats.rays.reflected + rendering.stats.rays.refracted, 0u);
}

TEST(Benchmarks, RefuseWhatTheyCannotMake) {
  EXPECT_EQ(generate_benchmark("teapot", 1, 1, "/dev/null").error()[0].message,
            "there is no benchmark 'teapot'");
  EXPECT_EQ(generate_benchmark("tetra", 13, 1, "/dev/null").error()[0].message,
            "size 13 of tetra is out of range: 1 to 12");
}

}  // namespace
}  // namespace zraka
