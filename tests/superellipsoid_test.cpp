// SPDX-License-Identifier: Apache-2.0
// Superellipsoids of all exponents, pinched ones too, and the powers that they take.
#include <numbers>

#include "body_cases.hpp"

namespace zraka::truth {
namespace {

std::vector<double> many_numbers(double low, double high) {
  Random random(6);
  std::vector<double> numbers;
  for (int i = 0; i < 100000; ++i) numbers.push_back(between(low, high, random));
  return numbers;
}

TEST(DoublePower, HasItsLogarithmsRight) {
  std::vector<double> x = many_numbers(0.5, 2);
  for (const double exponent : many_numbers(-1000, 1000)) x.push_back(std::exp2(exponent));
  for (int k = 1; k < 52; ++k)
    x.push_back(1 + std::ldexp(1, -k)), x.push_back(1 - std::ldexp(1, -k));
  for (const double exact : {0x1p-1000, 0x1p-1022, 0.5, 1.0, 2.0, 0x1p1000}) x.push_back(exact);
  std::vector<double> first, found(x.size());
  for (const BodiesProbe& probe : bodies_probes()) {
    probe.log2(x.data(), found.data(), x.size());
    if (first.empty()) first = found;
    ASSERT_EQ(found, first) << name_of(probe.isa);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Real want = std::log2(Real{x[i]});
      ASSERT_LE(std::fabs(found[i] - want), 0x1p-51L * std::fabs(want)) << x[i];
    }
  }
  EXPECT_EQ(first.back(), 1000);
}

TEST(DoublePower, HasItsPowersOfTwoRight) {
  std::vector<double> x = many_numbers(-1, 1);
  for (const double exponent : many_numbers(-1000, 1000)) x.push_back(exponent);
  for (const double exact : {-1001.0, -1000.0, -0.5, 0.5, 0.0, 1.0, 1000.0}) x.push_back(exact);
  std::vector<double> first, found(x.size());
  for (const BodiesProbe& probe : bodies_probes()) {
    probe.exp2(x.data(), found.data(), x.size());
    if (first.empty()) first = found;
    ASSERT_EQ(found, first) << name_of(probe.isa);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Real want = x[i] < -1000 ? 0 : std::exp2(Real{x[i]});
      ASSERT_LE(std::fabs(found[i] - want), 0x1p-51L * want) << x[i];
    }
  }
  EXPECT_EQ(first.back(), 0x1p1000);
}

TEST(SuperellipsoidCases, AreSpheresBoxesAndOctahedra) {
  const double r3 = std::sqrt(3.0), r = 1 / r3;
  const Vec3 from{2, 2, 2}, way{-r, -r, -r};
  const auto of = [](double e, double n) { return Superellipsoid{{0, 0, 0}, {1, 1, 1}, e, n}; };
  expect_near(crossed_at(of(1, 1), from, way), {2 * r3 - 1, 2 * r3 + 1});
  expect_near(crossed_at(of(1, 1), {-3, 0, 0}, {1, 0, 0}), {2, 4});
  expect_near(crossed_at(of(2, 2), from, way), {2 * r3 - r, 2 * r3 + r});
  expect_near(crossed_at(of(2, 1), {2, 2, 0}, {-std::sqrt(0.5), -std::sqrt(0.5), 0}),
              {1.5 * std::numbers::sqrt2, 2.5 * std::numbers::sqrt2});
  // 3·x^40 = 1 of the cube that is nearly sharp.
  const double corner = r3 * std::pow(3.0, -1.0 / 40);
  expect_near(crossed_at(of(0.05, 0.05), from, way), {2 * r3 - corner, 2 * r3 + corner});
  expect_near(crossed_at(of(0.05, 0.05), {0.25, 0.125, 3}, {0, 0, -1}), {2, 4});
  expect_near(crossed_at(of(1, 1), {1.0001, 0, -3}, {0, 0, 1}), {});
  // Pinched: 3·√x = 1, and past an arm.
  expect_near(crossed_at(of(4, 4), from, way), {2 * r3 - r3 / 9, 2 * r3 + r3 / 9});
  expect_near(crossed_at(of(4, 4), {0.25, 0, -3}, {0, 0, 1}), {2.75, 3.25});
  expect_near(crossed_at(of(4, 4), {0.25, 0.25, -3}, {0, 0, 1}), {3, 3});
}

TEST(SuperellipsoidCases, OfAllExponentsUpToTwo) {
  for (const double e : {0.05, 0.1, 0.3, 1.0, 1.9, 2.0})
    for (const double n : {0.05, 0.3, 1.0, 2.0})
      expect_all_crossings(Superellipsoid{{0.1, 0.2, 0.3}, {1, 0.5, 0.75}, e, n});
  expect_all_crossings(Superellipsoid{{0, 0, 0}, {1, 1e-5, 1}, 0.5, 0.5});
}

