// SPDX-License-Identifier: Apache-2.0
// Attenuated lights and spots in the lean engine: closed forms, and what the general engine makes
// of them.
#include <gtest/gtest.h>

#include <cmath>
#include <zraka/explain.hpp>

#include "picture_of.hpp"
#include "render/isa.hpp"
#include "render/prepare.hpp"
#include "scenes.hpp"

namespace zraka {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

/// A white wall at z = 0, seen along the z axis through a small window, and a light before it.
Scene lit_wall(const Light& light) {
  Scene scene;
  scene.resolution = {5, 5};
  scene.camera = {{0, 0, 10}, {0, 0, 0}, {0.001, 0, 0}, {0, 0.001, 0}};
  scene.materials = {{.ambient = {}, .diffuse = {1, 1, 1}}};
  scene.parallelograms.push_back({Parallelogram{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, 0});
  scene.lights = {light};
  return scene;
}

/// Straight before the wall, with its axis turned away from it.
Light spot_turned(double degrees, double inner, double outer, bool linear = false) {
  Light spot;
  spot.kind = LightKind::spot;
  spot.position = {0, 0, 5};
  spot.direction = {std::sin(degrees * kDegree), 0, -std::cos(degrees * kDegree)};
  spot.inner_deg = inner, spot.outer_deg = outer, spot.linear_edge = linear;
  return spot;
}

double middle_of(const Scene& scene, Isa isa) {
  RenderOptions options;
  EXPECT_FALSE(needs_general_engine(scene, options));
  options.isa = isa;
  const Image image = picture_of(scene, options);
  return static_cast<double>(image.row(2)[3 * 2]);
}

/// Calls test(isa) for all of them and the oracle.
template <class Test>
void by_each_isa(const Test& test) {
  for (const Isa isa : available_isas()) test(isa);
  test(Isa::oracle);
}

TEST(Fading, IsByTheDistance) {
  by_each_isa([](Isa isa) {
    for (const Vec3& a : {Vec3{1, 0.5, 0.25}, Vec3{0, 0, 1}, Vec3{2, 0, 0}, Vec3{0, 0.1, 0}})
      for (const double d : {0.25, 1.0, 3.0, 9.5}) {
        Light light;
        light.position = {0, 0, d};
        light.attenuation = a;
        const double wanted = 1 / (a.x + a.y * d + a.z * d * d);
        EXPECT_NEAR(middle_of(lit_wall(light), isa), wanted, 2e-6 * wanted)
            << name_of(isa) << " at " << d;
      }
  });
}

TEST(Fading, HasASmoothEdge) {
  by_each_isa([](Isa isa) {
    const auto at = [&](double degrees, double inner, double outer) {
      return middle_of(lit_wall(spot_turned(degrees, inner, outer)), isa);
    };
    const double cones[][2] = {{20, 40}, {0, 89}, {0.02, 0.05}, {100, 170}, {30, 30}, {0, 180}};
    for (const auto& [inner, outer] : cones)
      for (const double part : {-0.1, 0.001, 0.25, 0.5, 0.999, 1.1}) {
        const double degrees = inner + part * (outer - inner);
        if (degrees < 0 || degrees > 180 || inner == outer) continue;
        const double ends = std::cos(outer * kDegree);
        double x = (std::cos(degrees * kDegree) - ends) / (std::cos(inner * kDegree) - ends);
        x = std::fmin(std::fmax(x, 0.0), 1.0);
        // Floats know an angle to about 10⁻⁷, which is more of a narrow edge.
        const double tolerance = 1e-6 + 4e-7 / ((outer - inner) * kDegree);
        EXPECT_NEAR(at(degrees, inner, outer), x * x * (3 - 2 * x), tolerance)
            << name_of(isa) << degrees << " of " << inner << ", " << outer;
      }
    EXPECT_EQ(at(29.999, 30, 30), 1);
    EXPECT_EQ(at(30.001, 30, 30), 0);
    EXPECT_EQ(at(40.001, 20, 40), 0);
    EXPECT_EQ(at(19.999, 20, 40), 1);
  });
}

TEST(Fading, HasALinearEdge) {
  by_each_isa([](Isa isa) {
    const double cones[][2] = {{20, 40}, {0, 90}, {0.02, 0.05}, {100, 170}, {0, 180}};
    for (const auto& [inner, outer] : cones)
      for (const double part : {-0.1, 0.001, 0.25, 0.5, 0.75, 0.999, 1.1}) {
        const double degrees = inner + part * (outer - inner);
        if (degrees < 0 || degrees > 180) continue;
        const double tolerance = 1e-6 + 1e-6 / ((outer - inner) * kDegree);
        EXPECT_NEAR(middle_of(lit_wall(spot_turned(degrees, inner, outer, true)), isa),
                    std::fmin(std::fmax(1 - part, 0.0), 1.0), tolerance)
            << name_of(isa) << degrees << " of " << inner << ", " << outer;
      }
  });
}

TEST(Fading, TakesNoShadowRaysOutsideOfTheCone) {
  const auto shadow_rays = [](double degrees) {
    return render(lit_wall(spot_turned(degrees, 10, 30)), {}).value().stats.rays.shadow;
  };
  EXPECT_EQ(shadow_rays(29), 25u);
  EXPECT_EQ(shadow_rays(31), 0u);
}

TEST(Fading, IsToldOf) {
  const auto told = [](double degrees) {
    const Scene scene = lit_wall(spot_turned(degrees, 10, 30));
    return explain(scene, {}, 2, 2).value().trees.front().rays.front().hit->lights.front();
  };
  EXPECT_EQ(told(29).reach, Reach::lit);
  EXPECT_EQ(told(31).reach, Reach::dark);
  EXPECT_EQ(told(31).arriving, (Float3{0, 0, 0}));
  Scene scene = lit_wall(spot_turned(31, 10, 30));
  scene.lights[0].position.z = -5;  // it shines from behind, and would not reach it anyway
  EXPECT_EQ(explain(scene, {}, 2, 2).value().trees.front().rays.front().hit->lights.front().reach,
            Reach::behind);
}

/// Three lights that fade, each in its way.
Scene with_fading_lights(std::uint32_t side) {
  Scene scene = mixed_scene(side);
  Light spot = spot_turned(0, 12, 25);
  spot.position = {2, 5, 6}, spot.direction = {-2, -5, -7};
  spot.attenuation = {0.5, 0.05, 0.01};
  Light other = spot;
  other.position.x = -3, other.direction.x = 2, other.linear_edge = true;
  scene.lights = {spot, other, {.position = {0, 6, 2}, .attenuation = {0, 0.2, 0.05}}};
  return scene;
}

TEST(Fading, IsTheGeneralEnginesUpToRounding) {
  const Scene scene = with_fading_lights(100);
  RenderOptions options;
  EXPECT_FALSE(needs_general_engine(scene, options));
  EXPECT_TRUE(is_beyond_the_lab(scene, options));
  const Image lean = picture_of(scene, options);
  options.min_contribution = 1e-30;
  EXPECT_TRUE(needs_general_engine(scene, options));
  EXPECT_GT(agreement(lean, picture_of(scene, options), 1e-4f), 0.995);
}

TEST(Fading, HasTheSameBitsEverywhere) {
  const Scene scene = with_fading_lights(67);
  RenderOptions options;
  options.threads = 1;
  options.isa = Isa::portable;
  const std::string wanted = sha256(picture_of(scene, options));
  for (const Isa isa : available_isas())
    for (const int tile : {5, 64}) {
      options.isa = isa, options.tile = tile, options.threads = tile == 5 ? 3 : 1;
      EXPECT_EQ(sha256(picture_of(scene, options)), wanted) << name_of(isa) << tile;
    }
}

}  // namespace
}  // namespace zraka
