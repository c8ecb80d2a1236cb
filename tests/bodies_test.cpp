// SPDX-License-Identifier: Apache-2.0
// Every body's crossings against its equation in long double, by every instruction set: all lie on
// it, and none is lost; and what else its file says of it.
#include <fmt/format.h>

#include "expect_crossings.hpp"
#include "ray_count.hpp"

namespace zraka {
namespace isa_avx512 {
BodiesProbe bodies_probe();
}
namespace isa_avx2 {
BodiesProbe bodies_probe();
}
namespace isa_portable {
BodiesProbe bodies_probe();
}
namespace isa_oracle {
BodiesProbe bodies_probe();
}

std::vector<BodiesProbe> bodies_probes() {
  std::vector<BodiesProbe> probes;
  for (const Isa isa : available_isas()) {
#ifdef ZRAKA_HAVE_X86
    if (isa == Isa::avx512) probes.push_back(isa_avx512::bodies_probe());
    if (isa == Isa::avx2) probes.push_back(isa_avx2::bodies_probe());
#endif
    if (isa == Isa::portable) probes.push_back(isa_portable::bodies_probe());
    probes.back().isa = isa;
  }
  probes.push_back(isa_oracle::bodies_probe());
  probes.back().isa = Isa::oracle;
  return probes;
}

namespace truth {
namespace {

template <class Shape>
class Bodies : public testing::Test {
 protected:
  /// Calls function(body, rays, found) for bodies in all places, with so many rays in all.
  template <class Function>
  static void each_body(std::size_t count, const Function& function) {
    /// As it is, 10^±6 times as large, and 10^6 away.
    const Place places[] = {{},
                            {1e6, {}},
                            {1e-6, {}},
                            {1, {1e6, -2e6, 3e6}},
                            {1e6, {-1e12, 1e12, 0}},
                            {1e-6, {1, 1, -1}}};
    constexpr std::size_t kBodies = 40;
    Random random(1);
    for (const Place& place : places)
      for (std::size_t k = 0; k < kBodies; ++k) {
        SCOPED_TRACE(fmt::format("body {}, {} times as large at ({}, {}, {})", k, place.scale,
                                 place.origin.x, place.origin.y, place.origin.z));
        const Placed<Shape> body(random, place);
        const auto rays = rays_at(body, count / kBodies / std::size(places), random);
        function(body, rays, crossings<Shape>(body.row, rays), random);
        ASSERT_FALSE(testing::Test::HasFailure());
      }
  }
};

template <class List, class... Shapes>
struct Simple;
template <class... Chosen>
struct Simple<testing::Types<Chosen...>> {
  using Types = testing::Types<Chosen...>;
};
template <class... Chosen, class First, class... Others>
struct Simple<testing::Types<Chosen...>, First, Others...>
    : std::conditional_t<ShapeTraits<First>::kComposed,
                         Simple<testing::Types<Chosen...>, Others...>,
                         Simple<testing::Types<Chosen..., First>, Others...>> {};
#define ZRAKA_TYPE(Type, plural) , Type
using AllBodies = Simple<testing::Types<> ZRAKA_BODIES(ZRAKA_TYPE)>::Types;
#undef ZRAKA_TYPE

struct NameOf {
  template <class Shape>
  static std::string GetName(int) {
#define ZRAKA_IF(Type, plural) \
  if constexpr (std::is_same_v<Shape, Type>) return #Type;
    ZRAKA_BODIES(ZRAKA_IF)
#undef ZRAKA_IF
  }
};
TYPED_TEST_SUITE(Bodies, AllBodies, NameOf);

/// A property of the truth itself: all the tests below rest on it.
TYPED_TEST(Bodies, HaveTruthsWhoseGradientsAreTheirSlopesAndAtMostOne) {
  constexpr Real kStep = 1e-6L;
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const Truth<TypeParam> truth(Truth<TypeParam>::random(random, {}));
    for (int k = 0; k < 20; ++k) {
      const Point p = exact(in_cube(random)) * 2, q = exact(in_cube(random)) * 2;
      const auto slope = [&](const Point& way) {
        return (truth.residual(p + way) - truth.residual(p - way)) / (2 * kStep);
      };
      const Point slopes{slope({kStep, 0, 0}), slope({0, kStep, 0}), slope({0, 0, kStep})};
      const auto bends = [&](const Point& way) {
        return length(truth.gradient(p + way) - truth.gradient(p - way)) > 1e-3L;
      };
      if (!bends({kStep, 0, 0}) && !bends({0, kStep, 0}) && !bends({0, 0, kStep})) {
        ASSERT_LT(length(slopes - truth.gradient(p)), 1e-5L);
      }
      const Real way = length(p - q) * (1 + 1e-12L);
      ASSERT_LE(std::fabs(truth.residual(p) - truth.residual(q)), way);
      if constexpr (requires { truth.beyond(p); }) {
        ASSERT_LE(std::fabs(truth.beyond(p) - truth.beyond(q)), way);
      }
    }
  }
}

TYPED_TEST(Bodies, AreCrossedWhereTheirEquationsSayAndNowhereElse) {
#ifdef ZRAKA_SANITIZED  // is ten times as slow
  constexpr std::size_t kLeast = 10000;
#else
  constexpr std::size_t kLeast = 100000;
#endif
  // Half of the rays and more cross, and of each crossing one is made that touches.
  const std::size_t count = kLeast * (ShapeTraits<TypeParam>::kClosed ? 8 : 9) / 10;
  std::size_t all = 0, crossed = 0;
  this->each_body(ray_count(count),
                  [&](const auto& body, const auto& rays, const auto& found, Random& random) {
                    expect_crossings(body, rays, found);
                    if (this->HasFatalFailure()) return;
                    const auto touching = touching_rays(body, rays, found, random);
                    expect_crossings(body, touching, crossings<TypeParam>(body.row, touching));
                    all += rays.size() + touching.size();
                    for (const BodyCrossings& c : found) crossed += c.at[0] < HUGE_VAL;
                  });
  EXPECT_GE(all, kLeast);
  EXPECT_GT(crossed, all / 10);
}

/// Lanes with bodies of their own say what they say together.
TYPED_TEST(Bodies, AreCrossedByLanesOfManyAsByThoseOfOne) {
  Random random(2);
  std::vector<double> numbers;
  std::vector<std::int32_t> start;
  std::vector<BodyProbeRay> rays;
  std::vector<BodyCrossings> want;
  for (int k = 0; k < 1000; ++k) {
    const Placed<TypeParam> body(random, {});
    const auto some = rays_at(body, 3, random);
    const auto found = crossings<TypeParam>(body.row, some);
    start.insert(start.end(), some.size(), static_cast<std::int32_t>(numbers.size()));
    numbers.insert(numbers.end(), body.row.numbers(), body.row.numbers() + Row::kSize);
    rays.insert(rays.end(), some.begin(), some.end());
    want.insert(want.end(), found.begin(), found.end());
  }
  const auto found = crossings<TypeParam>(numbers, start, rays);
  for (std::size_t i = 0; i < rays.size(); ++i)
    ASSERT_TRUE(same_bits(found[i], want[i])) << to_string(rays[i]);
}

TYPED_TEST(Bodies, HaveTheirGradientsAsNormals) {
  std::size_t compared = 0;
  this->each_body(6000, [&](const auto& body, const auto& rays, const auto& found, Random&) {
    for (std::size_t i = 0; i < rays.size(); ++i)
      for (const Real t : finite_ones(found[i])) {
        const Ray ray = exact(rays[i]);
        if (std::fabs(t) > far_from(body, ray)) continue;
        const Point p = ray.at(t), want = normal(body.truth, p);
        const Real step = 1e-7L * body.place.scale;
        Real turn = 0;
        for (const Point& way : {Point{step, 0, 0}, Point{0, step, 0}, Point{0, 0, step}})
          turn += length(normal(body.truth, p + way) - normal(body.truth, p - way));
        const BodySurface surface = body.surface(p);
        const Point got = unit(body.row.normal_from_own(exact(vec3_of(surface.normal))));
        ASSERT_LE(length(got - want), 1e-7L + turn)
            << to_string(rays[i]) << " at " << double(t) << ": (" << double(got.x) << ", "
            << double(got.y) << ", " << double(got.z) << ")";
        ++compared;
      }
  });
  EXPECT_GT(compared, 1000u);
}

/// The first of the crossings in front, seen from the same side, with the normal that its surface
/// has there or, at an edge, as far beside it as numbers are rounded.
TYPED_TEST(Bodies, AreHitAtTheFirstCrossingWithTheNormalOfTheirSurface) {
  std::size_t compared = 0;
  this->each_body(24000, [&](const auto& body, const auto& rays, const auto& found, Random&) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const BodyCrossings& c = found[i];
      const double* const first =
          std::find_if(std::begin(c.at), std::end(c.at), [](double t) { return t > 0; });
      const double want = first == std::end(c.at) ? HUGE_VAL : *first;
      const Ray ray = exact(rays[i]);
      const Real error = body.error(ray.origin);
      // Where a ray only touches, or begins, rounding says whether there is anything.
      const auto beside = [&](double t) {
        return std::any_of(std::begin(c.at), std::end(c.at), [&](const double& other) {
          return (&other != first || t == 0) && std::fabs(other - t) < 1e-6 * body.place.scale;
        });
      };
      if (beside(want) || beside(0)) continue;
      ASSERT_TRUE(c.keeps_limits) << to_string(rays[i]) << " at " << c.first;
      if (!(want < HUGE_VAL)) {
        ASSERT_EQ(c.first, HUGE_VAL) << to_string(rays[i]);
        continue;
      }
      if (want > far_from(body, ray)) continue;
      ASSERT_NEAR(c.first, want, double(64 * error)) << to_string(rays[i]);
      const Point got{c.normal[0], c.normal[1], c.normal[2]}, p = ray.at(c.first);
      if (ShapeTraits<TypeParam>::kClosed && !std::is_same_v<TypeParam, Quadric>) {
        ASSERT_EQ(c.inside, (first - c.at) % 2 == 1) << to_string(rays[i]);
      } else if (const Real along = dot(got, ray.direction); std::fabs(along) > 1e-9L) {
        ASSERT_EQ(c.inside, along > 0) << to_string(rays[i]);
      }
      Real off = 2;
      for (int k = 0; k < 27; ++k) {
        const Point step{Real(k % 3 - 1), Real(k / 3 % 3 - 1), Real(k / 9 - 1)};
        const BodySurface there = body.surface(p + step * (8 * error));
        off = std::min(
            off, length(got - unit(body.row.normal_from_own(exact(vec3_of(there.normal))))));
      }
      ASSERT_LE(off, 1e-6L) << to_string(rays[i]) << " at " << c.first;
      ++compared;
    }
  });
  EXPECT_GT(compared, 1000u);
}

