// SPDX-License-Identifier: Apache-2.0
// What the general engine does is told to the bit: trees folded from printed JSON are the
// picture's, and what is said of them is what happened.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "explain/json.hpp"
#include "fold.hpp"
#include "optics_scenes.hpp"

namespace zraka {
namespace {

using nlohmann::json;

#if defined(ZRAKA_SANITIZED)
constexpr std::uint32_t kStep = 7;
#else
constexpr std::uint32_t kStep = 1;
#endif

TEST(ExplainedOptics, FoldToThePicturesBits) {
  for (const OpticsCase& one : optics_cases()) {
    const Result<Rendering> rendering = render(one.scene, one.options);
    ASSERT_TRUE(rendering) << one.name << to_string(rendering.error().front());
    const Image& image = rendering->image;
    Explainer explainer = Explainer::create(one.scene, one.options).value();
    for (std::uint32_t i = 0; i < image.width * image.height; i += 5 * kStep) {
      const std::uint32_t x = i % image.width, y = i / image.width;
      const Result<Explanation> explanation = explainer.pixel(x, y);
      ASSERT_TRUE(explanation) << one.name << to_string(explanation.error().front());
      const json read = json::parse(to_json(*explanation, "scene", "profile", "words"));
      ASSERT_TRUE(same_bits(Fold{read}.color(), image.row(y) + 3 * x))
          << one.name << " (" << x << ", " << y << ")";
      ASSERT_TRUE(same_bits(explanation->color, image.row(y) + 3 * x));
    }
  }
}

TEST(ExplainedOptics, FoldAtEveryStage) {
  for (const OpticsCase& one : optics_cases()) {
    RenderOptions options = one.options;
    for (int stage = 1; stage <= 7; ++stage) {
      options.terms = terms_of(static_cast<Stage>(stage));
      const Image image = render(one.scene, options).value().image;
      Explainer explainer = Explainer::create(one.scene, options).value();
      for (std::uint32_t i = 0; i < image.width; i += 5 * kStep) {
        const json read = json::parse(to_json(explainer.pixel(i, i).value(), "", "", ""));
        ASSERT_TRUE(same_bits(Fold{read}.color(), image.row(i) + 3 * i)) << one.name << stage;
      }
    }
  }
}

TEST(ExplainedOptics, HaveNeighboursAsInThePicture) {
  for (const OpticsCase& one : optics_cases()) {
    const Image image = render(one.scene, one.options).value().image;
    Explainer explainer = Explainer::create(one.scene, one.options).value();
    const Neighbourhood near = explainer.around(10, 11, 5);
    for (std::uint32_t y = 0; y < 5; ++y)
      for (std::uint32_t x = 0; x < 15; ++x)
        ASSERT_EQ(near.image.row(y)[x], image.row(near.top + y)[3 * near.left + x]) << one.name;
  }
}

TEST(ExplainedOptics, PrintFactorsOfTheirTerms) {
  std::size_t filtered = 0, faded = 0, occluded = 0;
  for (const OpticsCase& one : optics_cases()) {
    Explainer explainer = Explainer::create(one.scene, one.options).value();
    for (std::uint32_t i = 0; i < 24; i += kStep) {
      const Explanation e = explainer.pixel(i, 23 - i).value();
      for (const ExplainedRay& ray : e.trees.front().rays) {
        if (!ray.hit) continue;
        const ExplainedHit& hit = *ray.hit;
        for (std::size_t c = 0; c < 3; ++c) {
          const float o = hit.occlusion ? (*hit.occlusion)[c] : 1;
          occluded += hit.occlusion && o < 1;
          EXPECT_EQ(hit.ambient[c], e.ambient_light[c] * hit.ka[c] * o);
          for (std::size_t l = 0; l < hit.lights.size(); ++l) {
            const LightTerms& at = hit.lights[l];
            if (at.samples > 1) continue;
            float ii = at.arriving[c];
            faded += ii != e.lights[l].color[c];
            if (at.filter) ii = ii * (*at.filter)[c];
            filtered += at.filter && at.diffuse && (*at.filter)[c] < 1;
            if (at.diffuse) {
              EXPECT_EQ((*at.diffuse)[c], ii * hit.kd[c] * at.l_n);
            }
            if (at.specular) {
              EXPECT_EQ((*at.specular)[c], ii * hit.ks[c] * at.highlight.value_or(0));
            }
          }
        }
      }
    }
  }
  EXPECT_GT(filtered, 10u);
  EXPECT_GT(faded, 10u);
  EXPECT_GT(occluded, 10u);
}

/// All hits of a picture's pixels.
template <class Function>
void each_hit(const Scene& scene, const RenderOptions& options, const Function& function) {
  Explainer explainer = Explainer::create(scene, options).value();
  for (std::uint32_t i = 0; i < scene.resolution.width * scene.resolution.height; i += kStep) {
    const Explanation e =
        explainer.pixel(i % scene.resolution.width, i / scene.resolution.width).value();
    for (const RayTree& tree : e.trees)
      for (const ExplainedRay& ray : tree.rays)
        if (ray.hit) function(e, tree, ray, *ray.hit);
  }
}

TEST(ExplainedOptics, FiltersAreTheProductsOfWhatIsPassed) {
  const OpticsCase one = optics_case("transparent shadows");
  std::size_t passed = 0, stopped = 0;
  each_hit(one.scene, one.options, [&](const Explanation&, const RayTree&, const ExplainedRay&,
                                       const ExplainedHit& hit) {
    for (const LightTerms& at : hit.lights) {
      if (!at.filter) continue;
      Float3 product{1, 1, 1};
      double last = 0;
      for (const PassedBody& body : at.passed) {
        EXPECT_GT(body.distance, last);
        last = body.distance;
        for (std::size_t c = 0; c < 3; ++c)
          product[c] = product[c] * body.transmittance[c] * body.share[c];
      }
      EXPECT_EQ(product, *at.filter);
      passed += at.reach == Reach::lit;
      stopped += at.reach == Reach::blocked;
      EXPECT_EQ(at.blocker.has_value(), at.reach == Reach::blocked);
    }
  });
  EXPECT_GT(passed, 2u);
  EXPECT_GT(stopped, 2u);
}

TEST(ExplainedOptics, SharesAreFresnels) {
  const OpticsCase one = optics_case("fresnel 1");
  std::size_t both = 0;
  each_hit(one.scene, one.options, [&](const Explanation&, const RayTree&, const ExplainedRay&,
                                       const ExplainedHit& hit) {
    if (!hit.snell || !hit.snell->fresnel) return;
    const double f = *hit.snell->fresnel;
    EXPECT_EQ(f == 1, hit.snell->total);
    EXPECT_NEAR(hit.snell->n1 / hit.snell->n2, static_cast<double>(hit.snell->ratio), 1e-6);
    for (std::size_t c = 0; c < 3; ++c) {
      const double k1 = hit.reflection[c], k2 = hit.refraction[c];
      if (hit.reflected.ray >= 0) {
        EXPECT_NEAR(hit.reflected.shares[c], k1 + k2 * f, 1e-6);
      }
      if (hit.refracted.ray >= 0) {
        EXPECT_NEAR(hit.refracted.shares[c], k2 * (1 - f), 1e-6);
      }
    }
    both += hit.reflected.ray >= 0 && hit.refracted.ray >= 0;
  });
  EXPECT_GT(both, 5u);
}

TEST(ExplainedOptics, SplitRaysAreAllWavelengths) {
  const OpticsCase one = optics_case("dispersion");
  std::size_t split = 0;
  each_hit(one.scene, one.options, [&](const Explanation& e, const RayTree& tree,
                                       const ExplainedRay& ray, const ExplainedHit& hit) {
    if (hit.split.empty()) return;
    EXPECT_FALSE(ray.nm);
    EXPECT_LE(hit.split.size(), 5u);
    double last = 0;
    for (const SplitChild& part : hit.split) {
      EXPECT_GT(part.nm, last);
      last = part.nm;
      const ExplainedRay& child = tree.rays[static_cast<std::size_t>(part.child.ray)];
      EXPECT_EQ(child.nm, part.nm);
      EXPECT_EQ(child.shares, part.child.shares);
    }
    EXPECT_EQ(e.wavelengths, 5);
    split += hit.split.size() == 5;
  });
  EXPECT_GT(split, 5u);
}

TEST(ExplainedOptics, BoundWhatIsNotTraced) {
  OpticsCase one = optics_case("cut");
  std::size_t cut = 0, parts = 0;
  for (const double threshold : {0.1, 0.4, 1.0, 2.5}) {
    one.options.min_contribution = threshold;
    each_hit(one.scene, one.options, [&](const Explanation& e, const RayTree&, const ExplainedRay&,
                                         const ExplainedHit& hit) {
      for (const Child* child : {&hit.reflected, &hit.refracted}) {
        EXPECT_EQ(child->bound.has_value(), child->absence == Absence::contribution);
        if (!child->bound) continue;
        EXPECT_GT(*child->bound, 0);
        if (child == &hit.reflected || !hit.snell->nm) {
          EXPECT_LT(*child->bound, e.min_contribution);
        }
        ++cut;
        parts += child == &hit.refracted && !hit.split.empty();
      }
    });
  }
  EXPECT_GT(cut, 5u);
  EXPECT_GT(parts, 0u);
}

TEST(ExplainedOptics, OfScenesWithoutAreAsTheyWere) {
  const Scene scene = room_with_glass();
  Scene lean = scene;
  lean.materials[2].reflection = 0.5;
  lean.materials[3].highlight = Highlight::phong;
  Explainer explainer = Explainer::create(lean, {}).value();
  for (std::uint32_t i = 0; i < 24; ++i) {
    const std::string text = to_json(explainer.pixel(i, i).value(), "", "", "");
    for (const char* word :
         {"shares", "arriving", "samples", "medium", "k1_rgb", "n1\"", "\"nm", "sky", "inside\"",
          "split", "fresnel", "passed", "kind\": \"point"})
      EXPECT_EQ(text.find(word), std::string::npos) << word;
  }
}

}  // namespace
}  // namespace zraka
