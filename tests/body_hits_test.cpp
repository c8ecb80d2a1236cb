// SPDX-License-Identifier: Apache-2.0
// What the engine finds of bodies in its own lanes, by ways that are shorter than all crossings, is
// the first of the crossings.
#include <fmt/format.h>

#include "expect_crossings.hpp"
#include "ray_count.hpp"

namespace zraka::truth {
namespace {

/// As the engine has rays: of floats.
std::vector<BodyProbeRay> in_floats(std::vector<BodyProbeRay> rays) {
  for (BodyProbeRay& ray : rays)
    for (int k = 0; k < 3; ++k) {
      ray.origin[k] = static_cast<double>(static_cast<float>(ray.origin[k]));
      ray.direction[k] = static_cast<double>(static_cast<float>(ray.direction[k]));
    }
  return rays;
}

/// Rays that go on from where others have hit, a bit off the surface on either side: as those of
/// shadows, mirrors and glass do.
template <class Shape>
std::vector<BodyProbeRay> rays_from(const Placed<Shape>& body,
                                    const std::vector<BodyProbeRay>& rays,
                                    const std::vector<BodyCrossings>& found, Random& random) {
  std::vector<BodyProbeRay> from;
  for (std::size_t i = 0; i < rays.size(); ++i)
    for (const Real t : finite_ones(found[i])) {
      const Point p = exact(rays[i]).at(t), up = normal(body.truth, p);
      const Real off = (random() % 2 == 0 ? 1 : -1) * 0x1p-16L;
      from.push_back(probe_ray(p + up * off, exact(on_unit_sphere(random))));
    }
  return from;
}

/// A ray's hits against its crossings. False where rounding alone says what is first.
template <class Shape>
bool expect_first(const Placed<Shape>& body, const BodyProbeRay& probed, const BodyCrossings& c,
                  double limit, const BodyHit& hit, bool in_doubles) {
  const double* const first =
      std::find_if(std::begin(c.at), std::end(c.at), [](double t) { return t > 0; });
  const double want = first == std::end(c.at) ? HUGE_VAL : *first;
  const double near = 1e-5 * (1 + std::min(want, 1e3));
  for (const double& other : c.at)
    if (std::fabs(other) < near || (&other != first && std::fabs(other - want) < near))
      return false;
  if (std::fabs(want - limit) < near) return false;
  const std::string whose = to_string(probed) + " crosses " + to_string(c);
  if (want > limit) {
    // What is beyond the limit may be found all the same.
    EXPECT_TRUE(!(hit.t > 0) || hit.t >= limit) << whose << ", hit at " << hit.t;
    EXPECT_TRUE(!(hit.any > 0) || hit.any >= limit) << whose << ", blocked at " << hit.any;
    return false;
  }
  const double error = in_doubles ? 1e-9 : 0x1p-23 * want;
  EXPECT_NEAR(hit.t, want, error) << whose;
  EXPECT_TRUE(hit.any > 0 && hit.any < limit) << whose << ", blocked at " << hit.any;
  const Ray ray = exact(probed);
  const Point p = ray.at(want), up = normal(body.truth, p);
  const Point got{hit.point[0], hit.point[1], hit.point[2]};
  const Point got_up{hit.normal[0], hit.normal[1], hit.normal[2]};
  // The point is that of the exact distance, and rounded.
  EXPECT_LE(length(got - p), in_doubles ? 1e-9L : 0x1p-23L * (length(p) + 1)) << whose;
  EXPECT_LE(length(got_up - up), 1e-6L) << whose;
  EXPECT_EQ(hit.inside, (first - c.at) % 2 == 1) << whose;
  return !testing::Test::HasFailure();
}

template <class Shape>
class BodyHits {
 public:
  /// The same bits of all engines in float, and the first crossings by all.
  void expect(const Placed<Shape>& body, const std::vector<BodyProbeRay>& rays, Random& random) {
    const auto crossed = crossings<Shape>(body.row, rays);
    const std::vector<double> numbers(body.row.numbers(), body.row.numbers() + Row::kSize);
    const std::vector<std::int32_t> start(rays.size());
    std::vector<double> limit(rays.size());
    for (double& l : limit)
      l = random() % 3 == 0 ? static_cast<float>(between(0, 5, random)) : 1e9f;
    std::vector<BodyHit> first, found(rays.size());
    for (const BodiesProbe& probe : bodies_probes()) {
      const bool in_doubles = probe.isa == Isa::oracle;
      probe.hit(type_of<Shape>(), numbers.data(), start.data(), rays.data(), limit.data(),
                found.data(), rays.size());
      if (first.empty()) first = found;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!in_doubles) {
          ASSERT_TRUE(found[i].t == first[i].t && found[i].any == first[i].any &&
                      found[i].inside == first[i].inside &&
                      std::equal(found[i].point, found[i].point + 3, first[i].point) &&
                      std::equal(found[i].normal, found[i].normal + 3, first[i].normal))
              << to_string(rays[i]) << " by " << name_of(probe.isa);
        }
        compared_ +=
            expect_first(body, rays[i], crossed[i], limit[i], found[i], in_doubles) ? 1 : 0;
        ASSERT_FALSE(testing::Test::HasFailure()) << "by " << name_of(probe.isa);
      }
    }
  }
  std::size_t compared() const { return compared_; }