/// A step along a tangent changes u or v by as much as it is long, where they change steadily.
TYPED_TEST(Bodies, HaveTangentsAlongWhichUAndVGrow) {
  constexpr double kStep = 1e-6;
  std::size_t compared = 0, steady = 0;
  this->each_body(6000, [&](const auto& body, const auto& rays, const auto& found, Random&) {
    for (std::size_t i = 0; i < rays.size(); ++i)
      for (const Real t : finite_ones(found[i])) {
        const Ray ray = exact(rays[i]);
        if (std::fabs(t) > far_from(body, ray)) continue;
        const Point p = body.row.own(ray.at(t));
        if (length(p) > 10) continue;
        const V3<double> own{double(p.x), double(p.y), double(p.z)};
        const BodySurface s = ShapeTraits<TypeParam>::surface(body.row.own_numbers(), own);
        for (const V3<double>& along : {s.along_u, s.along_v}) {
          const double size = std::sqrt(dot(along, along) * dot(s.normal, s.normal));
          ASSERT_LE(std::fabs(dot(along, s.normal)), 1e-6 * size) << to_string(rays[i]);
        }
        if (!has_uv<TypeParam>) continue;
        // From outside, pictures are not mirrored.
        if (is_closed(body.shape)) {
          ASSERT_GE(dot(cross(s.along_u, s.along_v), s.normal), 0) << to_string(rays[i]);
        }
        const auto change = [&](const V3<double>& way) {
          const BodySurface to =
              ShapeTraits<TypeParam>::surface(body.row.own_numbers(), own + way * kStep);
          return V3<double>{(to.u - s.u) / kStep, (to.v - s.v) / kStep, 0};
        };
        const auto expect_step = [&](const V3<double>& way, double u, double v) {
          if (dot(way, way) < 1e-6) return;  // at a pole
          ++compared;
          const V3<double> ahead = change(way), behind = change(way * -1.0);
          if (v > 0 && ahead.y == 0 && behind.y == 0) return;  // on a cap it does not grow
          if (std::fabs(ahead.x + behind.x) + std::fabs(ahead.y + behind.y) > 1e-3) return;
          ++steady;
          ASSERT_NEAR(ahead.x, u, 2e-3) << to_string(rays[i]);
          ASSERT_NEAR(ahead.y, v, 2e-3) << to_string(rays[i]);
        };
        expect_step(s.along_u, 1, 0);
        expect_step(s.along_v, 0, 1);
      }
  });
  if (has_uv<TypeParam>) {
    EXPECT_GT(compared, 1000u);
    EXPECT_GT(steady, compared / 2);
  }
}

