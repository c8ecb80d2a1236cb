// SPDX-License-Identifier: Apache-2.0
// What explains a pixel is what made it: trees folded from printed JSON are the picture's bits.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "explain/json.hpp"
#include "fold.hpp"
#include "render/prepare.hpp"
#include "scenes.hpp"

namespace zraka {
namespace {

using nlohmann::json;

#if defined(ZRAKA_SANITIZED)
constexpr int kPixels = 15, kPixelsOfOthers = 8;
#else
constexpr int kPixels = 1000, kPixelsOfOthers = 100;
#endif

constexpr ProfileName kProfiles[] = {ProfileName::lab, ProfileName::physical, ProfileName::spd};

RenderOptions with(ProfileName profile, Stage stage = Stage::refraction) {
  return {.terms = terms_of(stage), .profile = profile_of(profile)};
}

struct SceneToExplain : NamedScene {
  int pixels;
};

/// Every scene file of the project, and scenes of all shapes, in a hierarchy and without.
std::vector<SceneToExplain> scenes_to_explain() {
  std::vector<SceneToExplain> scenes;
  for (NamedScene& named : test_scenes(120)) scenes.push_back({std::move(named), kPixelsOfOthers});
  scenes.push_back({{"noise", noisy_scene(80)}, kPixelsOfOthers});
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(ZRAKA_SOURCE_DIR "/scenes")) {
    if (!entry.is_regular_file()) continue;
    Result<ReadScene> read = read_scene(entry.path().string());
    if (!read) continue;
    // What takes long to render takes no longer here than the others.
    Resolution& size = read->scene.resolution;
    const bool general = needs_general_engine(read->scene, {});
#ifdef ZRAKA_SANITIZED
    if (general) continue;  // those of optics_explain_test.cpp are small
#endif
    while (general && size.width > 60) size.width /= 2, size.height /= 2;
    scenes.push_back({{entry.path().string(), std::move(read->scene)}, general ? 8 : kPixels});
  }
  return scenes;
}

bool same_bits(const Float3& a, const float* b) {
  for (std::size_t c = 0; c < 3; ++c)
    if (std::bit_cast<std::uint32_t>(a[c]) != std::bit_cast<std::uint32_t>(b[c])) return false;
  return true;
}

TEST(Explain, FoldsToThePicturesBits) {
  for (const SceneToExplain& named : scenes_to_explain())
    for (const ProfileName profile : kProfiles) {
      const RenderOptions options = with(profile);
      const Image image = render(named.scene, options).value().image;
      Explainer explainer = Explainer::create(named.scene, options).value();
      std::mt19937 random(5);
      for (int i = 0; i < named.pixels; ++i) {
        const auto x = static_cast<std::uint32_t>(random() % image.width);
        const auto y = static_cast<std::uint32_t>(random() % image.height);
        const Explanation explanation = explainer.pixel(x, y).value();
        const json read = json::parse(to_json(explanation, "scene", "profile", "words"));
        ASSERT_TRUE(same_bits(Fold{read}.color(), image.row(y) + 3 * x))
            << named.name << " (" << x << ", " << y << "), " << name_of(profile);
        ASSERT_TRUE(same_bits(explanation.color, image.row(y) + 3 * x));
        ASSERT_EQ(color_from(read["color"]), explanation.color);
      }
    }
}

TEST(Explain, FoldsAtEveryStage) {
  const Scene scene = tangled_scene(60);
  for (int stage = 1; stage <= 7; ++stage) {
    const RenderOptions options = with(ProfileName::lab, static_cast<Stage>(stage));
    const Image image = render(scene, options).value().image;
    Explainer explainer = Explainer::create(scene, options).value();
    for (std::uint32_t i = 0; i < 60; ++i) {
      const json read = json::parse(to_json(explainer.pixel(i, i).value(), "", "", ""));
      ASSERT_TRUE(same_bits(Fold{read}.color(), image.row(i) + 3 * i)) << stage;
    }
  }
}

TEST(Explain, PrintsFactorsOfItsTerms) {
  // The terms again from what the JSON says they are made of, in the order that it documents.
  for (const NamedScene& named : test_scenes(60)) {
    Explainer explainer = Explainer::create(named.scene, with(ProfileName::lab)).value();
    for (std::uint32_t i = 0; i < 60; ++i) {
      const Explanation e = explainer.pixel(i, 59 - i).value();
      for (const ExplainedRay& ray : e.trees.front().rays) {
        if (!ray.hit) continue;
        const ExplainedHit& hit = *ray.hit;
        for (std::size_t c = 0; c < 3; ++c) {
          EXPECT_EQ(hit.ambient[c], e.ambient_light[c] * hit.ka[c]);
          for (std::size_t l = 0; l < hit.lights.size(); ++l) {
            const LightTerms& at = hit.lights[l];
            const float ii = e.lights[l].color[c];
            if (at.diffuse) {
              EXPECT_EQ((*at.diffuse)[c], ii * hit.kd[c] * at.l_n);
            }
            if (at.specular) {
              EXPECT_EQ((*at.specular)[c], ii * hit.ks[c] * *at.highlight);
            }
          }
        }
      }
    }
  }
}

TEST(Explain, IsOfThePictureOfEveryInstructionSet) {
  for (const NamedScene& named : test_scenes(40))
    for (const Isa isa : available_isas()) {
      RenderOptions options = with(ProfileName::physical);
      options.isa = isa;
      const Image image = render(named.scene, options).value().image;
      Explainer explainer = Explainer::create(named.scene, options).value();
      for (std::uint32_t i = 0; i < image.width; ++i)
        EXPECT_TRUE(same_bits(explainer.pixel(i, i / 2).value().color, image.row(i / 2) + 3 * i))
            << named.name << ", " << name_of(isa);
    }
}

TEST(Explain, FollowsItsOwnTree) {
  const Scene scene = tangled_scene(60);
  Explainer explainer = Explainer::create(scene, with(ProfileName::lab)).value();
  std::size_t blocked = 0, total = 0, children = 0;
  for (std::uint32_t i = 0; i < 60; ++i) {
    const Explanation explanation = explainer.pixel(i, 30).value();
    const RayTree& tree = explanation.trees.front();
    EXPECT_EQ(tree.rays.front().parent, -1);
    for (std::size_t r = 0; r < tree.rays.size(); ++r) {
      const ExplainedRay& ray = tree.rays[r];
      const double length = std::hypot(ray.direction[0], ray.direction[1], ray.direction[2]);
      EXPECT_NEAR(length, 1, 1e-6);
      if (!ray.hit) continue;
      const auto along = [&](double from, float direction) {
        return from + ray.hit->distance * static_cast<double>(direction);
      };
      EXPECT_NEAR(along(ray.origin.x, ray.direction[0]), ray.hit->point.x, 1e-4);
      EXPECT_NEAR(along(ray.origin.y, ray.direction[1]), ray.hit->point.y, 1e-4);
      EXPECT_NEAR(along(ray.origin.z, ray.direction[2]), ray.hit->point.z, 1e-4);
      for (const Child* child : {&ray.hit->reflected, &ray.hit->refracted}) {
        EXPECT_EQ(child->ray < 0, child->absence != Absence::none);
        if (child->ray < 0) continue;
        const ExplainedRay& next = tree.rays[static_cast<std::size_t>(child->ray)];
        EXPECT_EQ(next.parent, static_cast<int>(r));
        EXPECT_EQ(next.depth, ray.depth + 1);
        EXPECT_EQ(next.weight, ray.weight * static_cast<double>(child->share));
        ++children;
      }
      for (const LightTerms& at : ray.hit->lights) {
        EXPECT_EQ(at.reach == Reach::blocked, at.blocker.has_value());
        EXPECT_EQ(at.reach == Reach::lit, at.diffuse.has_value());
        EXPECT_EQ(at.reach == Reach::behind, at.l_n < 0);
        if (at.blocker) {
          EXPECT_LT(at.blocker->distance, at.distance);
        }
        blocked += at.blocker.has_value();
      }
      total += ray.hit->snell && ray.hit->snell->total;
    }
  }
  EXPECT_GT(blocked, 10u);
  EXPECT_GT(children, 50u);
  EXPECT_GT(total, 0u);
}

/// One sphere of radius 1 at (0, 0, -1), touching the window; eye (0, 0, 2); pixel (50, 50) looks
/// at its middle.
Scene one_sphere(Material material) {
  Scene scene = lab_scene();
  add_sphere(scene, {0, 0, -1}, 1, material);
  return scene;
}

TEST(Explain, NamesTheNearestBlocker) {
  Scene scene = one_sphere({.ambient = {0.4, 0.4, 0.4}, .diffuse = {1, 1, 1}});
  // Three spheres on the way from (0, 0, 0) to the light at (0, 2, 2), not in their order.
  add_sphere(scene, {0, 1.5, 1.5}, 0.1, {});
  add_sphere(scene, {0, 0.5, 0.5}, 0.1, {});
  add_sphere(scene, {0, 1, 1}, 0.1, {});
  scene.names[{0, 2}] = "first";
  const Explanation explanation = explain(scene, with(ProfileName::lab), 50, 50).value();
  const LightTerms& at = explanation.trees[0].rays[0].hit->lights[0];
  EXPECT_EQ(at.reach, Reach::blocked);
  EXPECT_EQ(at.blocker->shape.id, (ShapeId{0, 2}));
  EXPECT_EQ(at.blocker->shape.name, "first");
  EXPECT_NEAR(at.blocker->distance, std::sqrt(0.5) - 0.1, 1e-5);
  EXPECT_NEAR(at.distance, std::sqrt(8), 1e-5);
  EXPECT_NEAR(at.l_n, std::sqrt(0.5), 1e-6);
}

TEST(Explain, KnowsNamesFromLabels) {
  const char* text =
      "0,0,2: 2: 100: 0,2,2: 3:"
      "<parametri 1. kugle: tlo> <polozaj => 0, 0, -1: 1: 0: 0: 1,1,1: 1,1,1: 0,0,0: 1: 1:"
      "<parametri 2. kugle> 5, 0, -1: 1: 0: 0: 1,1,1: 1,1,1: 0,0,0: 1: 1:"
      "<parametri 3. kugle:> 5, 0, -1: <radius: velik> 1: 0: 0: 1,1,1: 1,1,1: 0,0,0: 1: 1:";
  const Scene scene = parse_scene(text, "named").value().scene;
  EXPECT_EQ(scene.names, (std::map<ShapeId, std::string>{{{0, 0}, "tlo"}}));
  EXPECT_EQ(parse_scene(write_lab_input(scene).value(), "again").value().scene.names, scene.names);
  const json read =
      json::parse(to_json(explain(scene, with(ProfileName::lab), 50, 50).value(), "", "", ""));
  EXPECT_EQ(read["tree"]["hit"]["name"], "tlo");
  EXPECT_EQ(read["tree"]["hit"]["shape"], "sphere 1");
}

TEST(Explain, TellsShapesOfAllKindsApart) {
  // Each shape alone in its column of the picture, in a scene large enough for a hierarchy.
  Scene scene = lab_scene(100);
  scene.materials = {{}};
  for (int i = 0; i < 20; ++i) scene.spheres.push_back({{{-0.6, 0.1 * i - 1, 0}, 0.05}, 0});
  for (int i = 0; i < 20; ++i) {
    const double y = 0.1 * i - 1;
    scene.triangles.push_back({{{-0.3, y, 0}, {-0.1, y, 0}, {-0.2, y + 0.08, 0}}, 0});
    scene.smooth_triangles.push_back(
        {{{0.1, y, 0}, {0.3, y, 0}, {0.2, y + 0.08, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, 0});
    scene.cones.push_back({{{0.6, y, 0}, 0.05, {0.6, y + 0.08, 0}, 0.05}, 0});
  }
  Explainer explainer = Explainer::create(scene, with(ProfileName::physical)).value();
  for (const auto& [x, kind, index, y] : {std::tuple{20u, 0, 3u, -0.7},
                                          {40u, 1, 7u, -0.27},
                                          {60u, 2, 11u, 0.13},
                                          {80u, 3, 19u, 0.94}}) {
    const auto row = static_cast<std::uint32_t>(50 - y * 50);
    const Explanation explanation = explainer.pixel(x, row).value();
    ASSERT_TRUE(explanation.trees[0].rays[0].hit) << kind;
    EXPECT_EQ(explanation.trees[0].rays[0].hit->shape.id, (ShapeId{kind, index})) << kind;
  }
}

TEST(Explain, SaysWhyAChildIsNotThere) {
  const Material glass{.reflection = 0.2, .refraction = 0.5, .ior = 0.6};
  const Material matt{};
  const auto hit = [](const Scene& scene, const RenderOptions& options) {
    return *explain(scene, options, 50, 50).value().trees[0].rays[0].hit;
  };
  ExplainedHit seen = hit(one_sphere(glass), with(ProfileName::lab));
  EXPECT_EQ(seen.reflected.absence, Absence::none);
  EXPECT_EQ(seen.refracted.absence, Absence::none);
  EXPECT_EQ(seen.refracted.share, 0.5f);
  seen = hit(one_sphere(matt), with(ProfileName::lab));
  EXPECT_EQ(seen.reflected.absence, Absence::share);
  EXPECT_EQ(seen.refracted.absence, Absence::share);
  seen = hit(one_sphere(glass), with(ProfileName::lab, Stage::reflection));
  EXPECT_EQ(seen.reflected.absence, Absence::none);
  EXPECT_EQ(seen.refracted.absence, Absence::stage);
  seen = hit(one_sphere(glass), with(ProfileName::lab, Stage::shadows));
  EXPECT_EQ(seen.reflected.absence, Absence::stage);
  RenderOptions shallow = with(ProfileName::lab);
  shallow.max_depth = 0;
  seen = hit(one_sphere(glass), shallow);
  EXPECT_EQ(seen.reflected.absence, Absence::depth);
  EXPECT_EQ(seen.refracted.absence, Absence::depth);
  EXPECT_FALSE(seen.snell);
}

TEST(Explain, NamesTotalInternalReflection) {
  // Into a sphere that is thinner than what is around it, at 68 % of its radius: sin α = 0.68 is
  // beyond 1/1.5.
  for (const ProfileName profile : {ProfileName::lab, ProfileName::physical}) {
    Scene scene = lab_scene(100);
    scene.camera = {{0.68, 0, 1000}, {0.68, 0, 999}, {1e-4, 0, 0}, {0, 1e-4, 0}};
    add_sphere(scene, {0, 0, 0}, 1,
               {.reflection = 0.25,
                .refraction = 0.5,
                .ior = profile == ProfileName::lab ? 1.5 : 1 / 1.5});
    const Explanation explanation = explain(scene, with(profile), 50, 50).value();
    const ExplainedHit& hit = *explanation.trees[0].rays[0].hit;
    ASSERT_TRUE(hit.snell);
    EXPECT_TRUE(hit.snell->total);
    EXPECT_NEAR(hit.snell->ratio, 1.5, 1e-6);
    EXPECT_NEAR(hit.snell->cosine, std::sqrt(1 - 0.68 * 0.68), 1e-3);
    EXPECT_EQ(hit.refracted.absence, Absence::total);
    EXPECT_EQ(hit.reflected.share, profile == ProfileName::lab ? 0.25f : 0.75f);
    const json read = json::parse(to_json(explanation, "", "", ""));
    const json& snell = read["tree"]["hit"]["snell"];
    EXPECT_TRUE(snell["beta_deg"].is_null());
    EXPECT_NEAR(snell["critical_deg"].get<double>(), std::asin(1 / 1.5) * 180 / M_PI, 1e-4);
    EXPECT_NEAR(snell["alpha_deg"].get<double>(), std::asin(0.68) * 180 / M_PI, 0.1);
  }
}

TEST(Explain, SaysWhatItCannotDo) {
  const auto error = [](const Scene& scene, const RenderOptions& options, std::uint32_t x,
                        std::uint32_t y) {
    const Result<Explanation> explanation = explain(scene, options, x, y);
    return explanation ? std::string("explained") : to_string(explanation.error().front());
  };
  Scene scene = lab_scene(100);
  EXPECT_EQ(error(scene, with(ProfileName::lab), 100, 3),
            "error: pixel (100, 3) is outside of the picture of 100×100 pixels\n"
            "  columns go from 0 to 99 from the left, rows from 0 to 99 from the top\n");
  EXPECT_EQ(error(scene, with(ProfileName::lab), 99, 99), "explained");
  RenderOptions options = with(ProfileName::lab);
  options.isa = Isa::oracle;
  EXPECT_EQ(error(scene, options, 0, 0),
            "error: the oracle's numbers are doubles, and no picture's: it explains nothing\n"
            "  ask for avx512, avx2 or portable\n");
  options = with(ProfileName::lab);
  options.max_depth = 201;
  EXPECT_EQ(error(scene, options, 0, 0), "error: depth 201 is out of range: 0 to 200\n");
  add_sphere(scene, {0, 0, 0}, 0, {});
  EXPECT_EQ(error(scene, with(ProfileName::lab), 0, 0),
            "error: sphere 1: its radius is not a finite number above 0\n");
}

TEST(Explain, RefusesTreesThatAreTooLarge) {
  // From within two spheres of glass most rays have two children.
  Scene scene = lab_scene(1);
  add_sphere(scene, {0, 0, 2}, 10, {.reflection = 0.5, .refraction = 0.5, .ior = 1});
  add_sphere(scene, {0, 0, 2}, 30, {.reflection = 0.5, .refraction = 0.5, .ior = 1});
  RenderOptions options = with(ProfileName::lab);
  for (const int depth : {0, 6, 12}) {
    options.max_depth = depth;
    const RayCounts rays = render(scene, options).value().stats.rays;
    EXPECT_EQ(explain(scene, options, 0, 0).value().trees[0].rays.size(),
              rays.camera + rays.reflected + rays.refracted);
  }
  options.max_depth = kMaxDepth;
  const Result<Explanation> large = explain(scene, options, 0, 0);
  ASSERT_FALSE(large);
  EXPECT_EQ(to_string(large.error().front()),
            "error: the ray tree of pixel (0, 0) is too large to be explained: its first 18 levels "
            "have 13527 rays, the next has 8362; 16384 fit\n"
            "  ask for fewer levels with a smaller depth\n");
}

TEST(Explain, RefusesTooManyTermsOfLight) {
  Scene scene = one_sphere({.reflection = 0.5});
  scene.lights.resize(300000, scene.lights.front());
  const Result<Explanation> large = explain(scene, with(ProfileName::lab), 50, 50);
  ASSERT_FALSE(large);
  EXPECT_EQ(
      large.error().front().message,
      "the ray tree of pixel (50, 50) has too many terms of light to be explained: 1 rays and "
      "300000 lights; 262144 terms fit");
}

}  // namespace
}  // namespace zraka
