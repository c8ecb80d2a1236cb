// SPDX-License-Identifier: Apache-2.0
// Questions have one right choice, which the engine's own pictures show, and tell it to nobody.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>
#include <zraka/school/quiz.hpp>

#include "core/random.hpp"
#include "core/text.hpp"
#include "image/alter.hpp"
#include "language.hpp"
#include "scenes.hpp"
#include "school/quiz/ask.hpp"
#include "school/quiz/studio.hpp"
#include "school/quiz/view.hpp"

namespace zraka {
namespace {

using Bytes = std::array<std::uint8_t, 3>;

Scene course_scene(std::uint32_t side = 40) {
  Scene scene = read_scene(ZRAKA_SOURCE_DIR "/scenes/lab/input.txt").value().scene;
  scene.resolution = {side, side};
  return scene;
}

RenderOptions with_profile(ProfileName name) {
  return {.profile = profile_of(name)};
}
const RenderOptions kLab = with_profile(ProfileName::lab);

/// All that a quiz consists of, as bytes.
std::string bytes_of(const Quiz& quiz) {
  std::string bytes = quiz_json(quiz, {}) + quiz_answers_json(quiz);
  for (const QuizPicture& picture : quiz.pictures) bytes += picture.png;
  return bytes;
}

Image stored(const Scene& scene, const RenderOptions& options, Mistake mistake = Mistake::none) {
  return as_stored(render_mistaken(scene, options, mistake).value().image, options.profile.transfer,
                   8);
}

Bytes pixel_of(const Image& image, std::uint32_t x, std::uint32_t y) {
  Bytes bytes{};
  for (std::size_t c = 0; c < 3; ++c)
    bytes[c] = static_cast<std::uint8_t>(
        quantize(image.row(y)[3 * std::size_t{x} + c], Transfer::linear, 8));
  return bytes;
}

int distance(const Bytes& a, const Bytes& b) {
  int most = 0;
  for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(int{a[c]} - int{b[c]}));
  return most;
}

/// The picture that a choice of a stage or a mistake stands for.
Image picture_of(const Scene& scene, RenderOptions options, const QuizChoice& choice) {
  options.terms = choice.terms;
  return stored(scene, options, choice.mistake);
}

TEST(Quiz, IsTheSameForTheSameSeed) {
  const Scene scene = course_scene();
  RenderOptions options = kLab;
  options.threads = 1;
  const QuizOptions quiz{.seed = 3, .questions = 9};
  const std::string once = bytes_of(make_quiz(scene, options, quiz).value());
  options.threads = 3;
  options.tile = 8;
  options.isa = Isa::portable;
  EXPECT_EQ(bytes_of(make_quiz(scene, options, quiz).value()), once);
  EXPECT_NE(bytes_of(make_quiz(scene, kLab, {.seed = 4, .questions = 9}).value()), once);
}

TEST(Quiz, IsTheSameOnEveryMachine) {
  const Quiz quiz = make_quiz(course_scene(64), kLab, {.seed = 2026, .questions = 12}).value();
  std::string told;
  for (const QuizQuestion& question : quiz.questions) {
    told += fmt::format("{}{} ", name_of(question.kind)[0], letter_of(question.answer));
    if (question.kind == QuizKind::color) told += fmt::format("{},{} ", question.x, question.y);
  }
  EXPECT_EQ(told, "cD 31,34 mA sB cA 20,27 mB sC cD 49,37 mB sB cC 34,40 mA sC ");
}

TEST(Quiz, AsksEachKindAsItDoesAlone) {
  const Scene scene = course_scene();
  const Quiz mixed = make_quiz(scene, kLab, {.seed = 9, .questions = 9}).value();
  for (const QuizKind kind : kQuizKinds) {
    const Quiz alone = make_quiz(scene, kLab, {.seed = 9, .questions = 3, .kinds = {kind}}).value();
    std::size_t i = 0;
    for (const QuizQuestion& question : mixed.questions)
      if (question.kind == kind) {
        ASSERT_LT(i, alone.questions.size());
        EXPECT_EQ(question.reason, alone.questions[i++].reason);
      }
    EXPECT_EQ(i, 3u);
  }
}

TEST(Quiz, ShowsThePictureOfTheAnswerAndOfNoOtherChoice) {
  for (const ProfileName profile : {ProfileName::lab, ProfileName::physical}) {
    const Scene scene = course_scene();
    const RenderOptions options = with_profile(profile);
    const Quiz quiz =
        make_quiz(scene, options,
                  {.seed = 1, .questions = 14, .kinds = {QuizKind::stage, QuizKind::mistake}})
            .value();
    EXPECT_EQ(quiz.questions.size(), 14u);
    const Image right = stored(scene, options);
    for (const QuizQuestion& question : quiz.questions) {
      ASSERT_EQ(question.pictures.size(), 2u);
      const auto shown = [&](std::size_t i) {
        return parse_image(quiz.pictures[question.pictures[i].picture].png, "").value().image;
      };
      EXPECT_EQ(shown(0).pixels, right.pixels);
      EXPECT_TRUE(told_apart(at_a_glance(shown(1)), at_a_glance(right)));
      EXPECT_GE(question.choices.size(), 2u);
      EXPECT_LE(question.choices.size(), 4u);
      std::set<std::string> texts;
      for (std::size_t c = 0; c < question.choices.size(); ++c) {
        const Image picture = picture_of(scene, options, question.choices[c]);
        texts.insert(question.choices[c].text);
        EXPECT_TRUE(told_apart(at_a_glance(picture), at_a_glance(right)));
        if (c == question.answer)
          EXPECT_EQ(picture.pixels, shown(1).pixels) << question.choices[c].text;
        else
          EXPECT_TRUE(told_apart(at_a_glance(picture), at_a_glance(shown(1))))
              << question.choices[c].text << " for " << question.choices[question.answer].text;
      }
      EXPECT_EQ(texts.size(), question.choices.size());
      // The reason speaks of a pixel that differs.
      EXPECT_EQ(question.reason.size(), 4u);
      EXPECT_NE(pixel_of(right, question.x, question.y),
                pixel_of(shown(1), question.x, question.y));
    }
  }
}

TEST(Quiz, HasNoTwoNamesForOnePicture) {
  // With two lights and Ia = 0.5, Ia·ka for each light is ka.
  constexpr Mistake kTwins[] = {Mistake::ambient_unscaled, Mistake::ambient_per_light};
  Scene scene = lab_scene(40);
  scene.lights.push_back({{-2, -1, 2}, {0.3, 0.2, 0.4}});
  add_sphere(scene, {0, 0, -1}, 1, {.ambient = {0.3, 0.2, 0.1}, .diffuse = {0.5, 0.3, 0.2}});
  const auto is_twin = [&](const QuizChoice& choice) {
    return std::count(std::begin(kTwins), std::end(kTwins), choice.mistake);
  };
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Quiz quiz =
        make_quiz(scene, kLab, {.seed = seed, .questions = 40, .kinds = {QuizKind::mistake}})
            .value();
    std::ptrdiff_t asked = 0;
    for (const QuizQuestion& question : quiz.questions) {
      if (is_twin(question.choices[question.answer]) == 0) continue;
      ++asked;
      EXPECT_EQ(std::count_if(question.choices.begin(), question.choices.end(), is_twin), 1);
    }
    EXPECT_EQ(asked, 1);
  }
}

