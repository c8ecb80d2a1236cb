// SPDX-License-Identifier: Apache-2.0
// The engine against the shapes' textbook equations, for every kind of shape, by every instruction
// set: hits lie on them, normals are their gradients, and nothing nearer was missed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "truth/crowd.hpp"

namespace zraka::truth {
namespace {

/// As it is, 10^±6 times as large, and 10^6 away.
const Place kPlaces[] = {
    {}, {1e6, {}}, {1e-6, {}}, {1, {1e6, -2e6, 3e6}}, {1e6, {-1e12, 1e12, 0}}, {1e-6, {1, 1, -1}}};

template <class Kind>
class TruthOf : public testing::Test {
 protected:
  /// Calls function(crowd, numbers) for crowds in all places.
  template <class Function>
  void each_crowd(const Function& function) {
    for (const Place& place : kPlaces)
      for (unsigned seed = 1; seed <= 3; ++seed) {
        const Crowd<Kind> crowd(place, seed);
        ASSERT_EQ(crowd.count(), Crowd<Kind>::kShapes) << "the engine takes them for another kind";
        for (const Numbers numbers : {Numbers::floats, Numbers::doubles}) {
          SCOPED_TRACE(fmt::format("{} times as large at ({}, {}, {}), seed {}, {}", place.scale,
                                   place.origin.x, place.origin.y, place.origin.z, seed,
                                   numbers == Numbers::floats ? "floats" : "doubles"));
          function(crowd, numbers);
        }
      }
  }
};

template <class... Kinds>
struct After;
template <class First, class... Others>
struct After<First, Others...> {
  using Types = testing::Types<Others...>;
};
#define ZRAKA_TYPE(Type, plural) , Type
using AllKinds = After<void ZRAKA_INLINED_KINDS(ZRAKA_TYPE)>::Types;
#undef ZRAKA_TYPE

struct NameOf {
  template <class Kind>
  static std::string GetName(int) {
#define ZRAKA_IF(Type, plural) \
  if constexpr (std::is_same_v<Kind, Type>) return #Type;
    ZRAKA_INLINED_KINDS(ZRAKA_IF)
#undef ZRAKA_IF
  }
};
TYPED_TEST_SUITE(TruthOf, AllKinds, NameOf);

/// A property of the truth itself: all the tests below rest on it.
TYPED_TEST(TruthOf, HasGradientsThatAreItsSlopesAndAtMostOne) {
  using Shape = Truth<TypeParam>;
  constexpr Real kStep = 1e-6L;
  Random random(7);
  const auto anywhere = [&] { return exact(in_cube(random)) * 2; };
  for (int i = 0; i < 200; ++i) {
    const Shape truth(Shape::random(random, {}));
    for (int k = 0; k < 20; ++k) {
      const Point p = anywhere(), q = anywhere();
      const auto slope = [&](const Point& way) {
        return (truth.residual(p + way) - truth.residual(p - way)) / (2 * kStep);
      };
      const Point slopes{slope({kStep, 0, 0}), slope({0, kStep, 0}), slope({0, 0, kStep})};
      ASSERT_LT(length(slopes - truth.gradient(p)), 1e-5L);
      const Real way = length(p - q) * (1 + 1e-12L);
      ASSERT_LE(std::fabs(truth.residual(p) - truth.residual(q)), way);
      if constexpr (requires { truth.beyond(p); }) {
        ASSERT_LE(std::fabs(truth.beyond(p) - truth.beyond(q)), way);
      }
    }
  }
}

TYPED_TEST(TruthOf, HitsLieOnTheSurfaceAndNothingNearerIsMissed) {
  this->each_crowd([](const Crowd<TypeParam>& crowd, Numbers numbers) {
    const std::vector<ProbeRay> rays = crowd.rays(numbers);
    const std::vector<ProbeSurface> found = crowd.trace(rays, numbers);
    std::size_t hits = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Ray ray = crowd.world(rays[i]);
      const Real error = crowd.error(rays[i], numbers), end = crowd.end(ray, found[i]);
      for (const auto& truth : crowd.truths)
        ASSERT_FALSE(Passage(truth, ray, error).before(end))
            << "ray " << i << " goes through shape " << &truth - crowd.truths.data();
      if (found[i].id < 0) continue;
      ++hits;
      const auto& truth = crowd.truth_of(found[i]);
      ASSERT_LE(std::fabs(truth.residual(ray.at(end))), error) << "ray " << i;
      ASSERT_LE(beyond(truth, ray.at(end)), error) << "ray " << i;
    }
    EXPECT_GT(hits, rays.size() / 5);
  });
}

TYPED_TEST(TruthOf, BoundsContainAllHits) {
  this->each_crowd([](const Crowd<TypeParam>& crowd, Numbers numbers) {
    if (numbers == Numbers::doubles) return;  // they have no hierarchy
    const auto expect_within = [](const double* p, const auto& lower, const auto& upper,
                                  double margin, std::int32_t id) {
      for (int k = 0; k < 3; ++k) {
        EXPECT_GE(p[k], lower[k] - margin) << "shape " << id << ", axis " << k;
        EXPECT_LE(p[k], upper[k] + margin) << "shape " << id << ", axis " << k;
      }
    };
    const std::vector<ProbeRay> rays = crowd.rays(numbers);
    const std::vector<ProbeSurface> found = crowd.trace(rays, numbers);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (found[i].id < 0) continue;
      const auto id = static_cast<std::size_t>(found[i].id);
      double met[3];
      for (int k = 0; k < 3; ++k) met[k] = rays[i].origin[k] + found[i].t * rays[i].direction[k];
      expect_within(met, crowd.boxes[id].lower, crowd.boxes[id].upper, 0, found[i].id);
      const Bounds box =
          ShapeTraits<std::decay_t<decltype(crowd.shapes[id])>>::bounds(crowd.shapes[id]);
      const Point in_world = crowd.world(met);
      const double point[] = {static_cast<double>(in_world.x), static_cast<double>(in_world.y),
                              static_cast<double>(in_world.z)};
      const double lower[] = {box.lower.x, box.lower.y, box.lower.z},
                   upper[] = {box.upper.x, box.upper.y, box.upper.z};
      expect_within(point, lower, upper, static_cast<double>(crowd.error(rays[i], numbers)),
                    found[i].id);
    }
  });
}