/// Whether a ray is inside is what crossings say, at all places that are clearly so, also where the
/// norm is least or greatest between them.
void expect_pinched(const Superellipsoid& shape, std::size_t count) {
  constexpr Real kClearly = 1e-9L;
  SCOPED_TRACE(fmt::format("exponents {} and {}", shape.e, shape.n));
  Random random(5);
  const Placed<Superellipsoid> body(shape);
  std::vector<BodyProbeRay> rays = rays_at(body, count, random);
  // Along arms, and through octants.
  for (std::size_t i = 0; i < count; ++i) {
    Point from = exact(in_cube(random)) * tiny(random), to = exact(in_cube(random)) * tiny(random);
    (i % 2 == 0 ? from.x : from.y) -= 1;
    (i % 3 == 0 ? to.x : i % 3 == 1 ? to.y : to.z) += 1;
    rays.push_back(probe_ray(body.row.world(from), body.row.world(to) - body.row.world(from)));
  }
  const auto found = crossings<Superellipsoid>(body.row, rays);
  std::size_t most = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    SCOPED_TRACE(to_string(rays[i]) + " crosses " + to_string(found[i]));
    const Ray ray = exact(rays[i]);
    const std::vector<Real> at = finite_ones(found[i]);
    ASSERT_EQ(at.size() % 2, 0u);
    ASSERT_TRUE(std::is_sorted(at.begin(), at.end()));
    most = std::max(most, at.size());
    const auto norm = [&](Real t) { return body.truth.norm(ray.at(t)) - 1; };
    const auto expect_side = [&](Real t) {
      const Real value = norm(t);
      const bool inside = std::count_if(at.begin(), at.end(), [&](Real s) { return s < t; }) % 2;
      const bool near =
          std::any_of(at.begin(), at.end(), [&](Real s) { return std::fabs(s - t) < kClearly; });
      if (std::fabs(value) > kClearly && !near) {
        ASSERT_EQ(value < 0, inside) << "at " << double(t);
      }
    };
    for (const Real t : at) {  // where the norm leaps, nearly
      const Real before = norm(t - 1e-12L), after = norm(t + 1e-12L);
      const auto neighbours =
          std::count_if(at.begin(), at.end(), [&](Real s) { return std::fabs(s - t) < 1e-12L; });
      ASSERT_TRUE(before * after <= 0 || std::fabs(norm(t)) < 1e-12L || neighbours == 2)
          << "at " << double(t);
    }
    const Real middle = dot(body.middle() + exact(shape.center) - ray.origin, ray.direction);
    constexpr int kPlaces = 256;
    const auto place = [&](int k) { return middle + 1.8L * (2 * k - kPlaces) / kPlaces; };
    for (int k = 1; k < kPlaces; ++k) {
      expect_side(place(k));
      if (testing::Test::HasFatalFailure()) return;
      const Real here = norm(place(k)), before = norm(place(k - 1)), after = norm(place(k + 1));
      const Real side = here > before && here > after ? -1 : 1;
      if ((here - before) * side > 0 || (here - after) * side > 0) continue;
      Real a = place(k - 1), b = place(k + 1);
      for (int step = 0; step < 40; ++step) {
        const Real c = a + (b - a) * 0.382L, d = b - (b - a) * 0.382L;
        (norm(c) * side < norm(d) * side ? b : a) = norm(c) * side < norm(d) * side ? d : c;
      }
      expect_side((a + b) / 2);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
  EXPECT_GE(most, 4u);
}

TEST(SuperellipsoidCases, ThatArePinchedLoseNoCrossing) {
  const double exponents[][2] = {{4, 4}, {3, 3},   {2.5, 2.1}, {4, 1},
                                 {1, 4}, {0.2, 3}, {3, 0.2},   {2, 4}};
  for (const auto& [e, n] : exponents) {
    expect_pinched({{0, 0, 0}, {1, 0.5, 0.75}, e, n}, ray_count(500));
    ASSERT_FALSE(HasFailure());
  }
}

TEST(SuperellipsoidCases, AreAsFarAsTheySayOrFartherWhenPinched) {
  Random random(9);
  const Superellipsoid shape{{0, 0, 0}, {1, 0.5, 0.75}, 4, 3};
  const Placed<Superellipsoid> body(shape);
  const auto rays = rays_at(body, 2000, random);
  const auto found = crossings<Superellipsoid>(body.row, rays);
  std::size_t positive = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Vec3 eye{rays[i].origin[0], rays[i].origin[1], rays[i].origin[2]};
    const double distance = ShapeTraits<Superellipsoid>::distance_to(shape, eye);
    for (const Real t : finite_ones(found[i])) ASSERT_LE(distance, std::fabs(t) + 1e-14L);
    positive += distance > 0;
  }
  EXPECT_GT(positive, rays.size() * 9 / 10);
  EXPECT_NEAR(ShapeTraits<Superellipsoid>::distance_to(shape, {2, 0, 0}), 1, 1e-12);
}

TEST(SuperellipsoidCases, AreCheckedInWords) {
  const Vec3 one{1, 1, 1};
  expect_problem(Superellipsoid{{kNan, 0, 0}, one, 1, 1}, "its centre is not finite");
  expect_problem(Superellipsoid{{0, 0, 0}, {1, 0, 1}, 1, 1},
                 "its radii are not finite numbers above 0");
  expect_problem(Superellipsoid{{0, 0, 0}, one, 4.5, 1}, "its exponents are not from 0.05 to 4");
  expect_problem(Superellipsoid{{0, 0, 0}, one, 1, kNan}, "its exponents are not from 0.05 to 4");
  expect_problem(Superellipsoid{{0, 0, 0}, one, 0.05, 4}, nullptr);
}

}  // namespace
}  // namespace zraka::truth
