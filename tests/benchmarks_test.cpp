// SPDX-License-Identifier: Apache-2.0
// Generated scenes hold what their names promise, and rays through one of them are counted against
// published figures.
#include "school/generate/benchmarks.hpp"

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
  EXPECT_EQ(lattice.spheres.size(), 125u);
  EXPECT_EQ(lattice.cones.size(), 3u * 5 * 5 * 4);
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

RayCounts rays_of(const std::string& name, int size, int max_depth = 4) {
  return render(generated(name, size),
                {.profile = profile_of(ProfileName::spd), .max_depth = max_depth})
      .value()
      .stats.rays;
}

/// Within so many thousandths of a published count.
void expect_near(std::uint64_t count, double published, double thousandths) {
  EXPECT_NEAR(static_cast<double>(count), published, published * thousandths / 1000);
}

// The published counts are those of Havran and Sixta, "Comparison of hierarchical grids" (1999).
TEST(Benchmarks, TetraSendsThePublishedRays) {
  const RayCounts rays = rays_of("tetra", 6);
  EXPECT_EQ(rays.camera, 513u * 513);
  EXPECT_EQ(rays.hits, 49950u);
  EXPECT_EQ(rays.shadow, 46262u);
  EXPECT_EQ(rays.reflected + rays.refracted, 0u);
}

TEST(Benchmarks, RingsSendThePublishedRays) {
  EXPECT_EQ(rays_of("rings", 7, 0).hits, 263169u);  // no ray from the eye misses the wall
  const RayCounts rays = rays_of("rings", 7);
  expect_near(rays.shadow, 1077336, 10);
  expect_near(rays.reflected, 312879, 10);
  // Haines's own counts are nearer.
  expect_near(rays.shadow, 1085002, 0.2);
  expect_near(rays.reflected, 315236, 2);
}

TEST(Benchmarks, LatticeSendsThePublishedRaysWithoutALimit) {
  EXPECT_EQ(rays_of("lattice", 12, 0).hits, 261171u);  // 261 170 published
  const RayCounts five = rays_of("lattice", 12);
  expect_near(five.shadow, 1180774, 15);
  expect_near(five.reflected, 243210, 27);
  const RayCounts all = rays_of("lattice", 12, 20);
  expect_near(all.shadow, 1180774, 2);
  expect_near(all.reflected, 243210, 3);
}

TEST(Benchmarks, RefuseWhatTheyCannotMake) {
  EXPECT_EQ(generate_benchmark("teapot", 1, 1, "/dev/null").error()[0].message,
            "there is no benchmark 'teapot'");
  EXPECT_EQ(generate_benchmark("tetra", 13, 1, "/dev/null").error()[0].message,
            "size 13 of tetra is out of range: 1 to 12");
}

}  // namespace
}  // namespace zraka