TYPED_TEST(TruthOf, SurfacesHaveTheirPointNormalAndSide) {
  this->each_crowd([](const Crowd<TypeParam>& crowd, Numbers numbers) {
    const std::vector<ProbeRay> rays = crowd.rays(numbers);
    const std::vector<ProbeSurface> found = crowd.trace(rays, numbers);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (found[i].id < 0) continue;
      const auto& truth = crowd.truth_of(found[i]);
      const Point point = crowd.world(found[i].point);
      const Real offset = crowd.offset(found[i], numbers);
      ASSERT_LE(std::fabs(truth.residual(point)), offset / 2) << "ray " << i;

      // How far the normal turns from one side of the offset to the other, and how far it would if
      // the shape's finest detail moved by the offset.
      const Point want = normal(truth, point), got = exact(found[i].normal);
      Real tolerance = offset / crowd.place.length(kFinest);
      for (const Point& way : {Point{offset, 0, 0}, Point{0, offset, 0}, Point{0, 0, offset}})
        tolerance += length(normal(truth, point + way) - normal(truth, point - way));
      ASSERT_LE(length(got - want), tolerance / 2) << "ray " << i;

      ASSERT_GT(truth.residual(point + got * offset), 0) << "ray " << i << " starts inside";
      ASSERT_LT(truth.residual(point - got * offset), 0) << "ray " << i << " starts outside";
      // Of a smooth face, whose normal may look past the viewer, the face says which side it is.
      const Real facing = dot(unit(truth.gradient(point)), crowd.world(rays[i]).direction);
      if (std::fabs(facing) > 0.01L) {
        ASSERT_EQ(found[i].inside, facing > 0) << "ray " << i;
      }
    }
  });
}

TYPED_TEST(TruthOf, RaysLeaveTheSurfaceThatTheyStartFrom) {
  this->each_crowd([](const Crowd<TypeParam>& crowd, Numbers numbers) {
    const std::vector<ProbeRay> rays = crowd.rays(numbers);
    const std::vector<ProbeSurface> from = crowd.trace(rays, numbers);
    Random random(3);
    std::vector<ProbeRay> leaving;
    struct Start {
      std::int32_t shape;
      Real side, offset;
    };
    std::vector<Start> starts;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (from[i].id < 0) continue;
      const Real side = from[i].inside ? -1 : 1;
      const Vec3 way = on_unit_sphere(random);
      const Real up = side * dot(unit(crowd.truth_of(from[i]).gradient(crowd.world(from[i].point))),
                                 exact(way));
      if (std::fabs(up) < 0.1L) continue;
      leaving.push_back(
          crowd.leave(from[i], side, up > 0 ? way : Vec3{-way.x, -way.y, -way.z}, numbers));
      starts.push_back({from[i].id, side, crowd.offset(from[i], numbers)});
    }
    const std::vector<ProbeSurface> found = crowd.trace(leaving, numbers);
    for (std::size_t i = 0; i < leaving.size(); ++i) {
      const Ray ray = crowd.world(leaving[i]);
      const Real error = crowd.error(leaving[i], numbers), end = crowd.end(ray, found[i]);
      for (const auto& truth : crowd.truths)
        ASSERT_FALSE(Passage(truth, ray, error).before(end))
            << "ray " << i << " goes through shape " << &truth - crowd.truths.data();
      const auto& [shape, side, offset] = starts[i];
      if (found[i].id != shape) continue;
      // It may meet the same shape elsewhere, but there it also comes out on the other side.
      const auto& truth = crowd.truth_of(found[i]);
      Real least = offset;
      for (int k = 1; k <= 32; ++k)
        least = std::min(least, side * truth.residual(ray.at(end * k / 16)));
      ASSERT_LT(least, offset / 4) << "ray " << i << " meets where it came from";
    }
  });
}

}  // namespace
}  // namespace zraka::truth