 private:
  std::size_t compared_ = 0;
};

template <class Shape>
void expect_hits_where_crossed_first(std::uint32_t seed) {
  BodyHits<Shape> hits;
  Random random(seed);
  for (int k = 0; k < 60; ++k) {
    SCOPED_TRACE(fmt::format("body {}", k));
    const Placed<Shape> body(random, {});
    const auto rays = in_floats(rays_at(body, ray_count(12000) / 60, random));
    const auto crossed = crossings<Shape>(body.row, rays);
    hits.expect(body, rays, random);
    hits.expect(body, in_floats(touching_rays(body, rays, crossed, random)), random);
    hits.expect(body, in_floats(rays_from(body, rays, crossed, random)), random);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(hits.compared(), 10000u);
}

TEST(BodyHits, OfToriAreWhereRaysCrossThemFirst) {
  expect_hits_where_crossed_first<Torus>(1);
}
TEST(BodyHits, OfEllipsoidsAreWhereRaysCrossThemFirst) {
  expect_hits_where_crossed_first<Ellipsoid>(2);
}

/// Each lane's torus and ray is its own affair, whoever is beside it.
TEST(BodyHits, OfToriDoNotDependOnOtherLanes) {
  Random random(3);
  std::vector<double> numbers;
  std::vector<std::int32_t> start;
  std::vector<BodyProbeRay> rays;
  for (int k = 0; k < 500; ++k) {
    const Placed<Torus> body(random, {});
    auto some = in_floats(rays_at(body, 20, random));
    const auto touching =
        in_floats(touching_rays(body, some, crossings<Torus>(body.row, some), random));
    some.insert(some.end(), touching.begin(), touching.end());
    start.insert(start.end(), some.size(), static_cast<std::int32_t>(numbers.size()));
    numbers.insert(numbers.end(), body.row.numbers(), body.row.numbers() + Row::kSize);
    rays.insert(rays.end(), some.begin(), some.end());
  }
  const std::vector<double> limit(rays.size(), 1e9);
  for (const BodiesProbe& probe : bodies_probes()) {
    std::vector<BodyHit> together(rays.size());
    probe.hit(kTypeTorus, numbers.data(), start.data(), rays.data(), limit.data(), together.data(),
              rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      BodyHit alone;
      probe.hit(kTypeTorus, numbers.data(), &start[i], &rays[i], &limit[i], &alone, 1);
      ASSERT_EQ(alone.t, together[i].t) << to_string(rays[i]);
      if (!(alone.t > 0)) continue;
      ASSERT_TRUE(std::equal(alone.point, alone.point + 3, together[i].point) &&
                  std::equal(alone.normal, alone.normal + 3, together[i].normal))
          << to_string(rays[i]);
    }
  }
}

}  // namespace
}  // namespace zraka::truth