TEST(Quiz, AsksForThePicturesOwnColour) {
  std::set<std::string> slips;
  for (const ProfileName profile : {ProfileName::lab, ProfileName::physical}) {
    Scene scene = course_scene();
    scene.lights[0].color = {2, 2, 2};  // for sums above 1
    const RenderOptions options = with_profile(profile);
    const Image right = stored(scene, options);
    const Quiz quiz =
        make_quiz(scene, options, {.seed = 6, .questions = 72, .kinds = {QuizKind::color}}).value();
    EXPECT_EQ(quiz.questions.size(), 72u);
    for (const QuizQuestion& question : quiz.questions) {
      const Bytes color = question.choices[question.answer].color;
      EXPECT_EQ(color, pixel_of(right, question.x, question.y));
      EXPECT_TRUE(explain(scene, options, question.x, question.y)->trees[0].rays[0].hit);
      for (std::size_t a = 0; a < question.choices.size(); ++a) {
        EXPECT_EQ(question.choices[a].reason.empty(), a == question.answer);
        slips.insert(question.choices[a].reason);
        EXPECT_EQ(question.choices[a].text, color_text(question.choices[a].color));
        for (std::size_t b = 0; b < a; ++b)
          EXPECT_GE(distance(question.choices[a].color, question.choices[b].color), 10);
      }
      EXPECT_NE(question.sums.find(color_text(color)), std::string::npos) << question.sums;
      // The picture hides it.
      const Image shown = parse_image(quiz.pictures[question.pictures[0].picture].png, "")->image;
      EXPECT_EQ(pixel_of(shown, question.x, question.y), (Bytes{255, 38, 26}));
    }
  }
  for (auto slip = static_cast<std::size_t>(Word::slip_no_ambient);
       slip <= static_cast<std::size_t>(Word::slip_no_curve); ++slip)
    EXPECT_TRUE(slips.contains(say(Language::english, static_cast<Word>(slip))))
        << name_of(static_cast<Word>(slip));
}

