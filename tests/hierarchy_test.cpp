// SPDX-License-Identifier: Apache-2.0
// Hits through the hierarchy are those that asking every shape in double finds, whatever the input.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <random>

#include "accel/build.hpp"
#include "lanes_probe.hpp"
#include "scene/freeze.hpp"
#include "scenes.hpp"

namespace zraka {
namespace {

BuildRefs references_to(const FrozenScene<float>& scene) {
  BuildRefs refs(static_cast<std::size_t>(kind_starts_of(scene).back()));
  refer_to(scene, refs.data());
  return refs;
}

/// A scene frozen with its hierarchy in float, and without one in double.
struct Frozen {
  Frame frame;
  BuiltHierarchy hierarchy;
  std::unique_ptr<FrozenStore<float>> floats;
  std::unique_ptr<FrozenStore<double>> doubles;

  explicit Frozen(const Scene& scene) : frame(frame_of(scene)) {
    const Profile profile = profile_of(ProfileName::physical);
    floats = freeze<float>(scene, profile, frame);
    hierarchy = build_hierarchy(references_to(floats->scene), kind_starts_of(floats->scene));
    finish(*floats, hierarchy);
    doubles = freeze<double>(scene, profile, frame);
    finish(*doubles, {});
  }
};

/// Rays that start all over the scene and around it, every fourth one beside its neighbours and
/// parallel to them.
std::vector<ProbeRay> random_rays(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<ProbeRay> rays(count);
  for (std::size_t i = 0; i < count; ++i) {
    ProbeRay& ray = rays[i];
    double length = 0;
    for (int k = 0; k < 3; ++k) {
      ray.origin[k] = static_cast<double>(static_cast<float>(normal(random)));
      ray.direction[k] = normal(random);
      length += ray.direction[k] * ray.direction[k];
    }
    for (double& d : ray.direction)
      d = static_cast<double>(static_cast<float>(d / std::sqrt(length)));
    // Along an axis, now and then, where slabs divide by 0.
    if (i % 97 == 0)
      std::fill(ray.direction, ray.direction + 3, 0.0), ray.direction[i % 3] = i % 2 == 0 ? 1 : -1;
    ray.limit = i % 5 == 0 ? 0.5 : 1e20;
    if (i % 64 >= 16 && i % 64 < 48) {  // whole registers of coherent rays
      const ProbeRay& leader = rays[i - i % 64];
      for (int k = 0; k < 3; ++k) {
        ray.origin[k] =
            static_cast<double>(static_cast<float>(leader.origin[k] + 0.01 * normal(random)));
        ray.direction[k] = leader.direction[k];
      }
    }
  }
  return rays;
}

/// Compares all instruction sets with each other, bit by bit, and with the oracle but for rays that
/// graze.
/// ZRAKA_TEST_RAYS=1000000 in the environment asks for more rays than a test has time for; a
/// hundredth of them will do for large scenes.
void expect_oracle_hits(const Scene& scene, std::size_t count, double share) {
  if (const char* more = std::getenv("ZRAKA_TEST_RAYS")) {
    const auto rays = static_cast<std::size_t>(std::strtoull(more, nullptr, 10));
    count =
        std::max(count, scene.spheres.size() + scene.triangles.size() > 50000 ? rays / 100 : rays);
  }
  const Frozen frozen(scene);
  const std::vector<ProbeRay> rays = random_rays(count, 5);
  const auto probes = lanes_probes();
  std::vector<ProbeHit> want(count), first(count), got(count);
  const auto trace = [&](const LanesProbe& probe, std::vector<ProbeHit>& hits) {
    probe.trace(&frozen.floats->scene, &frozen.doubles->scene, rays.data(), hits.data(), count);
  };
  trace(probes.back(), want);
  for (std::size_t p = 0; p + 1 < probes.size(); ++p) {
    trace(probes[p], got);
    if (p == 0) first = got;
    std::size_t hits = 0, different = 0;
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_EQ(got[i].id, first[i].id) << "ray " << i << " by " << name_of(probes[p].isa);
      ASSERT_EQ(std::bit_cast<std::uint64_t>(got[i].t), std::bit_cast<std::uint64_t>(first[i].t))
          << "ray " << i;
      ASSERT_EQ(got[i].blocked, first[i].blocked)
          << "ray " << i << " by " << name_of(probes[p].isa);
      ASSERT_EQ(got[i].blocked, got[i].id >= 0) << "a feeler and a ray disagree: " << i;
      hits += want[i].id >= 0;
      const bool same_place = std::fabs(got[i].t - want[i].t) <= 1e-5 * (1 + std::fabs(want[i].t));
      if (got[i].id != want[i].id && !(want[i].id >= 0 && got[i].id >= 0 && same_place))
        ++different;
    }
    EXPECT_GT(hits, count / 100);
    EXPECT_LE(static_cast<double>(different), (1 - share) * static_cast<double>(count))
        << name_of(probes[p].isa);
  }
}

template <class Add>
Scene random_scene(int count, const Add& add) {
  Scene scene;
  scene.materials = {{}};
  std::mt19937 random(17);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < count; ++i) add(scene, unit, random);
  return scene;
}
const auto kPoint = [](auto& unit, auto& random, double scale = 1) {
  return Vec3{scale * unit(random), scale * unit(random), scale * unit(random)};
};
Vec3 sum(const Vec3& a, const Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

Scene spheres(int count, double size) {
  return random_scene(count, [&](Scene& scene, auto& unit, auto& random) {
    scene.spheres.push_back({{kPoint(unit, random), size * (1.1 + unit(random))}, 0});
  });
}
Scene triangles(int count, double size) {
  return random_scene(count, [&](Scene& scene, auto& unit, auto& random) {
    const Vec3 a = kPoint(unit, random);
    scene.triangles.push_back(
        {{a, sum(a, kPoint(unit, random, size)), sum(a, kPoint(unit, random, size))}, 0});
  });
}
Scene smooth_triangles(int count, double size) {
  return random_scene(count, [&](Scene& scene, auto& unit, auto& random) {
    const Vec3 a = kPoint(unit, random);
    scene.smooth_triangles.push_back(
        {{a, sum(a, kPoint(unit, random, size)), sum(a, kPoint(unit, random, size)),
          kPoint(unit, random), kPoint(unit, random), kPoint(unit, random)},
         0});
  });
}
Scene cones(int count, double size) {
  return random_scene(count, [&](Scene& scene, auto& unit, auto& random) {
    const Vec3 base = kPoint(unit, random);
    const double r = 0.2 * size * (1.1 + unit(random));
    const double top = unit(random) > 0 ? r : 0.2 * size * std::fmax(0.0, unit(random));
    scene.cones.push_back({{base, r, sum(base, kPoint(unit, random, size)), top}, 0});
  });
}
Scene everything(int count, double size) {
  Scene all = spheres(count, 0.3 * size);
  all.triangles = triangles(count, size).triangles;
  all.smooth_triangles = smooth_triangles(count, size).smooth_triangles;
  all.cones = cones(count, size).cones;
  return all;
}

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
  ZRAKA_KINDS(ZRAKA_FORGET)
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
    for (const ProbeHit& hit : hits) ASSERT_LE(hit.id, 0) << name_of(probe.isa);
  }
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
    ASSERT_EQ(again.nodes.size(), first.nodes.size());
    EXPECT_EQ(
        std::memcmp(again.nodes.data(), first.nodes.data(), first.nodes.size() * sizeof(Node)), 0);
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
    for (const ProbeHit& hit : hits) ASSERT_LE(hit.id, 0) << name_of(probe.isa);
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
