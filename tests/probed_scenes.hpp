// SPDX-License-Identifier: Apache-2.0
// Random scenes frozen for the engine, random rays, and what they have to hit.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>
#include <vector>

#include "accel/build.hpp"
#include "lanes_probe.hpp"
#include "ray_count.hpp"
#include "scene/freeze.hpp"

namespace zraka {

inline BuildRefs references_to(const FrozenScene<float>& scene) {
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
    reorder_by_leaf(*floats, hierarchy);
    doubles = freeze<double>(scene, profile, frame);
    reorder_by_leaf(*doubles, {});
  }
};

/// Rays that start all over the scene and around it, every fourth one beside its neighbours and
/// parallel to them.
inline std::vector<ProbeRay> random_rays(std::size_t count, unsigned seed) {
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
/// graze. Of more rays than usual a hundredth will do for large scenes.
inline void expect_oracle_hits(const Scene& scene, std::size_t count, double share) {
  const bool large = scene.spheres.size() + scene.triangles.size() > 50000;
  count = large ? std::max(count, ray_count(count) / 100) : ray_count(count);
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
      ASSERT_EQ(got[i].blocked, got[i].id >= 0) << "a shadow ray and a ray disagree: " << i;
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
inline const auto kPoint = [](auto& unit, auto& random, double scale = 1) {
  return Vec3{scale * unit(random), scale * unit(random), scale * unit(random)};
};
inline Vec3 sum(const Vec3& a, const Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline Scene spheres(int count, double size) {
  return random_scene(count, [&](Scene& scene, auto& unit, auto& random) {
    scene.spheres.push_back({{kPoint(unit, random), size * (1.1 + unit(random))}, 0});
  });
}
inline Scene triangles(int count, double size) {
  return random_scene(count, [&](Scene& scene, auto& unit, auto& random) {
    const Vec3 a = kPoint(unit, random);
    scene.triangles.push_back(
        {{a, sum(a, kPoint(unit, random, size)), sum(a, kPoint(unit, random, size))}, 0});
  });
}
inline Scene smooth_triangles(int count, double size) {
  return random_scene(count, [&](Scene& scene, auto& unit, auto& random) {
    const Vec3 a = kPoint(unit, random);
    scene.smooth_triangles.push_back(
        {{a, sum(a, kPoint(unit, random, size)), sum(a, kPoint(unit, random, size)),
          kPoint(unit, random), kPoint(unit, random), kPoint(unit, random)},
         0});
  });
}
inline Scene cones(int count, double size) {
  return random_scene(count, [&](Scene& scene, auto& unit, auto& random) {
    const Vec3 base = kPoint(unit, random);
    const double r = 0.2 * size * (1.1 + unit(random));
    const double top = unit(random) > 0 ? r : 0.2 * size * std::fmax(0.0, unit(random));
    scene.cones.push_back({{base, r, sum(base, kPoint(unit, random, size)), top}, 0});
  });
}
/// All of one radius each, as the engine's own kind.
inline Scene cylinders(int count, double size) {
  Scene scene = cones(count, size);
  for (Object<Cone>& object : scene.cones) object.shape.apex_radius = object.shape.base_radius;
  return scene;
}
inline Scene everything(int count, double size) {
  Scene all = spheres(count, 0.3 * size);
  all.triangles = triangles(count, size).triangles;
  all.smooth_triangles = smooth_triangles(count, size).smooth_triangles;
  all.cones = cones(count, size).cones;
  return all;
}

}  // namespace zraka