TEST(Quiz, TellsWhatTheColourFollowsFrom) {
  // One sphere, one light: the sum can be done by hand.
  Scene scene = lab_scene(64);
  add_sphere(scene, {0, 0, -1}, 1,
             {.ambient = {0.2, 0.1, 0.1}, .diffuse = {0.5, 0.6, 0.7}, .specular = {0.4, 0.4, 0.4}});
  const Quiz quiz = make_quiz(scene, kLab, {.questions = 1, .kinds = {QuizKind::color}}).value();
  const QuizQuestion& question = quiz.questions.front();
  const Explanation e = explain(scene, kLab, question.x, question.y).value();
  ASSERT_EQ(question.facts.size(), 4u);
  EXPECT_EQ(question.facts[0].find("The ray from the eye hits sphere 1; there N = ("), 0u);
  EXPECT_EQ(question.facts[1],
            "Ia = (0.5, 0.5, 0.5), ka = (0.2, 0.1, 0.1), kd = (0.5, 0.6, 0.7), ks = (0.4, 0.4, "
            "0.4), n = 10, k1 = 0, k2 = 0");
  EXPECT_EQ(question.facts[2].find("Light 1: Ii = (1, 1, 1), L·N = "), 0u);
  EXPECT_EQ(question.facts[3],
            "Each channel is limited to 0…1; the file stores the whole part of 255·C + 0.5.");
}

TEST(Quiz, AsksNothingTwice) {
  const Quiz quiz = make_quiz(course_scene(), kLab, {.seed = 8, .questions = 100}).value();
  std::set<std::string> seen;
  for (const QuizQuestion& question : quiz.questions) {
    const std::string what = question.kind == QuizKind::color
                                 ? fmt::format("{} {}", question.x, question.y)
                                 : question.choices[question.answer].text;
    EXPECT_TRUE(seen.insert(std::string(name_of(question.kind)) + what).second) << what;
  }
  EXPECT_EQ(quiz.questions.size(), 100u);
}

