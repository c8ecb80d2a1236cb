// SPDX-License-Identifier: Apache-2.0
// Mistakes of dispersion and the advanced tasks: what they come to in closed form, and that they
// are explained.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <zraka/school/mistakes.hpp>

#include "engine/general/wavelengths.hpp"
#include "explain/json.hpp"
#include "fold.hpp"
#include "optics_scenes.hpp"

namespace zraka {
namespace {

/// What a program paints that makes the mistake.
Image painted(const Scene& scene, const RenderOptions& options, Mistake mistake) {
  Result<Rendering> rendering = render_mistaken(scene, options, mistake);
  if (!rendering) ADD_FAILURE() << to_string(rendering.error().front());
  return rendering ? std::move(rendering->image) : Image(1, 1);
}

/// A white wall at z = 0, seen along the z axis by nearly parallel rays, lit from the side at a
/// cosine of 0.8.
Scene lit_wall() {
  Scene scene;
  scene.resolution = {1, 1};
  scene.camera = {{0, 0, 10}, {0, 0, 0}, {0.001, 0, 0}, {0, 0.001, 0}};
  scene.materials = {{.ambient = {}, .diffuse = {1, 1, 1}},
                     {.ambient = {}, .diffuse = {}, .refraction = 0.5},
                     {.ambient = {}, .diffuse = {}, .refraction = 0.25}};
  scene.parallelograms.push_back({Parallelogram{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, 0});
  scene.lights = {{{30, 0, 40}}};
  return scene;
}

TEST(AdvancedMistakes, FilterShadowsPerSurfaceOrByTheFirstBody) {
  Scene scene = lit_wall();
  const RenderOptions options{.shadows = Shadows::transparent};
  const auto wall = [&](Mistake mistake) { return painted(scene, options, mistake).pixels[0]; };
  scene.spheres = {{Sphere{{6, 0, 8}, 1}, 1}};
  EXPECT_NEAR(wall(Mistake::none), 0.8 * 0.5, 1e-6);
  EXPECT_NEAR(wall(Mistake::filter_per_surface), 0.8 * 0.5 * 0.5, 1e-6);
  EXPECT_NEAR(wall(Mistake::filter_first_only), 0.8 * 0.5, 1e-6);
  scene.spheres.push_back({Sphere{{12, 0, 16}, 1}, 2});
  EXPECT_NEAR(wall(Mistake::none), 0.8 * 0.5 * 0.25, 1e-6);
  EXPECT_NEAR(wall(Mistake::filter_per_surface), 0.8 * 0.25 * 0.0625, 1e-6);
  EXPECT_NEAR(wall(Mistake::filter_first_only), 0.8 * 0.5, 1e-6);
  // What is opaque behind the first throws no shadow by that mistake; before it, it does.
  scene.spheres.push_back({Sphere{{18, 0, 24}, 1}, 0});
  EXPECT_EQ(wall(Mistake::none), 0);
  EXPECT_NEAR(wall(Mistake::filter_first_only), 0.8 * 0.5, 1e-6);
  scene.spheres.back().shape.center = {3, 0, 4};
  EXPECT_EQ(wall(Mistake::filter_first_only), 0);
}

/// Two mirrors face each other, each with a share of a half: the weights are halves of halves.
TEST(AdvancedMistakes, CompareTheThresholdWithTheShare) {
  Scene scene;
  scene.resolution = {1, 1};
  scene.camera = {{0, 0, 0}, {0, 0, -1}, {1e-6, 0, 0}, {0, 1e-6, 0}};
  scene.ambient_light = {1, 1, 1};
  scene.materials = {{.ambient = {1, 1, 1}, .diffuse = {}, .reflection = 0.5}};
  for (const double z : {-1.0, 1.0})
    scene.parallelograms.push_back({Parallelogram{{-9, -9, z}, {18, 0, 0}, {0, 18, 0}}, 0});
  RenderOptions options{.profile = profile_of(ProfileName::physical)};
  options.max_depth = 8;
  // Nothing is brighter than 2: 0.3 is between a weight of an eighth and one of a quarter.
  options.min_contribution = 0.3;
  const Result<Rendering> right = render(scene, options);
  const Result<Rendering> mistaken = render_mistaken(scene, options, Mistake::cut_by_share);
  ASSERT_TRUE(right && mistaken);
  EXPECT_EQ(right->stats.rays.reflected, 2u);
  EXPECT_NEAR(right->image.pixels[0], 1.75, 1e-6);
  EXPECT_EQ(mistaken->stats.rays.reflected, 8u);
  EXPECT_NEAR(mistaken->image.pixels[0], 2 - std::pow(0.5, 8), 1e-6);
}

TEST(AdvancedMistakes, DivideWavelengthsByTheirNumber) {
  Scene scene = lit_wall();
  scene.lights.clear();
  scene.background = {1, 1, 1};
  scene.materials[0] = {.ambient = {}, .diffuse = {}, .refraction = 1,
                        .dispersion = {Dispersion::Kind::abbe, {25}}};
  RenderOptions options;
  options.terms.reflection = false;
  options.wavelengths = 7;
  const Image right = painted(scene, options, Mistake::none),
              mistaken = painted(scene, options, Mistake::wavelengths_by_number);
  const Wavelengths waves = wavelengths_in(7);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(right.pixels[c], 1, 1e-5);
    float most = 0;
    for (int i = 0; i < waves.count; ++i) most = std::max(most, waves.weight[i][c]);
    EXPECT_NEAR(mistaken.pixels[c], 1 / (7 * most), 1e-5) << c;
    EXPECT_LT(mistaken.pixels[c], 0.7) << c;
  }
}

/// Through a wedge a bright edge is seen shifted, blue more than red; or red more than blue.
TEST(AdvancedMistakes, BendRedMostWhereDispersionIsReversed) {
  Scene scene;
  scene.resolution = {400, 1};
  scene.camera = {{0, 0, 10}, {0, 0, 5}, {1, 0, 0}, {0, 0.01, 0}};
  scene.ambient_light = {1, 1, 1};
  scene.materials = {{.ambient = {1, 1, 1}, .diffuse = {}},
                     {.ambient = {}, .diffuse = {}, .refraction = 1, .ior = 1.5,
                      .dispersion = {Dispersion::Kind::abbe, {20}}}};
  // What is to the right of x = 0 shines; the two faces of the wedge are 15° apart.
  scene.parallelograms.push_back({Parallelogram{{0, -5, -10}, {50, 0, 0}, {0, 10, 0}}, 0});
  scene.parallelograms.push_back({Parallelogram{{-9, -9, 1}, {18, 0, 0}, {0, 18, 0}}, 1});
  const double rise = 9 * 0.26794919243112270;  // tan 15°
  scene.parallelograms.push_back(
      {Parallelogram{{-9, -9, -rise}, {18, 0, 2 * rise}, {0, 18, 0}}, 1});
  RenderOptions options{.profile = profile_of(ProfileName::physical)};
  options.terms.reflection = false;
  options.wavelengths = 16;
  // How much of a row is bright, by channel: where the edge is seen.
  const auto bright = [&](Mistake mistake) {
    const Image row = painted(scene, options, mistake);
    std::array<double, 3> sum{};
    for (std::size_t i = 0; i < row.pixels.size(); ++i)
      sum[i % 3] += static_cast<double>(row.pixels[i]);
    return sum;
  };
  const auto right = bright(Mistake::none), reversed = bright(Mistake::dispersion_reversed);
  EXPECT_GT(std::fabs(right[0] - right[2]), 2);
  EXPECT_LT((right[0] - right[2]) * (reversed[0] - reversed[2]), 0)
      << right[0] << " " << right[2] << " " << reversed[0] << " " << reversed[2];
}

TEST(AdvancedMistakes, TurnTheImagesOfTextures) {
  Scene scene = lit_wall();
  scene.resolution = {2, 2};
  scene.camera = {{0, 0, 10}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  scene.lights.clear();
  scene.ambient_light = {1, 1, 1};
  Texture texture;
  texture.kind = TextureKind::image;
  texture.mapping = TextureMapping::uv;
  texture.filter = TextureFilter::nearest;
  Image image(2, 2);
  for (std::size_t i = 0; i < 4; ++i) image.pixels[3 * i] = static_cast<float>(i) / 4;
  texture.image = std::make_shared<const Image>(image);
  scene.textures = {texture};
  scene.materials[0] = {.ambient = {1, 1, 1}, .diffuse = {},
                        .textures = {{Coefficient::ambient, 0}}};
  RenderOptions options{.profile = profile_of(ProfileName::physical)};
  const auto seen = [&](Mistake mistake) {
    const Image wall = painted(scene, options, mistake);
    std::array<float, 4> red{};
    for (std::size_t i = 0; i < 4; ++i) red[i] = wall.pixels[3 * i] * 4;
    return red;
  };
  EXPECT_EQ(seen(Mistake::none), (std::array<float, 4>{0, 1, 2, 3}));
  EXPECT_EQ(seen(Mistake::texture_upside_down), (std::array<float, 4>{2, 3, 0, 1}));
  // u along v: what was above to the left is below to the right.
  EXPECT_EQ(seen(Mistake::texture_transposed), (std::array<float, 4>{3, 1, 2, 0}));
}

TEST(AdvancedMistakes, AreExplainedToTheBit) {
  for (const char* name : {"transparent shadows", "dispersion", "cut", "textures"}) {
    OpticsCase one = optics_case(name);
    for (const MistakeEntry& entry : all_mistakes()) {
      if (entry.first_stage != kAdvanced) continue;
      const Image image = painted(one.scene, one.options, entry.mistake);
      Explainer explainer = mistaken_explainer(one.scene, one.options, entry.mistake).value();
      for (std::uint32_t i = 0; i < image.width * image.height; i += 61) {
        const std::uint32_t x = i % image.width, y = i / image.width;
        const Explanation explanation = explainer.pixel(x, y).value();
        const nlohmann::json read = nlohmann::json::parse(to_json(explanation, "", "", ""));
        ASSERT_TRUE(same_bits(Fold{read}.color(), image.row(y) + 3 * x))
            << name << " " << entry.key << " (" << x << ", " << y << ")";
        ASSERT_TRUE(same_bits(explanation.color, image.row(y) + 3 * x));
        ASSERT_EQ(explanation.varied.value().key, entry.key);
      }
    }
  }
}

TEST(AdvancedMistakes, ShowInNoneOfTheLabsPictures) {
  const Scene scene = room_with_glass();
  const RenderOptions options{.profile = profile_of(ProfileName::lab)};
  const Image right = painted(scene, options, Mistake::none);
  EXPECT_EQ(all_mistakes().size() - lab_mistakes().size(), 7u);
  for (const MistakeEntry& entry : all_mistakes()) {
    if (entry.first_stage != kAdvanced) continue;
    EXPECT_EQ(painted(scene, options, entry.mistake).pixels, right.pixels) << entry.key;
  }
}

}  // namespace
}  // namespace zraka
