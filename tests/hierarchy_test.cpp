// SPDX-License-Identifier: Apache-2.0
// Hits through the hierarchy are those that asking every shape in double finds, whatever the input.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "probed_scenes.hpp"
#include "scenes.hpp"

namespace zraka {
namespace {

TEST(Hierarchy, HitsTheSpheresThatAskingAllHits) {
  expect_oracle_hits(spheres(1000, 0.05), 20000, 0.9999);
}
TEST(Hierarchy, HitsTheTrianglesThatAskingAllHits) {
  expect_oracle_hits(triangles(1000, 0.3), 20000, 0.9999);
}
TEST(Hierarchy, HitsTheSmoothTrianglesThatAskingAllHits) {
  expect_oracle_hits(smooth_triangles(1000, 0.3), 20000, 0.9999);
}
TEST(Hierarchy, HitsTheConesThatAskingAllHits) {
  expect_oracle_hits(cones(1000, 0.3), 20000, 0.9998);
}
TEST(Hierarchy, HitsTheCylindersThatAskingAllHits) {
  expect_oracle_hits(cylinders(1000, 0.3), 20000, 0.9998);
}
TEST(Hierarchy, HitsCylindersAsConesOfNoSlope) {
  // One tiny cone among them makes all of them cones to the engine.
  Scene scene = cylinders(500, 0.3), sloped = scene;
  const Cone tiny{{0, 0, 0}, 1e-7, {1e-7, 0, 0}, 1e-7};
  scene.cones.push_back({tiny, 0});
  sloped.cones.push_back({tiny, 0});
  sloped.cones.back().shape.apex_radius = 1.0001e-7;
  const Frozen plain(scene), slow(sloped);
  ASSERT_EQ(plain.floats->scene.cylinders.count, 501);
  ASSERT_EQ(slow.floats->scene.cones.count, 501);
  const std::vector<ProbeRay> rays = random_rays(20000, 5);
  std::vector<ProbeHit> got(rays.size()), want(rays.size());
  for (const LanesProbe& probe : lanes_probes()) {
    probe.trace(&plain.floats->scene, &plain.doubles->scene, rays.data(), got.data(), rays.size());
    probe.trace(&slow.floats->scene, &slow.doubles->scene, rays.data(), want.data(), rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      ASSERT_EQ(got[i].id, want[i].id) << "ray " << i << " by " << name_of(probe.isa);
      ASSERT_EQ(got[i].t, want[i].t) << "ray " << i << " by " << name_of(probe.isa);
    }
  }
}
TEST(Hierarchy, HitsShapesOfAllKinds) {
  expect_oracle_hits(everything(500, 0.3), 20000, 0.9998);
}
TEST(Hierarchy, HitsShapesInFullLeaves) {
  expect_oracle_hits(spheres(70000, 0.005), 2000, 0.9995);
  expect_oracle_hits(triangles(70000, 0.02), 2000, 0.9995);
}
void expect_same_without_rows(const Scene& scene) {
  const Frozen frozen(scene);
  FrozenScene<float> without = frozen.floats->scene;
#define ZRAKA_FORGET(Type, plural)                            \
  if (without.plural.count > 0) {                             \
    EXPECT_NE(without.plural.rows, nullptr) << "of " #plural; \
    without.plural.rows = nullptr;                            \
  }
  ZRAKA_INLINED_KINDS(ZRAKA_FORGET)
#undef ZRAKA_FORGET
  const std::vector<ProbeRay> rays = random_rays(20000, 5);
  std::vector<ProbeHit> want(rays.size()), got(rays.size());
  for (const LanesProbe& probe : lanes_probes()) {
    if (probe.isa == Isa::oracle) continue;
    probe.trace(&frozen.floats->scene, nullptr, rays.data(), want.data(), rays.size());
    probe.trace(&without, nullptr, rays.data(), got.data(), rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      ASSERT_EQ(got[i].t, want[i].t) << "ray " << i << " by " << name_of(probe.isa);
      ASSERT_EQ(got[i].id, want[i].id) << "ray " << i << " by " << name_of(probe.isa);
      ASSERT_EQ(got[i].blocked, want[i].blocked) << "ray " << i << " by " << name_of(probe.isa);
    }
  }
}
TEST(Hierarchy, HitsTheSameWithoutRows) {
  Scene scene = everything(750, 0.3);
  expect_same_without_rows(scene);
  add_sphere(scene, {0, -104, 0}, 100, {});
  EXPECT_GT(Frozen(scene).floats->scene.anchored_spheres.count, 0);
  expect_same_without_rows(scene);
}
TEST(Hierarchy, HasNoRowsInLargeScenes) {
  EXPECT_EQ(Frozen(spheres(70000, 0.001)).floats->scene.spheres.rows, nullptr);
}
TEST(Hierarchy, HitsAFewShapes) {
  expect_oracle_hits(everything(1, 1.0), 20000, 0.9998);
}

TEST(Hierarchy, HitsSmallShapesInsideOneHugeSphere) {
  Scene scene = everything(300, 0.2);
  scene.spheres.push_back({{{0, 0, 0}, 50}, 0});
  expect_oracle_hits(scene, 10000, 0.999);
}

TEST(Hierarchy, HitsScenesFarFromTheOrigin) {
  Scene scene = everything(300, 0.3);
  const auto move = [](Vec3& v) { v = sum(v, {1e6, -2e6, 3e6}); };
  for (auto& s : scene.spheres) move(s.shape.center);
  for (auto& s : scene.triangles) move(s.shape.a), move(s.shape.b), move(s.shape.c);
  for (auto& s : scene.smooth_triangles) move(s.shape.a), move(s.shape.b), move(s.shape.c);
  for (auto& s : scene.cones) move(s.shape.base), move(s.shape.apex);
  expect_oracle_hits(scene, 10000, 0.9998);
}

TEST(Hierarchy, TakesTheFirstOfManyEqualShapes) {
  Scene scene;
  scene.materials = {{}};
  for (int i = 0; i < 5000; ++i) scene.spheres.push_back({{{0, 0, 0}, 1}, 0});
  const Frozen frozen(scene);
  const std::vector<ProbeRay> rays = random_rays(1000, 3);
  std::vector<ProbeHit> hits(rays.size());
  for (const LanesProbe& probe : lanes_probes()) {
    if (probe.isa == Isa::oracle) continue;
    probe.trace(&frozen.floats->scene, nullptr, rays.data(), hits.data(), rays.size());
    std::size_t first = 0;
    for (const ProbeHit& hit : hits) {
      ASSERT_LE(hit.id, 0) << name_of(probe.isa);
      first += hit.id == 0;
    }
    EXPECT_GT(first, rays.size() / 4) << name_of(probe.isa);
  }
}

/// The shape that a ray hits at a distance of 1, through the hierarchy, in the list and by the
/// oracle, in every instruction set.
void expect_hit_at_one(const Scene& scene, const ProbeRay& ray, std::int32_t id) {
  const Frozen frozen(scene);
  const auto listed = freeze<float>(scene, profile_of(ProfileName::physical), frame_of(scene));
  reorder_by_leaf(*listed, {});
  const double scale = frozen.frame.scale;
  const Vec3 origin = frozen.frame.point({ray.origin[0], ray.origin[1], ray.origin[2]});
  ProbeRay framed = ray;
  framed.origin[0] = origin.x, framed.origin[1] = origin.y, framed.origin[2] = origin.z;
  for (const LanesProbe& probe : lanes_probes())
    for (const FrozenScene<float>* floats : {&frozen.floats->scene, &listed->scene}) {
      ProbeHit hit{};
      probe.trace(floats, &frozen.doubles->scene, &framed, &hit, 1);
      EXPECT_EQ(hit.id, id) << name_of(probe.isa)
                            << (floats == &listed->scene ? ", in the list" : "");
      EXPECT_EQ(hit.t, scale) << name_of(probe.isa) << ": the shapes no longer tie";
    }
}

TEST(Hierarchy, GivesATieToTheShapeThatWasReadFirst) {
  const ProbeRay down{{0, 1, 0}, {0, -1, 0}, 1e20};
  const auto add_tiles = [](Scene& scene) {
    for (int i = -8; i <= 8; ++i) {
      const double x = 0.25 * i;
      scene.triangles.push_back({{{x - 0.6, 0, -1}, {x + 0.6, 0, -1}, {x, 0, 1}}, 0});
    }
  };
  Scene ground;
  ground.materials = {{}};
  ground.spheres = {{{{0, -64, 0}, 64}, 0}};
  add_tiles(ground);
  EXPECT_EQ(Frozen(ground).floats->scene.anchored_spheres.count, 1);
  expect_hit_at_one(ground, down, 0);

  Scene balls;
  balls.materials = {{}};
  balls.spheres = {{{{0, -1, 0}, 1}, 0}};
  add_tiles(balls);
  EXPECT_EQ(Frozen(balls).floats->scene.spheres.count, 1);
  expect_hit_at_one(balls, down, 0);

  Scene pipes;
  pipes.materials = {{}};
  add_tiles(pipes);
  pipes.cones = {{{{-4, -1, 0}, 1, {4, -1, 0}, 1}, 0}};
  EXPECT_EQ(Frozen(pipes).floats->scene.cylinders.count, 1);
  expect_hit_at_one(pipes, down, 7);
}

TEST(Hierarchy, LetsChildrenOfAFloorOutOfItsBox) {
  // A mirror that is large beside the eye's distance from it.
  Scene scene = lab_scene(60);
  scene.materials = {{.reflection = 0.5}};
  const Vec3 a{-30, -30, -1}, b{30, -30, -1}, c{30, 30, -1}, d{-30, 30, -1};
  scene.triangles = {{{a, b, c}, 0}, {{a, c, d}, 0}};
  const Frame frame = frame_of(scene);
  const auto store = freeze<float>(scene, profile_of(ProfileName::lab), frame);
  BuildRefs refs = references_to(store->scene);
  ASSERT_EQ(refs.size(), 2u);
  for (const std::uint32_t x : {0u, 17u, 30u, 59u})
    for (const std::uint32_t y : {0u, 23u, 30u, 59u}) {
      const Explanation seen =
          explain(scene, {.profile = profile_of(ProfileName::lab)}, x, y).value();
      const std::vector<ExplainedRay>& rays = seen.trees[0].rays;
      ASSERT_EQ(rays.size(), 2u) << "the mirror and the sky, at " << x << ", " << y;
      EXPECT_GT(frame.point(rays[1].origin).z, static_cast<double>(refs[0].upper[2]))
          << "a reflected ray would meet the floor's triangles again, from " << x << ", " << y;
    }
}

TEST(Hierarchy, IsTheSameFromAnyNumberOfThreads) {
  const Scene scene = everything(20000, 0.05);
  const auto store = freeze<float>(scene, profile_of(ProfileName::physical), frame_of(scene));
  const std::vector<std::int32_t> starts = kind_starts_of(store->scene);
  const BuiltHierarchy first = build_hierarchy(references_to(store->scene), starts);
  for (const std::size_t threads : {1u, 2u, 3u}) {
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const BuiltHierarchy again = build_hierarchy(references_to(store->scene), starts);
    EXPECT_EQ(again.order, first.order);
    EXPECT_TRUE(again.nodes == first.nodes);
  }
}

TEST(Triangle, OfNoAreaIsNotMet) {
  Scene scene;
  scene.materials = {{}};
  for (int i = 0; i < 100; ++i) {
    const double x = 0.01 * i;
    scene.triangles.push_back({{{x, 0, 0}, {x, 1, 0}, {x, 1, 0}}, 0});
    scene.triangles.push_back({{{x, 0, 0}, {x, 0, 0}, {x, 0, 0}}, 0});
  }
  scene.spheres.push_back({{{0, 0, 0}, 0.5}, 0});
  const Frozen frozen(scene);
  const std::vector<ProbeRay> rays = random_rays(3000, 3);
  std::vector<ProbeHit> hits(rays.size());
  for (const LanesProbe& probe : lanes_probes()) {
    probe.trace(&frozen.floats->scene, &frozen.doubles->scene, rays.data(), hits.data(),
                rays.size());
    std::size_t of_sphere = 0;
    for (const ProbeHit& hit : hits) {
      ASSERT_LE(hit.id, 0) << name_of(probe.isa);
      of_sphere += hit.id == 0;
    }
    EXPECT_GT(of_sphere, rays.size() / 50) << name_of(probe.isa);
  }
}

TEST(Triangle, LeavesNoGapBetweenNeighbours) {
  // A closed box of triangles, seen from inside: no ray gets out.
  Scene scene;
  scene.materials = {{}};
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(-1, 1);
  constexpr int kSide = 12;
  const auto corner = [&](int face, int i, int j) {
    const double u = 2.0 * i / kSide - 1, v = 2.0 * j / kSide - 1, w = face < 3 ? 1 : -1;
    return face % 3 == 0 ? Vec3{w, u, v} : face % 3 == 1 ? Vec3{u, w, v} : Vec3{u, v, w};
  };
  for (int face = 0; face < 6; ++face)
    for (int i = 0; i < kSide; ++i)
      for (int j = 0; j < kSide; ++j) {
        const Vec3 a = corner(face, i, j), b = corner(face, i + 1, j),
                   c = corner(face, i + 1, j + 1), d = corner(face, i, j + 1);
        scene.triangles.push_back({{a, b, c}, 0});
        scene.triangles.push_back({{a, c, d}, 0});
      }
  const Frozen frozen(scene);
  // Towards edges and corners as well as anywhere.
  std::vector<ProbeRay> rays;
  for (int i = 0; i < 20000; ++i) {
    Vec3 target = corner(i % 6, static_cast<int>(random() % (kSide + 1)),
                         static_cast<int>(random() % (kSide + 1)));
    if (i % 2 == 0) target = {target.x, target.y + 0.1 * unit(random), target.z};
    ProbeRay ray{{0.3 * unit(random), 0.3 * unit(random), 0.3 * unit(random)}, {}, 1e20};
    const double d[3] = {target.x - ray.origin[0], target.y - ray.origin[1],
                         target.z - ray.origin[2]};
    const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    for (int k = 0; k < 3; ++k) ray.direction[k] = d[k] / length;
    rays.push_back(ray);
  }
  std::vector<ProbeHit> hits(rays.size());
  for (const LanesProbe& probe : lanes_probes()) {
    probe.trace(&frozen.floats->scene, &frozen.doubles->scene, rays.data(), hits.data(),
                rays.size());
    for (std::size_t i = 0; i < hits.size(); ++i)
      ASSERT_GE(hits[i].id, 0) << i << " by " << name_of(probe.isa);
  }
}

/// One ray against one shape, in every instruction set; the scene is small enough for its frame to
/// be the world's but for a shift and a power of two.
double distance_to(const Scene& scene, Vec3 origin, Vec3 direction) {
  const Frozen frozen(scene);
  const Vec3 o = frozen.frame.point(origin);
  const ProbeRay ray{{o.x, o.y, o.z}, {direction.x, direction.y, direction.z}, 1e20};
  double distance = 0;
  for (const LanesProbe& probe : lanes_probes()) {
    ProbeHit hit;
    probe.trace(&frozen.floats->scene, &frozen.doubles->scene, &ray, &hit, 1);
    distance = hit.id < 0 ? -1 : hit.t / frozen.frame.scale;
    if (probe.isa == Isa::oracle) continue;
    EXPECT_EQ(hit.blocked, hit.id >= 0);
  }
  return distance;
}

TEST(Cone, IsMetOnItsSideAndNotOnItsCaps) {
  Scene scene;
  scene.materials = {{}};
  scene.cones = {{{{0, 0, 0}, 1, {0, 4, 0}, 1}, 0}};  // a cylinder
  EXPECT_NEAR(distance_to(scene, {5, 2, 0}, {-1, 0, 0}), 4, 1e-6);
  EXPECT_NEAR(distance_to(scene, {0, 2, 0}, {-1, 0, 0}), 1, 1e-6);  // from inside
  EXPECT_NEAR(distance_to(scene, {0.5, 9, 0}, {0, -1, 0}), -1,
              1e-6);  // in through the open end, and out
  EXPECT_NEAR(distance_to(scene, {5, 4.01, 0}, {-1, 0, 0}), -1, 1e-6);  // beyond the end
  EXPECT_NEAR(distance_to(scene, {5, 3.99, 0}, {-1, 0, 0}), 4, 1e-6);
  const double s = std::sqrt(0.5);
  EXPECT_NEAR(distance_to(scene, {-2, 5.5, 0}, {s, -s, 0}), 3 / s,
              1e-5);  // over the rim, onto the inside
}

TEST(Cone, HasOneTip) {
  Scene scene;
  scene.materials = {{}};
  scene.cones = {{{{0, 0, 0}, 1, {0, 1, 0}, 0}, 0}};
  EXPECT_NEAR(distance_to(scene, {5, 0.5, 0}, {-1, 0, 0}), 4.5, 1e-6);
  EXPECT_NEAR(distance_to(scene, {5, 1.5, 0}, {-1, 0, 0}), -1, 1e-6)
      << "the mirror cone beyond the tip";
  EXPECT_NEAR(distance_to(scene, {0.25, 5, 0}, {0, -1, 0}), 4.25, 1e-6);
  // Parallel to the side: a quadratic without its square.
  const double s = std::sqrt(0.5);
  EXPECT_NEAR(distance_to(scene, {-1.5, 2, 0}, {s, -s, 0}), 1.25 / s, 1e-5);
}

}  // namespace
}  // namespace zraka