/// Whoever has the quiz without its answers could not tell if another choice were right.
TEST(Quiz, WithoutAnswersHasNothingOfThem) {
  const Scene scene = course_scene(32);
  const Quiz quiz = make_quiz(scene, kLab, {.seed = 40417, .questions = 9}).value();
  Quiz turned = quiz;
  for (QuizQuestion& question : turned.questions) {
    question.answer = (question.answer + 1) % question.choices.size();
    question.reason = {"Otherwise."};
    question.sums = "Other sums.";
    for (QuizChoice& choice : question.choices) choice.reason = "Other slips.";
    if (question.kind != QuizKind::color) question.x = question.y = 5;
  }
  QuizView view{.scene = "s", .resolution = scene.resolution, .seed = 40417, .answers = false};
  QuizView other = view;
  other.seed = 2;
  view.files = other.files = std::vector<std::string>(quiz.pictures.size(), "p.png");
  EXPECT_EQ(quiz_page(quiz, view), quiz_page(turned, other));
  EXPECT_EQ(quiz_json(quiz, view), quiz_json(turned, other));
  EXPECT_EQ(quiz_text(quiz, view), quiz_text(turned, other));
  EXPECT_EQ(quiz_page(quiz, view).find("<script"), std::string::npos);
  EXPECT_NE(quiz_answers_page(quiz, view), quiz_answers_page(turned, other));
  view.answers = true;
  EXPECT_NE(quiz_page(quiz, view).find("Missing: "), std::string::npos);
}

TEST(Quiz, PutsTheRightChoiceAnywhere) {
  Random random(3);
  std::array<int, 4> places{};
  for (int i = 0; i < 2000; ++i) {
    QuizQuestion question;
    set_choices(question, {.text = "right"}, {{.text = "a"}, {.text = "b"}, {.text = "c"}}, random);
    EXPECT_EQ(question.choices[question.answer].text, "right");
    ++places[question.answer];
  }
  for (const int times : places) EXPECT_NEAR(times, 500, 80);
}

/// No choice is a mistake that shows only from this stage on.
void expect_mistakes_before(int stage, const Quiz& quiz) {
  for (const QuizQuestion& question : quiz.questions)
    for (const QuizChoice& choice : question.choices) {
      if (choice.mistake == Mistake::none) continue;
      EXPECT_LT(entry_of(choice.mistake).first_stage, stage) << choice.text;
    }
}

TEST(Quiz, AsksOnlyWhatTheSceneShows) {
  // No glass, no mirror: nobody is asked for refracted or reflected rays.
  Scene scene = lab_scene(64);
  add_sphere(scene, {0, 0, -1}, 1, {.diffuse = {0.8, 0.3, 0.2}, .specular = {0.5, 0.5, 0.5}});
  const Quiz quiz = make_quiz(scene, kLab, {.questions = 40}).value();
  EXPECT_GT(quiz.questions.size(), 10u);
  expect_mistakes_before(6, quiz);
  for (const QuizQuestion& question : quiz.questions)
    for (const QuizChoice& choice : question.choices)
      EXPECT_TRUE(choice.terms.reflection && choice.terms.refraction && choice.terms.shadows);
}

TEST(Quiz, OfAnEarlierStageKnowsNothingOfTheLaterOnes) {
  RenderOptions options = kLab;
  options.terms = terms_of(Stage::shadows);
  const Quiz quiz = make_quiz(course_scene(), options, {.questions = 40}).value();
  expect_mistakes_before(6, quiz);
  for (const QuizQuestion& question : quiz.questions)
    for (const QuizChoice& choice : question.choices)
      EXPECT_FALSE(question.kind == QuizKind::stage && choice.terms.reflection);
}

TEST(Quiz, AsksForNoColourOfFourCornersOrManyLights) {
  Scene scene = course_scene();
  const auto colors = [&](ProfileName profile) {
    const Quiz quiz = make_quiz(scene, with_profile(profile), {.questions = 12}).value();
    return std::count_if(
        quiz.questions.begin(), quiz.questions.end(),
        [](const QuizQuestion& question) { return question.kind == QuizKind::color; });
  };
  EXPECT_EQ(colors(ProfileName::spd), 0);
  EXPECT_EQ(colors(ProfileName::lab), 4);
  for (int i = 0; i < 4; ++i) scene.lights.push_back({{1.0 * i, 2, 2}, {0.2, 0.2, 0.2}});
  EXPECT_EQ(colors(ProfileName::lab), 0);
}

