// SPDX-License-Identifier: Apache-2.0
// What is said of light and glass beyond the lab's: exact lines for scenes made for them, and what
// has to hold of any.
#include <gtest/gtest.h>

#include <cmath>

#include "explain/page.hpp"
#include "explain/segments.hpp"
#include "explain/sentence.hpp"
#include "explain/text.hpp"
#include "language.hpp"
#include "optics_scenes.hpp"

namespace zraka {
namespace {

/// A wall at z = 0 in front of an eye at z = 10, and one light.
Scene wall(Material material = {.ambient = {0.1, 0.1, 0.1}, .diffuse = {1, 1, 1}}) {
  Scene scene;
  scene.resolution = {5, 5};
  scene.camera = {{0, 0, 10}, {0, 0, 0}, {0.001, 0, 0}, {0, 0.001, 0}};
  scene.materials = {material};
  scene.ambient_light = {1, 1, 1};
  scene.lights = {{{0, 0, 5}}};
  scene.parallelograms.push_back({Parallelogram{{-9, -9, 0}, {18, 0, 0}, {0, 18, 0}}, 0});
  return scene;
}

struct Said {
  std::string text, croatian, words, croatian_words;

  void has(const std::string& line) const {
    EXPECT_NE(text.find(line + "\n"), std::string::npos) << line << "\nis not in\n" << text;
  }
};
Said said(const Scene& scene, const RenderOptions& options = {}) {
  const Result<Explanation> e = explain(scene, options, 2, 2);
  if (!e) {
    ADD_FAILURE() << to_string(e.error().front());
    return {};
  }
  return {to_text(*e, {}), to_text(*e, {.language = Language::croatian}),
          in_words(Language::english, *e), in_words(Language::croatian, *e)};
}

TEST(OpticsText, TellsWhatDistanceAndConeLeave) {
  Scene scene = wall();
  scene.lights[0].kind = LightKind::spot;
  scene.lights[0].direction = {0, 0, -1};
  scene.lights[0].inner_deg = 20, scene.lights[0].outer_deg = 40;
  scene.lights[0].attenuation = {1, 0.5, 0.25};
  const Said it = said(scene);
  it.has("│ light 1 (spot): L = (0, 0, 1), distance 5, L·N = 1");
  it.has("│   attenuation leaves 1/(c + l·d + q·d²) = 0.1026");
  it.has("│   0.00° from the spot's axis, full up to 20.00°, dark from 40.00°");
  it.has("│   what arrives: Ii' = (0.1026, 0.1026, 0.1026)");
  it.has("│   the shadow ray reaches the light");
  it.has(
      "│   diffuse component: Ii'·kd·(L·N) = (0.1026, 0.1026, 0.1026)·(1, 1, 1)·1 = (0.1026, "
      "0.1026, 0.1026)");
  scene.lights[0].direction = {1, 0, -1};
  const Said dark = said(scene);
  dark.has("│   outside of the spot's cone: 45.00° from its axis, dark from 40.00°");
  EXPECT_EQ(dark.words,
            "The point is outside of the cone of light 1; only the ambient component remains.");
  scene.ambient_light = {0.1, 0.1, 0.1};
  EXPECT_EQ(said(scene).words,
            "Dark because the point is outside of the cone of light 1; only the ambient component "
            "remains.");
  EXPECT_EQ(said(scene).croatian_words,
            "Tamno jer je točka izvan stošca svjetla 1; ostaje samo ambijentna komponenta.");
}

TEST(OpticsText, TellsOfLightFromFarAway) {
  Scene scene = wall();
  scene.lights[0].kind = LightKind::directional;
  scene.lights[0].direction = {0, -3, -4};
  said(scene).has("│ light 1 (directional): L = (0, 0.6, 0.8), infinitely far away, L·N = 0.8");
}

TEST(OpticsText, CountsShadowRaysOfSurfaces) {
  Scene scene = wall({.ambient = {0.1, 0.1, 0.1},
                      .diffuse = {0.7, 0.7, 0.7},
                      .specular = {0.5, 0.5, 0.5},
                      .shininess = 5});
  scene.lights = {surface_light(LightKind::rectangle, 16)};
  scene.lights[0].position = {-1, 4, 5};
  scene.lights[0].edge_u = {2, 0, 0}, scene.lights[0].edge_v = {0, 0, 2};
  // Beside the way from the eye; of the light it hides what is on its right.
  scene.parallelograms.push_back({Parallelogram{{0.05, -9, 2}, {9, 0, 0}, {0, 18, 0}}, 0});
  const Explanation e = explain(scene, {}, 2, 2).value();
  const LightTerms& at = e.trees[0].rays[0].hit->lights[0];
  EXPECT_GT(at.reaching, 4);
  EXPECT_LT(at.reaching, 12);
  const Said it = said(scene);
  it.has(fmt::format("│   {} of 16 shadow rays reach the light", at.reaching));
  EXPECT_NE(it.text.find("│   diffuse component: mean of 16 shadow rays = ("), std::string::npos);
  EXPECT_NE(it.text.find("│   specular component: mean of 16 shadow rays = ("), std::string::npos);
  EXPECT_NE(it.words.find(fmt::format(" Of 16 shadow rays to light 1, {} reach it.", at.reaching)),
            std::string::npos)
      << it.words;
  scene.parallelograms.back() = {Parallelogram{{-9, 0.2, 2}, {18, 0, 0}, {0, 9, 0}}, 0};
  const Said none = said(scene);
  none.has("│   shadow: none of the 16 shadow rays reaches the light");
  EXPECT_NE(none.text.find("│   the first shadow ray is stopped by parallelogram 2 at t = "),
            std::string::npos)
      << none.text;
  EXPECT_NE(none.words.find("shadow ray reaches light 1"), std::string::npos)
      << none.words;
}

TEST(OpticsText, TellsOfTransparentShadows) {
  Scene scene = wall();
  scene.lights[0].position = {30, 0, 40};
  scene.materials.push_back({.ambient = {}, .diffuse = {}, .refraction = Color{0.5, 0.25, 1},
                             .absorption = {1, 0.5, 0}});
  scene.spheres.push_back({Sphere{{6, 0, 8}, 1}, 1});
  scene.names[{0, 0}] = "lens";
  RenderOptions options{.shadows = Shadows::transparent};
  const Said it = said(scene, options);
  it.has("│   the shadow ray reaches the light");
  it.has("│   passes sphere 1 'lens' at t = 9: k2 = (0.5, 0.25, 1)");
  it.has("│   2 inside: exp(-a·d) = (0.1353, 0.3679, 1)");
  it.has("│   passes sphere 1 'lens' at t = 11, which has taken its share");
  it.has("│   what is left: T = (0.06767, 0.09197, 1)");
  it.has(
      "│   diffuse component: Ii·T·kd·(L·N) = (1, 1, 1)·(0.06767, 0.09197, 1)·(1, 1, 1)·0.8 = "
      "(0.05413, 0.07358, 0.8)");
  EXPECT_NE(it.words.find(" On the way, the light of light 1 passes sphere 1 'lens'."),
            std::string::npos)
      << it.words;
  scene.spheres.push_back({Sphere{{12, 0, 16}, 1}, 0});
  said(scene, options).has("│   shadow: the shadow ray hits sphere 2 at t = 19");
}

TEST(OpticsText, TellsOfFresnel) {
  Scene scene = wall({.ambient = {}, .diffuse = {}, .reflection = 0.1,
                      .refraction = Color{0.9, 0.8, 0.7}, .ior = 1.5, .fresnel = Fresnel::exact});
  scene.background = {1, 1, 1};
  const Said it = said(scene);
  it.has("│ refraction: b = n1/n2 = 1/1.5 = 0.6667, cos α = U·N = 1, α = 0.00°");
  it.has("│   Fresnel: the share F = 0.04 of k2 goes to the reflected ray");
  it.has(
      "├─ reflected ray, k1 + k2·F = (0.136, 0.132, 0.128), weight in the pixel 0.136");
  it.has(
      "├─ refracted ray, k2·(1 - F) = (0.864, 0.768, 0.672), weight in the pixel 0.864");
  it.has(
      "└ C = I + (k1 + k2·F)·Crefl + k2·(1 - F)·Crefr = (0, 0, 0) + (0.136, 0.132, 0.128)·(1, 1, "
      "1) + (0.864, 0.768, 0.672)·(1, 1, 1) = (1, 0.9, 0.8)");
}

TEST(OpticsText, TellsOfAbsorption) {
  Scene scene = wall();
  scene.parallelograms.clear();
  scene.lights.clear();
  scene.background = {1, 1, 1};
  scene.materials = {{.ambient = {}, .diffuse = {}, .refraction = 1, .ior = 1.3,
                      .absorption = {0.1, 0.5, 2}}};
  scene.material_names[0] = "brew";
  scene.boxes.push_back({Box{{-5, -5, -2}, {5, 5, 0}}, 0});
  const Said it = said(scene);
  it.has("│  │ inside of: box 1");
  it.has(
      "│  │ has come 2 through material 'brew': T = exp(-a·d) = exp(-(0.1, 0.5, 2)·2) = (0.8187, "
      "0.3679, 0.01832)");
  it.has(
      "│  └ C = (I + k2·Crefr)·T = ((0, 0, 0) + 1·(1, 1, 1))·(0.8187, 0.3679, 0.01832) = (0.8187, "
      "0.3679, 0.01832)");
  EXPECT_NE(it.words.find(" What absorbs on the way leaves 82 % of it at most."),
            std::string::npos)
      << it.words;
}

TEST(OpticsText, TellsOfWavelengths) {
  Scene scene = wall({.ambient = {}, .diffuse = {}, .refraction = 1, .ior = 1.5,
                      .dispersion = {Dispersion::Kind::abbe, {30}}});
  scene.background = {1, 1, 1};
  RenderOptions options;
  options.wavelengths = 4;
  const Said it = said(scene, options);
  EXPECT_NE(it.text.find("│ refraction, 590 nm: b = n1/n2 = 1/1."), std::string::npos) << it.text;
  for (const char* part : {"430 nm", "510 nm", "590 nm", "670 nm"})
    EXPECT_NE(it.text.find(fmt::format("├─ refracted ray, {}, k2·w = (", part)),
              std::string::npos)
        << part;
  EXPECT_NE(it.text.find("└ C = I + Σ k2·w·Crefr = (0, 0, 0) + (1, 1, 1) = (1, 1, 1)\n"),
            std::string::npos)
      << it.text;
}

TEST(OpticsText, TellsWhatIsNotTraced) {
  Scene scene = wall({.ambient = {0.1, 0.1, 0.1}, .diffuse = {}, .reflection = 0.01});
  scene.background = {1, 1, 1};
  RenderOptions options;
  options.min_contribution = 0.02;
  said(scene, options)
      .has("│ no reflected ray: not traced, since it could bring at most 0.01, less than 0.02");
}

TEST(OpticsText, TellsOfOcclusionBlinnAndSky) {
  Scene scene = wall({.ambient = {0.5, 0.5, 0.5}, .diffuse = {}, .specular = {1, 1, 1},
                      .shininess = 8, .reflection = 0.5, .highlight = Highlight::blinn});
  scene.lights[0].position = {3, 0, 4};
  scene.ambient_occlusion.samples = 4;
  scene.ambient_occlusion.color = {1, 0.5, 0.25};
  scene.sky.kind = Sky::Kind::gradient;
  scene.sky.bottom = scene.sky.top = {0.5, 0.5, 0.5};
  const Said it = said(scene);
  it.has("│ ambient light that arrives: O = (1, 0.5, 0.25)");
  it.has(
      "│ ambient component: Ia·ka·O = (1, 1, 1)·(0.5, 0.5, 0.5)·(1, 0.5, 0.25) = (0.5, 0.25, "
      "0.125)");
  it.has(
      "│   specular component: Ii·ks·(N·H)ⁿ = (1, 1, 1)·(1, 1, 1)·0.9487^8 = (0.6561, 0.6561, "
      "0.6561)");
  it.has("│  └ C = sky (gradient) = (0.5, 0.5, 0.5)");
}

TEST(OpticsText, NamesTheSample) {
  Scene scene = wall();
  scene.lights[0].attenuation = {1, 1, 0};
  RenderOptions options;
  options.sampling.count = 16;
  Explainer explainer = Explainer::create(scene, options).value();
  const std::string text = to_text(explainer.pixel(2, 2, 2).value(), {});
  EXPECT_NE(text.find(", depth 4, sample 3 of 16\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\ncolour of the sample: ("), std::string::npos) << text;
  EXPECT_EQ(explainer.pixel(2, 2, 16).error().front().message,
            "a pixel of this picture has 16 samples at most");
}

TEST(OpticsText, IsInCroatianThroughout) {
  for (OpticsCase& one : optics_cases()) {
    one.scene.names.clear();
    one.scene.material_names.clear();
    one.scene.texture_names.clear();
    Explainer explainer = Explainer::create(one.scene, one.options).value();
    for (std::uint32_t i = 0; i < 24; i += 3) {
      const Explanation e = explainer.pixel(i, 23 - i).value();
      const std::string text = to_text(e, {.language = Language::croatian});
      ASSERT_EQ(english_words_in(text), "") << one.name << "\n" << text;
      for (const std::string& both : {text, to_text(e, {})}) {
        ASSERT_EQ(both.find("nan"), std::string::npos) << one.name << "\n" << both;
        ASSERT_EQ(both.find("inf,"), std::string::npos) << one.name << "\n" << both;
      }
      PagePictures pictures{Image(8, 8), explainer.around(i, 23 - i, 5)};
      const Result<std::string> page = to_page(one.scene, e, pictures, {});
      if (e.trees[0].rays.size() > kMaxPageRays) continue;
      ASSERT_TRUE(page);
      std::size_t rays = 0, all = 0;
      for (std::size_t at = 0; (at = page->find("<details class=\"ray ", at)) != std::string::npos;
           ++at)
        ++rays;
      for (const RayTree& tree : e.trees) all += tree.rays.size();
      ASSERT_EQ(rays, all) << one.name;
    }
  }
}

TEST(OpticsSegments, LeadFromHitsToLights) {
  std::size_t dimmed = 0;
  for (const OpticsCase& one : optics_cases()) {
    Explainer explainer = Explainer::create(one.scene, one.options).value();
    for (std::uint32_t i = 0; i < 24; i += 2) {
      const Explanation e = explainer.pixel(i, i).value();
      const Segment* before = nullptr;
      const std::vector<Segment> segments = segments_of(one.scene, e);
      for (const Segment& s : segments) {
        for (const double v : {s.from.x, s.from.y, s.from.z, s.to.x, s.to.y, s.to.z})
          ASSERT_TRUE(std::isfinite(v)) << one.name;
        const ExplainedRay& ray = e.trees[s.tree].rays[s.ray];
        if (s.kind == SegmentKind::shadow_ray_dimmed) {
          ++dimmed;
          EXPECT_EQ(s.from, before->to);
        } else if (s.kind >= SegmentKind::shadow_ray_lit) {
          EXPECT_EQ(s.from, ray.hit->point);
        }
        before = &s;
      }
    }
  }
  EXPECT_GT(dimmed, 20u);
}

}  // namespace
}  // namespace zraka