TYPED_TEST(Bodies, AreInTheirBoundsWhateverTheTransform) {
  this->each_body(24000, [&](const auto& body, const auto& rays, const auto& found,
                             Random& random) {
    const auto a = [&] { return in_cube(random); };
    const Vec3 origin = Place{body.place.scale, {}}.point(a());
    const Transform transforms[] = {{}, {a(), a(), a(), origin}};
    for (const Transform& transform : transforms) {
      Bounds box = ShapeTraits<TypeParam>::bounds(body.shape);
      if constexpr (requires { ShapeTraits<TypeParam>::bounds_under(body.shape, transform); })
        box = ShapeTraits<TypeParam>::bounds_under(body.shape, transform);
      else if (&transform != transforms)
        continue;
      if (!box.bounded()) continue;
      for (std::size_t i = 0; i < rays.size(); ++i)
        for (const Real t : finite_ones(found[i])) {
          const Ray ray = exact(rays[i]);
          const Point p = ray.at(t);
          const Point in_world = exact(transform.along_x) * p.x + exact(transform.along_y) * p.y +
                                 exact(transform.along_z) * p.z + exact(transform.origin);
          const Vec3 at{double(in_world.x), double(in_world.y), double(in_world.z)};
          ASSERT_LE(box.distance_to(at), 8 * body.error(ray.origin)) << to_string(rays[i]);
        }
    }
  });
}

/// No nearer than it is: rays find it no sooner. And never 0 where it is away.
TYPED_TEST(Bodies, AreAsFarFromPointsAsTheySayOrFarther) {
  this->each_body(24000, [&](const auto& body, const auto& rays, const auto& found, Random&) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Ray ray = exact(rays[i]);
      const Vec3 eye{rays[i].origin[0], rays[i].origin[1], rays[i].origin[2]};
      const Real distance = ShapeTraits<TypeParam>::distance_to(body.shape, eye),
                 error = body.error(ray.origin);
      for (const Real t : finite_ones(found[i]))
        ASSERT_LE(distance, std::fabs(t) + error) << to_string(rays[i]);
      const Real away =
          std::max(std::fabs(body.truth.residual(ray.origin)), beyond(body.truth, ray.origin));
      ASSERT_GE(distance, 0.2L * away - error) << to_string(rays[i]);
    }
  });
}

}  // namespace
}  // namespace truth
}  // namespace zraka