TEST(Quiz, CountsOnSilhouettesAndOnAmbientLight) {
  for (const Stage stage : {Stage::silhouette, Stage::ambient}) {
    RenderOptions options = kLab;
    options.terms = terms_of(stage);
    const Quiz quiz = make_quiz(course_scene(), options, {.questions = 30}).value();
    EXPECT_FALSE(quiz.questions.empty());
    for (const QuizQuestion& question : quiz.questions)
      EXPECT_NE(question.kind, QuizKind::stage);  // one term alone is no choice
  }
}

TEST(Quiz, IsInCroatianThroughout) {
  const Quiz quiz =
      make_quiz(course_scene(), kLab, {.seed = 2, .questions = 24, .language = "hr"}).value();
  EXPECT_EQ(quiz.questions.size(), 24u);
  for (const QuizQuestion& question : quiz.questions) {
    std::string words = question.text + " " + question.sums;
    for (const std::string& reason : question.reason) words += " " + reason;
    for (const std::string& fact : question.facts) words += " " + fact;
    for (const QuizChoice& choice : question.choices) words += " " + choice.text + choice.reason;
    for (const auto& shown : question.pictures) words += " " + shown.caption;
    EXPECT_EQ(english_words_in(words), "") << words;
  }
}

TEST(Quiz, RefusesWhatItCannotAsk) {
  const auto problem = [](const Scene& scene, const RenderOptions& options, QuizOptions quiz) {
    const Result<Quiz> made = make_quiz(scene, options, quiz);
    return made ? std::string() : std::string(trimmed(to_string(made.error().front())));
  };
  const std::string nothing =
      "error: nothing can be asked of this picture: no term and no mistake shows in it\n"
      "  a quiz needs shapes that the eye sees, and light on them";
  EXPECT_EQ(problem(lab_scene(32), kLab, {}), nothing);
  Scene black = lab_scene(32);
  add_sphere(black, {0, 0, -1}, 1, {.ambient = {0, 0, 0}, .diffuse = {0, 0, 0}});
  EXPECT_EQ(problem(black, kLab, {}), nothing);
  EXPECT_EQ(problem(course_scene(), kLab, {.questions = 0}),
            "error: 0 questions are out of range\n  1 to 100 can be asked for");
  EXPECT_EQ(problem(course_scene(), kLab, {.kinds = {}}),
            "error: no kind of question is asked for\n  stage, mistake or color");
  EXPECT_EQ(problem(course_scene(), kLab, {.language = "de"}),
            "error: there are no words in the language 'de'\n  en or hr");
  EXPECT_EQ(problem(course_scene(2049), kLab, {}),
            "error: a quiz's pictures have 4198401 pixels each: 4194304 at most\n"
            "  ask for smaller pictures with --width");
  RenderOptions deep = kLab;
  deep.max_depth = 1000;
  EXPECT_EQ(problem(course_scene(), deep, {}),
            std::string(trimmed(to_string(render(course_scene(), deep).error()[0]))));
}

TEST(Quiz, LeavesOutPixelsWhoseTreesAreTooLarge) {
  // The eye is within glass that also mirrors: every ray has two children.
  Scene scene = lab_scene(1);
  add_sphere(scene, {0, 0, 0}, 5,
             {.ambient = {0.5, 0.5, 0.5}, .reflection = 0.5, .refraction = 0.5});
  add_sphere(scene, {0, 0, 0}, 9, {.reflection = 0.5, .refraction = 0.5});
  RenderOptions options = kLab;
  const QuizOptions colors{.questions = 1, .kinds = {QuizKind::color}};
  EXPECT_TRUE(make_quiz(scene, options, colors));
  options.max_depth = 18;
  ASSERT_FALSE(explain(scene, options, 0, 0));
  EXPECT_FALSE(make_quiz(scene, options, colors));
}

}  // namespace
}  // namespace zraka
