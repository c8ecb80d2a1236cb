// SPDX-License-Identifier: Apache-2.0
// What is said about pixels: exact words for scenes made for them, and words that are true of any.
#include <gtest/gtest.h>

#include <cmath>

#include "explain/names.hpp"
#include "explain/parts.hpp"
#include "explain/roundest.hpp"
#include "explain/sentence.hpp"
#include "explain/text.hpp"
#include "language.hpp"
#include "scenes.hpp"

namespace zraka {
namespace {

RenderOptions lab(Stage stage = Stage::refraction) {
  return {.terms = terms_of(stage), .profile = profile_of(ProfileName::lab)};
}

/// One sphere of radius 1 at (0, 0, -1), touching the window; eye (0, 0, 2); pixel (50, 50) looks
/// at its middle.
Scene one_sphere(Material material) {
  Scene scene = lab_scene();
  add_sphere(scene, {0, 0, -1}, 1, material);
  return scene;
}

struct Said {
  std::string english, croatian;
};

Said said(const Scene& scene, const RenderOptions& options = lab(), std::uint32_t x = 50,
          std::uint32_t y = 50) {
  const Explanation e = explain(scene, options, x, y).value();
  return {in_words(Language::english, e), in_words(Language::croatian, e)};
}

const Material kMatt{.ambient = {0.1, 0.2, 0.1}, .diffuse = {0.5, 0.6, 0.5}};
const Material kBlack{.ambient = {0, 0, 0}, .diffuse = {0, 0, 0}};

TEST(Sentence, TellsOfShadow) {
  Scene scene = one_sphere(kMatt);
  add_sphere(scene, {0, 1, 1}, 0.1, {});
  scene.names[{0, 1}] = "zelena";
  EXPECT_EQ(said(scene).english,
            "Dark because the shadow ray to light 1 hits sphere 2 'zelena' at t = 1.31; only the "
            "ambient component remains.");
  EXPECT_EQ(said(scene).croatian,
            "Tamno jer zraka za ispitivanje sjene prema svjetlu 1 pogađa kuglu 2 'zelena' za t = "
            "1,31; ostaje samo ambijentna komponenta.");
}

TEST(Sentence, TellsOfTheSideAwayFromTheLight) {
  Scene scene = one_sphere(kMatt);
  scene.lights[0].position = {0, 0, -9};
  EXPECT_EQ(
      said(scene).english,
      "Dark because the surface faces away from light 1; only the ambient component remains.");
  EXPECT_EQ(said(scene).croatian,
            "Tamno jer je ploha okrenuta od svjetla 1; ostaje samo ambijentna komponenta.");
  scene.lights.push_back(scene.lights[0]);
  EXPECT_EQ(said(scene).english,
            "Dark because the surface faces away from light 1 and the surface faces away from "
            "light 2; only the ambient component remains.");
  EXPECT_EQ(
      said(scene).croatian,
      "Tamno jer je ploha okrenuta od svjetla 1 i ploha je okrenuta od svjetla 2; ostaje samo "
      "ambijentna komponenta.");
  scene.lights.push_back(scene.lights[0]);
  EXPECT_EQ(said(scene).english,
            "Dark because none of the 3 lights reaches the point; only the ambient component "
            "remains.");
  scene.lights.clear();
  EXPECT_EQ(said(scene).english,
            "Dark because the scene has no light; only the ambient component remains.");
  EXPECT_EQ(said(scene).croatian,
            "Tamno jer scena nema nijedno svjetlo; ostaje samo ambijentna komponenta.");
}

TEST(Sentence, DoesNotSayOnlyWhereMoreRemains) {
  Material mirror = kMatt;
  mirror.reflection = 0.5;
  Scene scene = one_sphere(mirror);
  add_sphere(scene, {0, 1, 1}, 0.1, {});
  scene.background = {0.04, 0.04, 0.04};
  EXPECT_EQ(
      said(scene).english,
      "Dark because the shadow ray to light 1 hits sphere 2 at t = 1.31; 77 % of the colour is "
      "the ambient component that remains, 23 % comes by the reflected ray.");
  EXPECT_EQ(said(scene).croatian,
            "Tamno jer zraka za ispitivanje sjene prema svjetlu 1 pogađa kuglu 2 za t = 1,31; 77 % "
            "boje je ambijentna komponenta koja ostaje, 23 % dolazi odbijenom zrakom.");
}

TEST(Sentence, TellsOfLight) {
  EXPECT_EQ(said(one_sphere(kMatt)).english,
            "85 % of the colour is the diffuse component of light 1 on sphere 1.");
  EXPECT_EQ(said(one_sphere(kMatt)).croatian,
            "85 % boje je difuzna komponenta svjetla 1 na kugli 1.");
  EXPECT_EQ(said(one_sphere(kMatt), lab(Stage::ambient)).english,
            "Dark because this stage has no light but the ambient one; only the ambient component "
            "remains.");
  Material pale{.ambient = {1, 1, 1}, .diffuse = {0.1, 0.1, 0.1}};
  EXPECT_EQ(said(one_sphere(pale)).english,
            "88 % of the colour is the ambient component of sphere 1.");
}

TEST(Sentence, TellsOfHighlights) {
  Material shiny = kBlack;
  shiny.specular = {1, 1, 1};
  Scene scene = one_sphere(shiny);
  scene.lights[0].position = {0, 0, 4};
  EXPECT_EQ(said(scene).english,
            "Bright: 100 % of the colour is the highlight of light 1 on sphere 1.");
  EXPECT_EQ(said(scene).croatian, "Svijetlo: 100 % boje je odsjaj svjetla 1 na kugli 1.");
}

TEST(Sentence, TellsOfNothing) {
  Scene scene = one_sphere(kMatt);
  EXPECT_EQ(said(scene, lab(), 0, 0).english,
            "Black because the ray from the eye hits nothing and the background shows.");
  scene.background = {0.4, 0.5, 0.6};
  EXPECT_EQ(said(scene, lab(), 0, 0).english,
            "The ray from the eye hits nothing and the background shows.");
  EXPECT_EQ(said(scene, lab(), 0, 0).croatian, "Zraka iz oka ne pogađa ništa pa se vidi pozadina.");
  EXPECT_EQ(said(one_sphere(kBlack)).english, "Black because every term is 0.");
}

TEST(Sentence, TellsOfSilhouettes) {
  EXPECT_EQ(said(one_sphere(kMatt), lab(Stage::silhouette)).english,
            "Bright: the ray from the eye hits sphere 1, and this stage shows silhouettes only.");
  EXPECT_EQ(said(one_sphere(kMatt), lab(Stage::silhouette)).croatian,
            "Svijetlo: zraka iz oka pogađa kuglu 1, a ova faza prikazuje samo siluete.");
}

TEST(Sentence, TellsWhatAMirrorShows) {
  // The middle ray comes straight back to the eye and goes on to what is behind it.
  Material mirror = kBlack;
  mirror.reflection = 0.5;
  Scene scene = one_sphere(mirror);
  add_sphere(scene, {0, 0, 10}, 1, {.ambient = {0.2, 0.2, 0.2}, .diffuse = {0.7, 0.7, 0.7}});
  scene.lights[0].position = {0, 2, 2};
  EXPECT_EQ(said(scene).english,
            "100 % of the colour comes from sphere 2, by the reflected ray of sphere 1; there the "
            "diffuse component of light 1 is the largest.");
  scene.lights[0].position = {0, 0, 20};
  EXPECT_EQ(
      said(scene).english,
      "Dark: 100 % of the colour comes from sphere 2, by the reflected ray of sphere 1; there "
      "the surface faces away from light 1 and only the ambient component remains.");
  EXPECT_EQ(
      said(scene).croatian,
      "Tamno: 100 % boje dolazi od kugle 2, preko odbijene zrake kugle 1; na tom mjestu: ploha je "
      "okrenuta od svjetla 1 i ostaje samo ambijentna komponenta.");
  scene.spheres.pop_back();
  scene.background = {0.8, 0.8, 0.8};
  EXPECT_EQ(said(scene).english,
            "100 % of the colour is the background, by the reflected ray of sphere 1.");
  EXPECT_EQ(said(scene).croatian, "100 % boje dolazi od pozadine, preko odbijene zrake kugle 1.");
}

TEST(Sentence, TellsWhatGlassShowsAndWhatItLoses) {
  Material glass = kBlack;
  glass.refraction = 0.9;
  glass.ior = 0.7;
  Scene scene = one_sphere(glass);
  scene.background = {0.8, 0.8, 0.8};
  EXPECT_EQ(said(scene).english,
            "100 % of the colour is the background, by the refracted ray of sphere 1, then the "
            "refracted ray of sphere 1.");
  RenderOptions shallow = lab();
  shallow.max_depth = 1;
  EXPECT_EQ(said(scene, shallow).english,
            "Black because every term is 0. The depth of 1 cuts off the refracted ray of sphere 1 "
            "with its share k2 = 0.9.");
  EXPECT_EQ(
      said(scene, shallow).croatian,
      "Crno jer su svi članovi 0. Dubina 1 odsijeca refraktiranu zraku kugle 1 s udjelom k2 = "
      "0,9.");
  // Nor is a cut the cause where what lies beyond it is black, too.
  scene.background = {};
  EXPECT_EQ(said(scene, shallow).english, "Black because every term is 0.");
  scene.background = {0.8, 0.8, 0.8};
  // A sphere that is thinner than what is around it, seen at 68 % of its radius.
  scene.camera = {{0.68, 0, 1000}, {0.68, 0, 999}, {1e-4, 0, 0}, {0, 1e-4, 0}};
  scene.materials[0].ior = 1.5;
  EXPECT_EQ(said(scene).english,
            "Black because every term is 0. Total internal reflection leaves the share k2 = 0.9 of "
            "sphere 1 black.");
  EXPECT_EQ(said(scene).croatian,
            "Crno jer su svi članovi 0. Zbog totalne refleksije udio k2 = 0,9 kugle 1 ostaje crn.");
}

TEST(Sentence, TellsOfClamps) {
  Scene scene = one_sphere({.ambient = {1, 1, 1}, .diffuse = {1, 1, 1}});
  scene.lights[0].position = {0, 0, 9};
  EXPECT_EQ(said(scene).english,
            "Bright: 67 % of the colour is the diffuse component of light 1 on sphere 1. What adds "
            "up to 1.5 is clamped to 1.");
  EXPECT_EQ(said(scene).croatian,
            "Svijetlo: 67 % boje je difuzna komponenta svjetla 1 na kugli 1. Zbroj 1,5 ograničen "
            "je na 1.");
}

TEST(Sentence, TellsOfTheCornerThatGivesMost) {
  Scene scene = lab_scene(100);
  scene.background = {0.1, 0.1, 0.1};
  // Of the corners of pixel (49, 49) only the lower right one looks at the sphere.
  add_sphere(scene, {0, 0, 0}, 0.01, {.ambient = {1, 1, 1}});
  RenderOptions options{.profile = profile_of(ProfileName::spd)};
  scene.lights.clear();
  EXPECT_EQ(said(scene, options, 49, 49).english,
            "Of the four corners, the lower right corner gives most. The scene has no light; only "
            "the ambient component remains.");
  EXPECT_EQ(said(scene, options, 49, 49).croatian,
            "Od četiriju kutova najviše pridonosi donji desni kut. Scena nema nijedno svjetlo; "
            "ostaje samo ambijentna komponenta.");
}

TEST(Places, AreTheRoundestThatTheEnginesFloatsStandFor) {
  EXPECT_EQ(roundest_within(-2.384e-8, 2.5e-8), 0);
  EXPECT_EQ(roundest_within(0.3000000119, 1.5e-8), 0.3);
  EXPECT_EQ(roundest_within(0.30000002, 1.5e-8), 0.30000002);
  EXPECT_EQ(roundest_within(-1234567.0625, 0.07), -1234567);
  EXPECT_EQ(roundest_within(0.1, 0), 0.1);
  // A frame whose middle floats cannot hold.
  Scene scene = one_sphere(kMatt);
  scene.spheres[0].shape.center = {0.1, 0.7, -1};
  scene.camera.eye = {0, 0.1, 2};
  const ExplainedRay ray = explain(scene, lab(), 50, 50).value().trees[0].rays[0];
  EXPECT_EQ(ray.origin, (Vec3{0, 0.1, 2}));
}

TEST(Text, HasDecimalCommasInCroatian) {
  const std::string text =
      to_text(explain(one_sphere({.refraction = 0.5, .ior = 0.8}), lab(), 40, 45).value(),
              {.language = Language::croatian, .scene = "scena"});
  EXPECT_NE(text.find("│ hvatište (0; 0; 2), smjer (-0,"), std::string::npos) << text;
  EXPECT_NE(text.find("lom: b = n1/n2 = 0,8; cos α = U·N = 0,"), std::string::npos) << text;
  const auto is_digit = [&](std::size_t i) { return text[i] >= '0' && text[i] <= '9'; };
  for (std::size_t i = 1; i + 1 < text.size(); ++i)
    EXPECT_FALSE(text[i] == '.' && is_digit(i - 1) && is_digit(i + 1)) << text.substr(i - 1, 9);
}

TEST(Parts, AddUpToTheColour) {
  for (const ProfileName profile : {ProfileName::lab, ProfileName::physical, ProfileName::spd})
    for (const NamedScene& named : test_scenes(50)) {
      Explainer explainer =
          Explainer::create(named.scene, {.profile = profile_of(profile)}).value();
      for (std::uint32_t i = 0; i < 50; ++i) {
        const Explanation e = explainer.pixel(i, 49 - i).value();
        std::array<double, 3> sum{};
        for (const Part& part : parts_of(e))
          for (std::size_t c = 0; c < 3; ++c) sum[c] += part.amount[c];
        for (std::size_t c = 0; c < 3; ++c)
          EXPECT_NEAR(sum[c], static_cast<double>(e.color[c]),
                      1e-5 * (1 + static_cast<double>(e.color[c])))
              << named.name;
      }
    }
}

/// Said as the words say it, found again in the tree.
TEST(Sentence, IsTrueOfAnyPixel) {
  std::size_t only = 0, away = 0;
  for (const NamedScene& named : test_scenes(60)) {
    Explainer explainer = Explainer::create(named.scene, lab()).value();
    for (std::uint32_t i = 0; i < 60; ++i)
      for (std::uint32_t j = 0; j < 60; j += 7) {
        const Explanation e = explainer.pixel(i, j).value();
        const std::string text = in_words(Language::english, e);
        const ExplainedRay& root = e.trees[0].rays[0];
        const bool from_child = text.find("; there ") != std::string::npos;
        if (text.find("; only the ambient component remains") != std::string::npos) {
          ++only;
          ASSERT_TRUE(root.hit);
          for (const Part& part : parts_of(e))
            EXPECT_TRUE(part.size() == 0 || (part.ray == 0 && part.source == Source::ambient));
        }
        if (text.find("hits nothing") != std::string::npos) {
          EXPECT_FALSE(root.hit);
        }
        if (!from_child && text.find("faces away from light 1") != std::string::npos) {
          ++away;
          EXPECT_LT(root.hit->lights[0].l_n, 0);
        }
        if (!from_child && text.find("shadow ray to light 1 hits") != std::string::npos) {
          EXPECT_EQ(root.hit->lights[0].reach, Reach::blocked);
        }
        if (text.starts_with("Dark") || text.starts_with("Black")) {
          EXPECT_LT(std::max({e.color[0], e.color[1], e.color[2]}), 0.25f);
        }
        if (text.starts_with("Bright")) {
          EXPECT_GT(std::max({e.color[0], e.color[1], e.color[2]}), 0.84f);
        }
      }
  }
  EXPECT_GT(only, 10u);
  EXPECT_GT(away, 10u);
}

TEST(Text, HasNoEnglishWordInCroatian) {
  for (NamedScene& named : test_scenes(40)) {
    named.scene.names.clear();
    for (const ProfileName profile : {ProfileName::lab, ProfileName::physical, ProfileName::spd})
      for (int stage = 1; stage <= 7; ++stage) {
        const RenderOptions options{.terms = terms_of(static_cast<Stage>(stage)),
                                    .profile = profile_of(profile)};
        Explainer explainer = Explainer::create(named.scene, options).value();
        for (std::uint32_t i = 0; i < 40; i += 3)
          ASSERT_EQ(english_words_in(to_text(
                        explainer.pixel(i, i).value(),
                        {.language = Language::croatian, .scene = "x.txt", .profile = profile})),
                    "");
      }
  }
}

TEST(Text, HasColoursOnlyWhereAsked) {
  const Explanation e = explain(tangled_scene(), lab(), 50, 50).value();
  EXPECT_EQ(to_text(e, {}).find('\x1b'), std::string::npos);
  EXPECT_NE(to_text(e, {.color = true}).find("\x1b[48;2;"), std::string::npos);
}

TEST(Text, ShowsEveryTerm) {
  Material glass{.ambient = {0.2, 0.4, 0.6},
                 .diffuse = {0.5, 0.5, 0.5},
                 .specular = {0.25, 0.25, 0.25},
                 .shininess = 2,
                 .reflection = 0.5,
                 .refraction = 0.25,
                 .ior = 0.8};
  Scene scene = one_sphere(glass);
  scene.lights[0].position = {0, 0, 8};
  RenderOptions options = lab();
  options.max_depth = 1;
  EXPECT_EQ(
      to_text(explain(scene, options, 50, 50).value(),
              {.scene = "scene.txt", .profile = ProfileName::lab}),
      R"(scene.txt, pixel (50, 50) of 100×100, profile of the lab, stage 7: refracted rays, depth 1
ray from the eye
│ from (0, 0, 2) in the direction (0, 0, -1)
│ hits sphere 1 at t = 2, in the point (0, 0, 0)
│ normal N = (0, 0, 1)
│ ambient component: Ia·ka = (0.5, 0.5, 0.5)·(0.2, 0.4, 0.6) = (0.1, 0.2, 0.3)
│ light 1: L = (0, 0, 1), distance 8, L·N = 1
│   the shadow ray reaches the light
│   diffuse component: Ii·kd·(L·N) = (1, 1, 1)·(0.5, 0.5, 0.5)·1 = (0.5, 0.5, 0.5)
│   specular component: Ii·ks·(R·V)ⁿ = (1, 1, 1)·(0.25, 0.25, 0.25)·1^2 = (0.25, 0.25, 0.25)
│ local light: I = (0.85, 0.95, 1.05)
│ refraction: b = n1/n2 = 0.8, cos α = U·N = 1, α = 0.00°
│   D = 4·(b²·cos²α - b² + 1) = 4, a = (-2·b·cos α + √D)/2 = 0.2, β = 0.00°
├─ reflected ray, k1 = 0.5, weight in the pixel 0.5
│  │ from (0, 0, 2.9e-06) in the direction (0, 0, 1)
│  │ hits nothing
│  └ C = background = (0, 0, 0)
├─ refracted ray, k2 = 0.25, weight in the pixel 0.25
│  │ from (0, 0, -2.86e-06) in the direction (0, 0, -1)
│  │ hits sphere 1 at t = 2, in the point (0, 0, -2)
│  │ normal N = (0, 0, 1), turned, for the ray comes from the inner or back side
│  │ ambient component: Ia·ka = (0.5, 0.5, 0.5)·(0.2, 0.4, 0.6) = (0.1, 0.2, 0.3)
│  │ light 1: L = (0, 0, 1), distance 10, L·N = 1
│  │   shadow: the shadow ray hits sphere 1 at t = 2
│  │ local light: I = (0.1, 0.2, 0.3)
│  │ no reflected ray: the depth of 1 is reached
│  │ no refracted ray: the depth of 1 is reached
│  └ C = I = (0.1, 0.2, 0.3)
└ C = I + k1·Crefl + k2·Crefr = (0.85, 0.95, 1.05) + 0.5·(0, 0, 0) + 0.25·(0.1, 0.2, 0.3) = (0.875, 1, 1.125), clamped to 0…1: (0.875, 1, 1)
colour of the pixel: (0.875, 1, 1), stored as (223, 255, 255)
Bright: 50 % of the colour is the diffuse component of light 1 on sphere 1, 5 % comes by the refracted ray. What adds up to 1.12 is clamped to 1. The depth of 1 cuts off the reflected ray of sphere 1 with its share k1 = 0.5.
)");
}

TEST(Text, KeepsWhatSteersATerminalOutOfNames) {
  EXPECT_EQ(label_of(Language::english, {{0, 2}, "\x1b[31mred"}, Case::nominative).find('\x1b'),
            std::string::npos);
}

}  // namespace
}  // namespace zraka
