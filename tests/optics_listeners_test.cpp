// SPDX-License-Identifier: Apache-2.0
// Influence, reports, quizzes and mistakes where a scene has more than the lab's optics.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <zraka/influence.hpp>
#include <zraka/school/grade.hpp>
#include <zraka/school/mistakes.hpp>
#include <zraka/school/quiz.hpp>

#include "language.hpp"
#include "optics_scenes.hpp"
#include "render/prepare.hpp"
#include "school/report/comments.hpp"

namespace zraka {
namespace {

/// What a pixel has to do with a shape, by its explanation.
unsigned bits_by_explanation(const Explanation& e, const ShapeId& shape) {
  unsigned bits = 0;
  for (const RayTree& tree : e.trees)
    for (const ExplainedRay& ray : tree.rays) {
      if (!ray.hit) continue;
      bool mirrored = false, through = false;
      for (const ExplainedRay* at = &ray;; at = &tree.rays[static_cast<std::size_t>(at->parent)]) {
        mirrored = mirrored || at->kind == RayKind::reflected;
        through = through || at->kind == RayKind::refracted;
        if (at->parent < 0) break;
      }
      if (ray.hit->shape.id == shape)
        bits |= mirrored && through ? kBothWays
                : mirrored          ? kMirrored
                : through           ? kThroughGlass
                                    : kSeen;
      for (const LightTerms& at : ray.hit->lights)
        for (const PassedBody& body : at.passed)
          if (body.shape.id == shape) bits |= kShadow;
    }
  return bits;
}

TEST(OpticsInfluence, IsWhatTheExplanationsSay) {
  for (OpticsCase& one : optics_cases()) {
    if (!needs_general_engine(one.scene, one.options))
      continue;  // influence_test.cpp has the lean one
    const ShapeId shape{0, 0};
    one.options.tile = 7;
    const Result<Influence> found = influence(one.scene, one.options, ShapeInScene(shape));
    ASSERT_TRUE(found) << one.name;
    Explainer explainer = Explainer::create(one.scene, one.options).value();
    // Explanations list what the first of a light's samples passes.
    const bool sampled = std::any_of(one.scene.lights.begin(), one.scene.lights.end(),
                                     [](const Light& light) { return light.is_surface(); });
    for (std::uint32_t y = 0; y < 24; y += 3)
      for (std::uint32_t x = 0; x < 24; ++x) {
        const unsigned want = bits_by_explanation(explainer.pixel(x, y).value(), shape);
        const unsigned have = found->pixels[y * 24 + x];
        if (sampled) {
          ASSERT_EQ(want & ~have, 0u) << one.name << " " << x << ", " << y;
          ASSERT_EQ(want | kShadow, have | kShadow) << one.name << " " << x << ", " << y;
        } else {
          ASSERT_EQ(want, have) << one.name << " " << x << ", " << y;
        }
      }
  }
}

SceneFacts facts_of(const OpticsCase& one) {
  return measure_stages(one.scene, one.options,
                        [](Stage, const StagePictures&) { return Result<void>(); })
      .value();
}

/// What a stage's explanations come to, pixel by pixel.
struct Counts {
  std::uint64_t dark = 0, partly = 0, dimmed = 0, absorbed = 0, fresnel = 0, split = 0;
};
Counts counts_of(const OpticsCase& one, Stage stage) {
  RenderOptions options = one.options;
  options.terms = terms_of(stage);
  Explainer explainer = Explainer::create(one.scene, options).value();
  Counts counts;
  for (std::uint32_t i = 0; i < 24 * 24; ++i) {
    const Explanation e = explainer.pixel(i % 24, i / 24).value();
    for (const ExplainedRay& ray : e.trees.front().rays) {
      if (!ray.hit) continue;
      counts.absorbed += ray.hit->medium.has_value();
      counts.fresnel += ray.hit->snell && ray.hit->snell->fresnel;
      const bool splits = !ray.hit->split.empty();
      counts.split += splits;
      if (ray.depth > 0) continue;
      for (const LightTerms& at : ray.hit->lights) {
        counts.dark += at.reach == Reach::dark;
        counts.partly += at.reaching > 0 && at.reaching < at.facing;
        counts.dimmed += at.samples == 1 && at.reach == Reach::lit && !at.passed.empty();
      }
    }
  }
  return counts;
}

TEST(OpticsReport, CountsWhatTheExplanationsSay) {
  std::uint64_t dark = 0, partly = 0, dimmed = 0, absorbed = 0, fresnel = 0, split = 0;
  for (const OpticsCase& one : optics_cases()) {
    if (one.options.profile.average_corners || one.options.min_contribution > 0) continue;
    if (one.scene.fog.kind != Fog::Kind::none) continue;  // changes no counts
    const SceneFacts facts = facts_of(one);
    EXPECT_EQ(facts.general, needs_general_engine(one.scene, one.options));
    const bool fades = std::any_of(one.scene.lights.begin(), one.scene.lights.end(),
                                   [](const Light& light) { return light.kind == LightKind::spot; });
    if (!facts.general && !fades) continue;
    const bool transparent_surface =
        one.options.shadows == Shadows::transparent &&
        std::any_of(one.scene.lights.begin(), one.scene.lights.end(),
                    [](const Light& light) { return light.is_surface(); });
    for (const Stage stage : {Stage::diffuse, Stage::shadows, Stage::refraction}) {
      const Counts want = counts_of(one, stage);
      const StageFacts& have = facts.stages[static_cast<std::size_t>(stage) - 1];
      Counts sum;
      for (const LightFacts& light : have.lights) {
        sum.dark += light.dark, sum.partly += light.partly, sum.dimmed += light.dimmed;
        EXPECT_EQ(light.facing + light.away, have.points) << one.name;
      }
      if (stage != Stage::diffuse || !facts.general) {
        EXPECT_EQ(sum.dark, want.dark) << one.name;
        EXPECT_EQ(sum.partly, want.partly) << one.name;
        if (!transparent_surface) {
          EXPECT_EQ(sum.dimmed, want.dimmed) << one.name;
        }
      }
      EXPECT_EQ(have.absorbed, want.absorbed) << one.name;
      EXPECT_EQ(have.fresnel, want.fresnel) << one.name;
      EXPECT_EQ(have.split, want.split) << one.name;
      dark += sum.dark, partly += sum.partly, dimmed += sum.dimmed;
      absorbed += have.absorbed, fresnel += have.fresnel, split += have.split;
    }
  }
  for (const std::uint64_t any : {dark, partly, dimmed, absorbed, fresnel, split})
    EXPECT_GT(any, 20u);
}

TEST(OpticsReport, SaysWhatItCounted) {
  OpticsCase one = optics_case("transparent shadows");
  one.scene.lights[0].kind = LightKind::spot;
  one.scene.lights[0].direction = {-2, -4, -3};
  one.scene.lights[0].inner_deg = 8, one.scene.lights[0].outer_deg = 20;
  const SceneFacts facts = facts_of(one);
  const auto all = [&](Language language, Stage stage) {
    std::string text;
    for (const std::string& sentence : comments_on(language, facts, stage)) text += sentence + " ";
    return text;
  };
  const auto says = [&](Stage stage, const std::string& what) {
    EXPECT_NE(all(Language::english, stage).find(what), std::string::npos)
        << what << " in " << all(Language::english, stage);
  };
  const StageFacts& shadows = facts.stages[4];
  says(Stage::diffuse,
       fmt::format("Points outside of the cone of light 1: {}.", facts.stages[2].lights[0].dark));
  says(Stage::shadows,
       fmt::format("Transparent shadow: in {} cases light comes to a point through transparent "
                   "bodies.",
                   shadows.lights[0].dimmed + shadows.lights[1].dimmed));
  says(Stage::refraction, "Rays that have come through what absorbs: ");
  for (int stage = 1; stage <= 7; ++stage)
    EXPECT_EQ(english_words_in(all(Language::croatian, static_cast<Stage>(stage))), "")
        << all(Language::croatian, static_cast<Stage>(stage));
}

TEST(OpticsMistakes, AreRefused) {
  for (const OpticsCase& one : optics_cases()) {
    for (const MistakeEntry& entry : lab_mistakes()) {
      const Result<Rendering> rendering = render_mistaken(one.scene, one.options, entry.mistake);
      ASSERT_FALSE(rendering) << one.name;
      EXPECT_EQ(rendering.error().front().message,
                "mistakes are made by the lab's rules, and this picture asks for more than these");
      EXPECT_EQ(rendering.error().front().hint,
                "these are point lights without attenuation, opaque shadows, one background, "
                "Phong's highlights, grey k1 and k2");
      const Result<Explanation> explanation =
          explain_mistaken(one.scene, one.options, entry.mistake, 1, 1);
      ASSERT_FALSE(explanation);
      EXPECT_EQ(to_string(explanation.error().front()), to_string(rendering.error().front()));
    }
    EXPECT_TRUE(render_mistaken(one.scene, one.options, Mistake::none));
  }
}

TEST(OpticsQuiz, AsksForMissingTermsOnly) {
  const OpticsCase one = optics_case("transparent shadows");
  const Result<Quiz> quiz = make_quiz(one.scene, one.options, {});
  ASSERT_TRUE(quiz) << to_string(quiz.error().front());
  EXPECT_GT(quiz->questions.size(), 1u);
  for (const QuizQuestion& question : quiz->questions) {
    EXPECT_EQ(question.kind, QuizKind::stage);
    EXPECT_FALSE(question.reason.empty());
  }
  QuizOptions mistakes;
  mistakes.kinds = {QuizKind::mistake};
  const Result<Quiz> none = make_quiz(one.scene, one.options, mistakes);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().front().message,
            "this picture asks for more than the lab's rules, so that only missing terms are asked "
            "for, and none shows in it");
}

TEST(OpticsGrade, TellsRightFromOther) {
  const OpticsCase one = optics_case("spot");
  const Result<Grader> grader = Grader::create(one.scene, one.options, {});
  ASSERT_TRUE(grader);
  const std::string folder = testing::TempDir() + "zraka_optics_grade";
  std::filesystem::create_directories(folder);
  for (int stage = 1; stage <= 7; ++stage)
    ASSERT_TRUE(write_png(grader->picture(stage == 6 ? 3 : stage, Mistake::none),
                          fmt::format("{}/{}.png", folder, stage),
                          {8, one.options.profile.transfer}));
  const Grade grade = grader->grade(folder);
  for (std::size_t i = 0; i < 7; ++i)
    EXPECT_EQ(grade.stages[i].verdict, i == 5 ? Verdict::unknown : Verdict::right) << i;
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace zraka
