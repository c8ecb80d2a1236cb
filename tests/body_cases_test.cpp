// SPDX-License-Identifier: Apache-2.0
// Bodies where formulas go wrong: crossings that are known, shapes that are almost none, and what
// is no shape.
#include "body_cases.hpp"

#include <numbers>
#include <utility>

namespace zraka::truth {
namespace {

TEST(BoxCases, AreCrossedAlongFacesAndEdges) {
  const Box box{{-1, -2, -3}, {1, 2, 3}};
  expect_near(crossed_at(box, {0, 0, -10}, {0, 0, 1}), {7, 13});
  expect_near(crossed_at(box, {1, 0, -10}, {0, 0, 1}), {7, 13});
  expect_near(crossed_at(box, {1, -2, 10}, {0, 0, -1}), {7, 13});
  expect_near(crossed_at(box, {1.0000001, 0, -10}, {0, 0, 1}), {});
  expect_near(crossed_at(box, {0.25, 0, 0}, {-1, 0, 0}), {-0.75, 1.25});
  // The corner is nearer where it is round: by (√3 - 1)·0.5.
  const double r = 1 / std::sqrt(3.0), to_corner = std::sqrt(3.0);
  const Box cube{{-1, -1, -1}, {1, 1, 1}}, round{{-1, -1, -1}, {1, 1, 1}, 0.5};
  expect_near(crossed_at(cube, {2, 2, 2}, {-r, -r, -r}), {to_corner, 3 * to_corner});
  const double rounded = (to_corner - 1) / 2;
  expect_near(crossed_at(round, {2, 2, 2}, {-r, -r, -r}),
              {to_corner + rounded, 3 * to_corner - rounded});
  expect_near(crossed_at(round, {0.75, 3, 0.25}, {0, -1, 0}),
              {2.5 - std::sqrt(0.1875), 3.5 + std::sqrt(0.1875)});
}
TEST(BoxCases, WithRoundEdgesFromAHairToABall) {
  expect_all_crossings(Box{{-1, -1, -1}, {1, 1, 1}, 1});
  expect_all_crossings(Box{{-1, -0.5, -1}, {1, 0.5, 1}, 0.5});
  expect_all_crossings(Box{{-1, -0.25, -0.25}, {1, 0.25, 0.25}, 0.25});
  expect_all_crossings(Box{{-1, -0.5, -0.75}, {1, 0.5, 0.75}, 1e-9});
  expect_all_crossings(Box{{-1, -1e-6, -0.75}, {1, 1e-6, 0.75}, 1e-7});
  expect_all_crossings(Box{{-1, -1e-6, -0.75}, {1, 1e-6, 0.75}});
}
TEST(BoxCases, HavePicturesUprightOnEveryFace) {
  const auto uv = [](const V3<double>& p) { return uv_at(Box{{-1, -1, -1}, {1, 1, 1}}, p); };
  EXPECT_EQ(uv({0.5, -0.5, 1}), std::pair(0.75, 0.25));
  EXPECT_EQ(uv({0.5, -0.5, -1}), std::pair(0.25, 0.25));
  EXPECT_EQ(uv({1, -0.5, 0.5}), std::pair(0.25, 0.25));
  EXPECT_EQ(uv({-1, -0.5, 0.5}), std::pair(0.75, 0.25));
  EXPECT_EQ(uv({0.5, 1, 0.5}), std::pair(0.75, 0.25));
  EXPECT_EQ(uv({0.5, -1, 0.5}), std::pair(0.75, 0.75));
}
TEST(BodyCases, HaveUAroundAndVFromBelow) {
  const Frustum frustum{{0, -1, 0}, 1, {0, 1, 0}, 0.5};
  EXPECT_EQ(uv_at(frustum, {0, -1, 1}), std::pair(0.5, 0.0));
  EXPECT_EQ(uv_at(frustum, {0.75, 0, 0}), std::pair(0.75, 0.5));
  EXPECT_EQ(uv_at(frustum, {-0.5, 1, 0}), std::pair(0.25, 1.0));
  const Capsule capsule{{0, -1, 0}, {0, 1, 0}, 1};
  EXPECT_EQ(uv_at(capsule, {0, -1, 0}), std::pair(0.5, 0.0));
  EXPECT_EQ(uv_at(capsule, {0.5, 0, 0}), std::pair(0.75, 0.5));
  EXPECT_EQ(uv_at(capsule, {0, 1, 0}), std::pair(0.5, 1.0));
  EXPECT_NEAR(uv_at(capsule, {0, 0.5, 0.5}).second, 0.5 + 1 / (2 + std::numbers::pi), 1e-15);
  const Torus torus{{0, 0, 0}, {0, 1, 0}, 1, 0.25};
  EXPECT_EQ(uv_at(torus, {0, 0, 1.25}), std::pair(0.5, 0.5));
  EXPECT_EQ(uv_at(torus, {1, 0.25, 0}), std::pair(0.75, 0.75));
  EXPECT_EQ(uv_at(torus, {-1, -0.25, 0}), std::pair(0.25, 0.25));
  const Disc disc{{0, 0, 0}, {0, 1, 0}, 1, 0.5};
  EXPECT_EQ(uv_at(disc, {0, 0, 1}), std::pair(0.5, 1.0));
  EXPECT_EQ(uv_at(disc, {0.75, 0, 0}), std::pair(0.75, 0.5));
  const Parallelogram parallelogram{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  EXPECT_EQ(uv_at(parallelogram, {-1, -0.5, 0}), std::pair(0.0, 0.25));
}
TEST(BoxCases, AreCheckedInWords) {
  expect_problem(Box{{0, 0, 0}, {1, 1, kNan}}, "a corner is not finite");
  expect_problem(Box{{0, 0, 0}, {1, 0, 1}}, "its max is not above its min along every axis");
  expect_problem(Box{{0, 0, 0}, {1, 1, 1}, -1}, "its radius is not a finite number of 0 or more");
  expect_problem(Box{{0, 0, 0}, {1, 2, 3}, 0.6}, "its radius is more than half its shortest side");
  expect_problem(Box{{0.1, 0, 0}, {0.3, 1, 1}, 0.1}, nullptr);
}

TEST(FrustumCases, AreCrossedAlongAndThroughTheAxis) {
  const Frustum cone{{0, 0, 0}, 1, {0, 2, 0}, 0};
  expect_near(crossed_at(cone, {0, -3, 0}, {0, 1, 0}), {3, 5});
  expect_near(crossed_at(cone, {0.5, -3, 0}, {0, 1, 0}), {3, 4});
  expect_near(crossed_at(cone, {-5, 1, 0}, {1, 0, 0}), {4.5, 5.5});
  const double s = 1 / std::sqrt(5.0);  // parallel to the side, and on it
  expect_near(crossed_at(cone, {0.5, 0, 0}, {s, -2 * s, 0}), {-0.75 * std::sqrt(5.0), 0});
  const Frustum open{{0, 0, 0}, 1, {0, 2, 0}, 0, false};
  expect_near(crossed_at(open, {0.5, -3, 0}, {0, 1, 0}), {4});
  const Frustum pipe{{0, 0, 0}, 1, {0, 2, 0}, 1, false};
  expect_near(crossed_at(pipe, {0.5, -3, 0}, {0, 1, 0}), {});
  expect_near(crossed_at(pipe, {-5, 1, 0}, {1, 0, 0}), {4, 6});
}
TEST(FrustumCases, FromNeedlesToCoins) {
  for (const bool caps : {true, false}) {
    expect_all_crossings(Frustum{{0, -1, 0}, 1e-5, {0, 1, 0}, 1e-5, caps});
    expect_all_crossings(Frustum{{0, -1, 0}, 1e-4, {0, 1, 0}, 0, caps});
    expect_all_crossings(Frustum{{0, 0, 0}, 1, {0, 1e-6, 0}, 0.5, caps});
    expect_all_crossings(Frustum{{0, 0, 0}, 1, {0, 1e-6, 0}, 0, caps});
    expect_all_crossings(Frustum{{-0.5, 0, 0}, 0.5, {0.5, 0, 0}, 0.5 + 1e-12, caps});
  }
}
TEST(FrustumCases, AreCheckedInWords) {
  expect_problem(Frustum{{0, 0, 0}, 1, {0, kNan, 0}}, "an end is not finite");
  expect_problem(Frustum{{0, 0, 0}, 0, {0, 1, 0}, 0},
                 "its radii are not finite numbers of 0 or more, one of them more");
  expect_problem(Frustum{{0, 0, 0}, -1, {0, 1, 0}, 1},
                 "its radii are not finite numbers of 0 or more, one of them more");
  expect_problem(Frustum{{1, 2, 3}, 1, {1, 2, 3}, 1}, "its ends are one point");
  EXPECT_STREQ(ShapeTraits<Frustum>::check_member({{0, 0, 0}, 1, {0, 1, 0}, 1, false}),
               "without caps it has no inside");
}

TEST(TorusCases, HaveFourCrossingsThroughTheHole) {
  const Torus torus{{0, 0, 0}, {0, 1, 0}, 1, 0.25};
  expect_near(crossed_at(torus, {-2, 0, 0}, {1, 0, 0}), {0.75, 1.25, 2.75, 3.25});
  expect_near(crossed_at(torus, {0, 0, 0}, {0, 0, -1}), {-1.25, -0.75, 0.75, 1.25});
  expect_near(crossed_at(torus, {0, 5, 0}, {0, -1, 0}), {});
  expect_near(crossed_at(torus, {1, 5, 0}, {0, -1, 0}), {4.75, 5.25});
  // Inside of the hole's edge, along it: through the tube on both sides.
  const double half = std::sqrt(1.25 * 1.25 - 0.75 * 0.75);
  expect_near(crossed_at(torus, {0, 0, 0.7499}, {1, 0, 0}),
              {-std::sqrt(1.25 * 1.25 - 0.7499 * 0.7499), -std::sqrt(0.75 * 0.75 - 0.7499 * 0.7499),
               std::sqrt(0.75 * 0.75 - 0.7499 * 0.7499), std::sqrt(1.25 * 1.25 - 0.7499 * 0.7499)});
  const auto touching = crossed_at(torus, {0, 0, 0.75}, {1, 0, 0});
  ASSERT_EQ(touching.size() % 2, 0u);
  EXPECT_NEAR(double(touching.front()), -half, 1e-14);
  EXPECT_NEAR(double(touching.back()), half, 1e-14);
  // On its top circle, which a level ray at 1/4 touches twice.
  EXPECT_EQ(crossed_at(torus, {-2, 0.25, 0.5}, {1, 0, 0}).size() % 2, 0u);
}
TEST(TorusCases, FromWiresToThoseWithoutAHole) {
  for (const double tube : {1e-7, 1e-5, 1e-3, 0.5, 1 - 1e-9, 1.0})
    expect_all_crossings(Torus{{0, 0, 0}, {0, 1, 0}, 1, tube});
  expect_all_crossings(Torus{{0.1, 0.2, 0.3}, {1e-9, 1, 1e-5}, 0.5, 0.25});
}
TEST(TorusCases, AreCheckedInWords) {
  expect_problem(Torus{{0, 0, kNan}}, "its centre is not finite");
  expect_problem(Torus{{0, 0, 0}, {0, 0, 0}}, "its normal is 0");
  expect_problem(Torus{{0, 0, 0}, {0, 1, 0}, 0, 1}, "its radii are not finite numbers above 0");
  expect_problem(Torus{{0, 0, 0}, {0, 1, 0}, 1, 1.25}, "its tube_radius is more than its radius");
}

TEST(DiscCases, AreCrossedBetweenTheirCircles) {
  const Disc ring{{0, 1, 0}, {0, 3, 0}, 1, 0.5};
  expect_near(crossed_at(ring, {0.75, 5, 0}, {0, -1, 0}), {4});
  expect_near(crossed_at(ring, {0, 0, 0.5}, {0, 1, 0}), {1});
  expect_near(crossed_at(ring, {0, 0, -1}, {0, 1, 0}), {1});
  expect_near(crossed_at(ring, {0, 0, 0.49999}, {0, 1, 0}), {});
  expect_near(crossed_at(ring, {0, 0, 1.00001}, {0, 1, 0}), {});
  expect_near(crossed_at(ring, {-5, 1, 0}, {1, 0, 0}), {});
  expect_near(crossed_at(Disc{{0, 1, 0}, {0, 3, 0}, 1, 0}, {0, 0, 0}, {0, 1, 0}), {1});
  expect_all_crossings(Disc{{0, 0, 0}, {1, 1e-9, 1}, 1, 1 - 1e-6});
}
TEST(DiscCases, AreCheckedInWords) {
  expect_problem(Disc{{kNan, 0, 0}}, "its centre is not finite");
  expect_problem(Disc{{0, 0, 0}, {0, kNan, 0}}, "its normal is not finite");
  expect_problem(Disc{{0, 0, 0}, {0, 0, 0}}, "its normal is 0");
  expect_problem(Disc{{0, 0, 0}, {0, 1, 0}, 0}, "its radius is not a finite number above 0");
  expect_problem(Disc{{0, 0, 0}, {0, 1, 0}, 1, 1},
                 "its inner_radius is not 0 or more and less than its radius");
}

TEST(ParallelogramCases, AreCrossedBetweenTheirEdges) {
  const Parallelogram s{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}};
  expect_near(crossed_at(s, {1, 0.5, 3}, {0, 0, -1}), {3});
  expect_near(crossed_at(s, {0, 0, -1}, {0, 0, 1}), {1});
  expect_near(crossed_at(s, {0.49, 0.5, -1}, {0, 0, 1}), {});
  expect_near(crossed_at(s, {2.49, 0.5, -1}, {0, 0, 1}), {1});
  expect_near(crossed_at(s, {-5, 0.5, 0}, {1, 0, 0}), {});
  expect_all_crossings(Parallelogram{{0, 0, 0}, {1, 0, 0}, {0, 1e-7, 0}});
  expect_all_crossings(Parallelogram{{0, 0, 0}, {1, 0, 0}, {1, 1e-5, 0}});
}
TEST(ParallelogramCases, AreCheckedInWords) {
  expect_problem(Parallelogram{{kNan, 0, 0}}, "its corner is not finite");
  expect_problem(Parallelogram{{0, 0, 0}, {kNan, 0, 0}}, "an edge is not finite");
  expect_problem(Parallelogram{{0, 0, 0}, {0, 0, 0}}, "an edge is 0");
  expect_problem(Parallelogram{{0, 0, 0}, {1, 2, 3}, {-0.1, -0.2, -0.3}}, "its edges are parallel");
}

TEST(CapsuleCases, AreCrossedAtSideAndEnds) {
  const Capsule s{{0, -1, 0}, {0, 1, 0}, 0.5};
  expect_near(crossed_at(s, {0, -5, 0}, {0, 1, 0}), {3.5, 6.5});
  expect_near(crossed_at(s, {-5, 0, 0}, {1, 0, 0}), {4.5, 5.5});
  expect_near(crossed_at(s, {-5, 1, 0}, {1, 0, 0}), {4.5, 5.5});
  expect_near(crossed_at(s, {0.3, 5, 0}, {0, -1, 0}), {3.6, 6.4});
  expect_near(crossed_at(s, {-5, 1.3, 0}, {1, 0, 0}), {4.6, 5.4});
  expect_near(crossed_at(s, {-5, 1.50001, 0}, {1, 0, 0}), {});
}
TEST(CapsuleCases, FromHairsToBalls) {
  expect_all_crossings(Capsule{{-1, 0, 0}, {1, 0, 0}, 1e-6});
  expect_all_crossings(Capsule{{0, 0, 0}, {0, 0, 1e-9}, 1});
  expect_all_crossings(Capsule{{0, 0, 0}, {0, 1e-3, 0}, 1e-3});
}
TEST(CapsuleCases, AreCheckedInWords) {
  expect_problem(Capsule{{0, 0, kNan}}, "an end is not finite");
  expect_problem(Capsule{{0, 0, 0}, {0, 1, 0}, 0}, "its radius is not a finite number above 0");
  expect_problem(Capsule{{0, 1, 0}, {0, 1, 0}}, "its ends are one point");
}

/// x²·a + y²·b + z²·c + k in the cube from -1 to 1.
Quadric quadric(double a, double b, double c, double k) {
  return {{a, b, c, 0, 0, 0, 0, 0, 0, k}, {-1, -1, -1}, {1, 1, 1}};
}
TEST(QuadricCases, AreCrossedWithinTheirBoxAlone) {
  expect_near(crossed_at(quadric(1, 1, 1, -1), {0, 0, -3}, {0, 0, 1}), {2, 4});
  expect_near(crossed_at(quadric(1, 1, 1, -2), {0, 0, -3}, {0, 0, 1}), {});
  expect_near(crossed_at(quadric(1, 1, 1, -2), {-3, 0, 0.75}, {1, 0, 0}), {});
  expect_near(crossed_at(quadric(1, 1, 0, -0.25), {-3, 0, 0.75}, {1, 0, 0}), {2.5, 3.5});
  expect_near(crossed_at(quadric(1, 1, 0, -0.25), {-3, 0, 1.25}, {1, 0, 0}), {});
  expect_near(crossed_at(quadric(1, 1, 0, -0.25), {0, 0, -3}, {0, 0, 1}), {});
  // A cone, along its side and through its apex, and one sheet of two.
  expect_near(crossed_at(quadric(1, 0, -1, 0), {0.5, 0, 0}, {std::sqrt(0.5), 0, std::sqrt(0.5)}),
              {-std::sqrt(0.125)});
  expect_near(crossed_at(quadric(1, 1, -1, 0), {-3, 0, 0}, {1, 0, 0}), {3, 3});
  expect_near(crossed_at(quadric(-1, -1, 1, -0.25), {0, 0, -3}, {0, 0, 1}), {2.5, 3.5});
  const Quadric bowl{{1, 1, 0, 0, 0, 0, 0, 0, -1, 0}, {-1, -1, -0.5}, {1, 1, 0.5}};
  expect_near(crossed_at(bowl, {0.5, 0, -3}, {0, 0, 1}), {3.25});
  expect_near(crossed_at(bowl, {0.75, 0, -3}, {0, 0, 1}), {});
}
TEST(QuadricCases, FarFromTheOriginAreWhatTheyAre) {
  // (x - 10^6)² + y² + z² = 1/4
  const Quadric far{
      {1, 1, 1, 0, 0, 0, -2e6, 0, 0, 1e12 - 0.25}, {1e6 - 1, -1, -1}, {1e6 + 1, 1, 1}};
  expect_near(crossed_at(far, {1e6, 0, -3}, {0, 0, 1}), {2.5, 3.5});
  EXPECT_NEAR(ShapeTraits<Quadric>::distance_to(far, {1e6, 0, 0}), 0.5, 1e-9);
  expect_all_crossings(quadric(1, 1e-6, 1, -0.25));
  expect_all_crossings(quadric(1e6, 1, 1, -0.5));
}
TEST(QuadricCases, HaveAnInsideWhereTheBoxHoldsTheirSurface) {
  const auto member = [](const Quadric& s) { return ShapeTraits<Quadric>::check_member(s); };
  constexpr const char* kCut = "its box cuts its surface off, so it has no inside";
  EXPECT_STREQ(member(Quadric{}), nullptr);
  EXPECT_STREQ(member(quadric(1, 1, 1, -1)), nullptr);
  EXPECT_STREQ(member(quadric(1, 2, 3, -0.9)), nullptr);
  EXPECT_STREQ(member(quadric(1, 1, 1, -1.000001)), kCut);
  EXPECT_STREQ(member(quadric(1, 1, 0, -0.25)), kCut);
  EXPECT_STREQ(member(quadric(1, 1, -1, -0.25)), kCut);
  EXPECT_STREQ(member(quadric(-1, -1, -1, 0.25)), kCut);
  // An ellipsoid outside of the box, and one that is longest across it.
  EXPECT_STREQ(member({{1, 1, 1, 0, 0, 0, -6, 0, 0, 8}, {-1, -1, -1}, {1, 1, 1}}), kCut);
  EXPECT_STREQ(member({{1, 1, 1, 1.9, 0, 0, 0, 0, 0, -0.05}, {-1, -1, -1}, {1, 1, 1}}), nullptr);
  EXPECT_STREQ(member({{1, 1, 1, 1.99, 0, 0, 0, 0, 0, -0.05}, {-1, -1, -1}, {1, 1, 1}}), kCut);
}
/// Σ weight·(x - middle)² = square, in the cube from -1 to 1.
Quadric ellipsoid_at(const double (&middle)[3], const double (&weights)[3], double square) {
  Quadric s = quadric(weights[0], weights[1], weights[2], -square);
  for (std::size_t k = 0; k < 3; ++k) {
    s.coefficients[6 + k] = -2 * weights[k] * middle[k];
    s.coefficients[9] += weights[k] * middle[k] * middle[k];
  }
  return s;
}
TEST(QuadricCases, HaveNoInsideWhereTheyComeThroughAFaceAnywhere) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      double middle[3] = {0.2, 0.2, 0.2}, weights[3] = {1, 1, 1};
      middle[axis] = 0.3 * side;
      weights[(axis + 1) % 3] = 4;
      for (const double square : {0.489, 0.491}) {
        const bool through = square > 0.49;
        const Quadric s = ellipsoid_at(middle, weights, square);
        EXPECT_EQ(ShapeTraits<Quadric>::check_member(s) != nullptr, through) << axis << side;
      }
    }
}
TEST(QuadricCases, HaveAnInsideWhereTheirFacesAreOutside) {
  Random random(8);
  int open = 0, closed = 0;
  for (int i = 0; i < 1000; ++i) {
    Quadric s = Truth<Quadric>::random(random, {});
    const Vec3 way = in_cube(random);
    const auto move = [&](Vec3& p) { p = {p.x + way.x / 5, p.y + way.y / 5, p.z + way.z / 5}; };
    move(s.min), move(s.max);
    const Truth<Quadric> truth(s);
    Real least = HUGE_VALL;
    for (int face = 0; face < 6; ++face)
      for (int k = 0; k < 400; ++k) {
        Real q[3] = {k / 20 / 9.5L - 1, k % 20 / 9.5L - 1, face % 2 == 0 ? 1.0L : -1.0L};
        std::rotate(q, q + face / 2, q + 3);
        const Point p{q[0] * truth.half.x, q[1] * truth.half.y, q[2] * truth.half.z};
        least = std::min(least, truth.residual(truth.middle + p));
      }
    const bool inside = ShapeTraits<Quadric>::check_member(s) == nullptr;
    ASSERT_FALSE(inside && least < -1e-15L) << i;
    ASSERT_FALSE(!inside && least > 0.01L && truth.residual(truth.middle) < 0) << i;
    (inside ? closed : open) += 1;
  }
  EXPECT_GT(open, 300);
  EXPECT_GT(closed, 100);
}
TEST(QuadricCases, AreCheckedInWords) {
  expect_problem(quadric(1, kNan, 1, -1), "a coefficient is not finite");
  expect_problem(quadric(0, 0, 0, -1), "its coefficients but the last are 0");
  expect_problem(Quadric{quadric(1, 1, 1, -1).coefficients, {0, 0, 0}, {1, kNan, 1}},
                 "a corner of its box is not finite");
  expect_problem(Quadric{quadric(1, 1, 1, -1).coefficients, {0, 0, 0}, {1, 0, 1}},
                 "its max is not above its min along every axis");
}

}  // namespace
}  // namespace zraka::truth
