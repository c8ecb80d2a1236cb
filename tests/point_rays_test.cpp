// SPDX-License-Identifier: Apache-2.0
// Rays of one point are blocked where each of them is by itself.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "probed_scenes.hpp"

namespace zraka {
namespace {

/// So many rays from a point: any way, along axes, and past the edge of a sphere by hairs.
std::vector<ProbeRay> rays_from(const Vec3& point, double limit, const Sphere& sphere,
                                std::size_t count, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<ProbeRay> rays(count);
  const Vec3 to{sphere.center.x - point.x, sphere.center.y - point.y, sphere.center.z - point.z};
  const double away = std::sqrt(to.x * to.x + to.y * to.y + to.z * to.z);
  for (std::size_t i = 0; i < count; ++i) {
    double d[3] = {normal(random), normal(random), normal(random)};
    if (i % 16 == 0) {
      std::fill(d, d + 3, 0.0), d[i / 16 % 3] = i % 32 == 0 ? 1 : -1;
    } else if (i % 4 == 1 && away > sphere.radius) {
      // Where the tangent touches, seen from the point, in some direction across.
      const double along = (d[0] * to.x + d[1] * to.y + d[2] * to.z) / (away * away);
      const double across[3] = {d[0] - along * to.x, d[1] - along * to.y, d[2] - along * to.z};
      const double sine = sphere.radius / away;
      const double length =
          std::sqrt(across[0] * across[0] + across[1] * across[1] + across[2] * across[2]);
      const double slope = sine / std::sqrt(1 - sine * sine) * (1 + 1e-6 * normal(random));
      const double axis[3] = {to.x, to.y, to.z};
      for (int k = 0; k < 3; ++k) d[k] = axis[k] / away + across[k] / length * slope;
    }
    const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    rays[i] = {{point.x, point.y, point.z}, {}, limit};
    for (int k = 0; k < 3; ++k)
      rays[i].direction[k] = static_cast<double>(static_cast<float>(d[k] / length));
  }
  return rays;
}

/// Points anywhere, on spheres or a little before them, and inside.
void expect_blocked_alike(const Scene& scene, const FrozenScene<float>& floats,
                          const Frozen& frozen) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::size_t blocked = 0, all = 0;
  for (int round = 0; round < 300; ++round) {
    const auto pick = [&] {
      const Sphere& s = scene.spheres[random() % scene.spheres.size()].shape;
      return Sphere{frozen.frame.point(s.center), frozen.frame.length(s.radius)};
    };
    const Sphere at = pick(), near = pick();
    Vec3 out{unit(random), unit(random), unit(random)};
    const double length = std::sqrt(out.x * out.x + out.y * out.y + out.z * out.z);
    const double share[] = {1, 1 + 1e-6, 0.5, 3, 20};
    const double far = at.radius * share[round % 5] / length;
    const auto narrow = [](double v) { return static_cast<double>(static_cast<float>(v)); };
    const Vec3 point{narrow(at.center.x + out.x * far), narrow(at.center.y + out.y * far),
                     narrow(at.center.z + out.z * far)};
    const double limits[] = {1e20, 0x1p100, at.radius * 3, at.radius * 20};
    const std::vector<ProbeRay> rays =
        rays_from(point, narrow(limits[round % 4]), round % 2 == 0 ? at : near,
                  round % 7 == 0 ? 1 + random() % 64 : 64, random);
    std::vector<ProbeHit> want(rays.size());
    for (const LanesProbe& probe : lanes_probes()) {
      if (probe.isa == Isa::oracle) continue;
      probe.trace(&floats, nullptr, rays.data(), want.data(), rays.size());
      const std::uint64_t got = probe.from_point(&floats, nullptr, rays.data(), rays.size());
      for (std::size_t i = 0; i < rays.size(); ++i)
        ASSERT_EQ((got >> i & 1) != 0, want[i].blocked)
            << "ray " << i << " of round " << round << " by " << name_of(probe.isa);
      if (rays.size() < 64) {
        ASSERT_EQ(got >> rays.size(), 0u);
      }
    }
    for (const ProbeHit& hit : want) blocked += hit.blocked ? 1 : 0;
    all += want.size();
  }
  EXPECT_GT(blocked, all / 20);
  EXPECT_LT(blocked, all - all / 20);
}

void expect_blocked_alike(const Scene& scene) {
  const Frozen frozen(scene);
  ASSERT_NE(frozen.floats->scene.hierarchy.nodes, nullptr);
  expect_blocked_alike(scene, frozen.floats->scene, frozen);
}

TEST(PointRays, AreBlockedByTheSpheresThatBlockEachAlone) {
  expect_blocked_alike(spheres(1000, 0.05));
}
TEST(PointRays, AreBlockedAmongSpheresThatOverlap) {
  expect_blocked_alike(spheres(300, 0.2));
}
TEST(PointRays, AreBlockedInDeepHierarchies) {
  expect_blocked_alike(spheres(30000, 0.015));
}

TEST(PointRays, AreBlockedAmongShapesOfAllKinds) {
  Scene scene = everything(400, 0.15);
  scene.cones.insert(scene.cones.end(), 50, {});
  const Scene more = cylinders(50, 0.2);
  std::copy(more.cones.begin(), more.cones.end(), scene.cones.end() - 50);
  expect_blocked_alike(scene);
}
TEST(PointRays, AreBlockedByPlanes) {
  Scene scene = everything(300, 0.1);
  scene.planes.push_back({{{0, -0.8, 0}, {0.1, 1, 0.2}}, 0});
  scene.planes.push_back({{{0.9, 0, 0}, {1, 0.1, -0.3}}, 0});
  expect_blocked_alike(scene);
}

TEST(PointRays, GoThroughShapesThatThrowNoShadows) {
  Scene scene = everything(400, 0.1);
  scene.planes.push_back({{{0, -0.5, 0}, {0, 1, 0}}, 1});
  scene.materials.push_back({});
  for (std::size_t i = 0; i < 400; i += 3)
    scene.spheres[i].material = scene.triangles[i].material = scene.cones[i].material = 1;
  const Frozen frozen(scene);
  FrozenScene<float> floats = frozen.floats->scene;
  const std::uint8_t shadowless[] = {0, 1};
  floats.shadowless = shadowless;
  expect_blocked_alike(scene, floats, frozen);
}

TEST(PointRays, OfNoNumbersAreFree) {
  const Scene scene = spheres(1000, 0.05);
  const Frozen frozen(scene);
  std::vector<ProbeRay> rays(3, ProbeRay{{0, 0, 0}, {1, 0, 0}, 1e20});
  rays[1].direction[1] = std::nan("");
  rays[2].direction[0] = std::numeric_limits<double>::infinity();
  for (const LanesProbe& probe : lanes_probes()) {
    if (probe.isa == Isa::oracle) continue;
    EXPECT_EQ(probe.from_point(&frozen.floats->scene, nullptr, rays.data(), 3) & 6, 0u);
  }
}

}  // namespace
}  // namespace zraka
