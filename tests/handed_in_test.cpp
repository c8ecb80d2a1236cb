// SPDX-License-Identifier: Apache-2.0
// A slice of bench/grader: pictures as they are handed in, and what the grader makes of them.
#include <gtest/gtest.h>

#include "handed_in.hpp"
#include "image/jpeg_again.hpp"
#include "outside_tracer.hpp"
#include "school/grade/refine.hpp"

namespace zraka {
namespace {

using altered::Alteration;

using HandedIn = HandedInPictures;

TEST_F(HandedIn, TheTracerOutsideOfTheEngineDrawsItsPictures) {
  for (int stage = 1; stage <= 7; ++stage)
    EXPECT_LT(
        measure_errors(outside::Tracer(scene, stage).picture(), grader.picture(stage), 1.5 / 255)
            .share(),
        0.003)
        << stage;
}

TEST_F(HandedIn, IsRightHoweverItWasAltered) {
#ifdef ZRAKA_SANITIZED
  GTEST_SKIP() << "its pictures are too small for what is cut off of them";
#endif
  for (int i = 0; i < static_cast<int>(Alteration::count); ++i) {
    const auto how = static_cast<Alteration>(i);
    const StageGrade grade = judged(grader.picture(7), {how});
    EXPECT_EQ(grade.verdict, Verdict::right)
        << altered::kNames[static_cast<std::size_t>(i)] << ": " << grade.share_wrong << " "
        << alignment_text(Language::english, grade.alignment);
  }
}

TEST_F(HandedIn, SaysHowMuchIsVisible) {
  const Image right = grader.picture(7);
  const StageGrade grade =
      judged(cropped(right, 0, 0, right.width, right.height * 3 / 4), {Alteration::none});
  EXPECT_EQ(grade.verdict, Verdict::right);
  EXPECT_NEAR(grade.alignment.visible, 0.75, 0.02);
}

TEST_F(HandedIn, HasNoFalseCauses) {
#ifdef ZRAKA_SANITIZED
  GTEST_SKIP() << "takes a minute under a sanitizer, and runs no other code than its neighbours";
#endif
  int unknown = 0, all = 0;
  std::string named;
  for (int i = 1; i < static_cast<int>(outside::kFirstHeldOut); i += 3) {
    const auto slip = static_cast<outside::Slip>(i);
    const Image picture = outside::Tracer(scene, 7, slip).picture();
    if (measure_errors(picture, grader.picture(7), 2.5 / 255).share() < 0.02) continue;
    const StageGrade grade = judged(picture, {Alteration::none});
    ++all;
    if (grade.verdict == Verdict::unknown)
      ++unknown;
    else
      named += fmt::format("{}: {}\n", outside::kNames[static_cast<std::size_t>(i)],
                           findings(Language::english, grader, grade).front());
  }
  EXPECT_EQ(unknown, all) << named;
  EXPECT_GT(all, 6);
}

TEST_F(HandedIn, IsNothingWherePlainOrNoise) {
  Image picture(kSide, kSide);
  for (const float grey : {0.0F, 0.2F, 0.5F, 1.0F}) {
    for (float& value : picture.pixels) value = grey;
    for (const char* name : {"silhouette", "diffuse", "refraction"}) {
      const StageGrade grade = judged(picture, {Alteration::none}, name);
      EXPECT_EQ(grade.verdict, Verdict::unknown) << grey << " " << name;
      EXPECT_EQ(grade.marks, 0);
    }
  }
  altered::Random random(5);
  for (float& value : picture.pixels) value = static_cast<float>(random() % 256) / 255;
  EXPECT_EQ(judged(picture, {Alteration::none}).verdict, Verdict::unknown);
}

TEST_F(HandedIn, IsComparedInTheSizeThatItWasDrawnIn) {
  Scene larger = scene;
  larger.resolution = {kSide * 3 / 2, kSide * 3 / 2};
  const StageGrade right = judged(outside::Tracer(larger, 7).picture(), {});
  EXPECT_EQ(right.verdict, Verdict::right);
  EXPECT_EQ(right.alignment.drawn_width, larger.resolution.width);
  EXPECT_EQ(right.alignment.visible, 1);
  const Grader of_larger = Grader::create(larger, lab_options()).value();
  const StageGrade wrong = judged(of_larger.picture(7, Mistake::diffuse_sine), {});
  EXPECT_EQ(wrong.verdict, Verdict::mistaken);
  EXPECT_EQ(wrong.mistakes, std::vector<Mistake>{Mistake::diffuse_sine});
  EXPECT_EQ(wrong.share_left, 0);
  ASSERT_TRUE(grader.told_apart(wrong));
  EXPECT_EQ(grader.picture(wrong).width, larger.resolution.width);
}

TEST_F(HandedIn, IsOfTheStageThatItShowsWhateverNumberItHas) {
  const Image wrong = grader.picture(7, Mistake::diffuse_sine);
  for (const char* name : {"slika (1)", "lab3", "5"}) {
    EXPECT_EQ(judged(grader.picture(7), {}, name).stage, 7) << name;
    EXPECT_EQ(judged(grader.picture(4), {}, name).stage, 4) << name;
    const StageGrade grade = judged(wrong, {}, name);
    EXPECT_EQ(grade.stage, 7) << name;
    EXPECT_EQ(grade.mistakes, std::vector<Mistake>{Mistake::diffuse_sine}) << name;
  }
  // A word is no number.
  EXPECT_EQ(judged(grader.picture(7), {}, "shadows").stage, 5);
}

/// What is wrong is as faint as what scaling leaves, but has the shape of a highlight.
TEST_F(HandedIn, IsNotRightWhereScalingHidesWhatIsWrong) {
  const Scene faint = third_scene();
  const Grader of_faint = Grader::create(faint, lab_options()).value();
  const Image wrong = outside::Tracer(faint, 7, outside::Slip::specular_squared_color).picture();
  const std::string file = (folder / "refraction.png").string();
  EXPECT_TRUE(write_png(altered::nearest(wrong, 1.25), file, {8, Transfer::linear}));
  EXPECT_NE(of_faint.grade(file).stages.front().verdict, Verdict::right);
  EXPECT_TRUE(write_png(altered::smooth(wrong, 1.25, 1.25), file, {8, Transfer::linear}));
  EXPECT_NE(of_faint.grade(file).stages.front().verdict, Verdict::right);
}

TEST_F(HandedIn, IsRightUpsideDownAndTransposedInEitherOrder) {
  for (const auto& how : {std::vector{Alteration::upside_down, Alteration::transposed},
                          std::vector{Alteration::transposed, Alteration::upside_down}}) {
    const StageGrade grade = judged(grader.picture(7), how);
    EXPECT_EQ(grade.verdict, Verdict::right);
    EXPECT_TRUE(grade.alignment.flipped && grade.alignment.transposed);
  }
}

TEST_F(HandedIn, NamesTwoMistakesAtOnce) {
  const StageGrade grade =
      judged(grader.picture(7, {Mistake::diffuse_sine, Mistake::ratio_inverted}), {});
  EXPECT_EQ(grade.verdict, Verdict::mistaken);
  EXPECT_TRUE(grade.both);
  EXPECT_EQ(std::set<Mistake>(grade.mistakes.begin(), grade.mistakes.end()),
            (std::set<Mistake>{Mistake::diffuse_sine, Mistake::ratio_inverted}));
  const std::vector<std::string> lines = findings(Language::english, grader, grade);
  EXPECT_TRUE(lines[1].starts_with("and at once: ")) << lines[1];
}

/// Ambient light for each of two lights is twice it, as it is without the light of one half.
TEST_F(HandedIn, SaysOrWhereTwoPairsMakeThePicture) {
#ifdef ZRAKA_SANITIZED
  GTEST_SKIP()
      << "takes half a minute under a sanitizer, and runs no other code than its neighbours";
#endif
  const Scene two_lights = second_scene();
  const Grader of_two = Grader::create(two_lights, lab_options()).value();
  const std::string file = (folder / "refraction.png").string();
  EXPECT_TRUE(write_png(of_two.picture(7, {Mistake::ambient_unscaled, Mistake::ratio_inverted}),
                        file, {8, Transfer::linear}));
  const StageGrade grade = of_two.grade(file).stages.front();
  EXPECT_TRUE(grade.both);
  EXPECT_EQ(grade.mistakes.front(), Mistake::ratio_inverted);
  EXPECT_EQ(std::set<Mistake>(grade.mistakes.begin() + 1, grade.mistakes.end()),
            (std::set<Mistake>{Mistake::ambient_unscaled, Mistake::ambient_per_light}));
  EXPECT_TRUE(findings(Language::english, of_two, grade)[2].starts_with("or: "));
}

TEST_F(HandedIn, HasNoPowerThatAnotherOneIsNearerThan) {
  const Image picture = outside::Tracer(scene, 4, outside::Slip::exponent_fixed).picture();
  EXPECT_EQ(judged(picture, {Alteration::scaled_125_smooth}, "specular").verdict, Verdict::unknown);
  const StageGrade named = judged(grader.picture(4, Mistake::exponent_fourfold), {}, "specular");
  EXPECT_EQ(named.mistakes, std::vector<Mistake>{Mistake::exponent_fourfold});
}

/// From another eye all is smaller, and the ground goes on below.
TEST_F(HandedIn, IsNotRightWhereAnotherViewHasTheRightOneInIt) {
#ifdef ZRAKA_SANITIZED
  GTEST_SKIP() << "its pictures are too small to tell the views apart";
#endif
  const Image picture = outside::Tracer(scene, 2, outside::Slip::eye_nearer).picture();
  EXPECT_NE(judged(picture, {}, "ambient").verdict, Verdict::right);
  EXPECT_NE(judged(picture, {Alteration::desktop}, "ambient").verdict, Verdict::right);
}

TEST_F(HandedIn, IsWholeHoweverBrightItsEdgesAre) {
  const StageGrade grade =
      judged(grader.picture(3, Mistake::diffuse_sine), {Alteration::jpeg_85}, "diffuse");
  EXPECT_EQ(grade.mistakes, std::vector<Mistake>{Mistake::diffuse_sine});
  EXPECT_EQ(grade.alignment.visible, 1);
}

TEST_F(HandedIn, IsFoundToATenthOfAPixel) {
  const Image &right = grader.picture(7), moved = shifted(right, 1.3, 0.6);
  Fitted fitted = fitted_at({{}, {1.6, 0.2, 1.004, 0.997}, 1}, moved, false, kSide, kSide);
  refine(fitted, right);
  EXPECT_NEAR(fitted.placement.left, 1.3, 0.1);
  EXPECT_NEAR(fitted.placement.top, 0.6, 0.1);
  EXPECT_EQ(fitted.placement.across, 1);
}

TEST_F(HandedIn, IsMovedNoMoreWhereItIsTheWholePixelByPixel) {
  // In its own size it is the whole: there is no other source to move it from.
  const Image& right = grader.picture(7);
  for (const double shift : {0.1, 0.3, 0.6, 1.0})
    for (const double growth : {0x1p-6, 0x1p-7, 0x1p-8, 0x1p-9, 0x1p-10}) {
      const Image moved = shifted(right, shift, shift / 2);
      const double edge = -0.5 * kSide * growth;
      Fitted fitted = fitted_at({{}, {edge, edge, 1 + growth, 1 + growth}, 1}, moved, false, kSide,
                                kSide);
      refine(fitted, right);
      EXPECT_NEAR(fitted.placement.left + 0.5 * kSide * (fitted.placement.across - 1), shift, 1.5);
    }
}

TEST_F(HandedIn, LosesInAJpegWhatOthersLoseInIt) {
  const Image right = grader.picture(7);
  const std::string file = jpeg_file(right, 60);
  const std::optional<JpegTables> tables = jpeg_tables(file);
  ASSERT_TRUE(tables);
  const Image read = parse_image(file, "a.jpg").value().image;
  EXPECT_EQ(measure_errors(compressed_again(right, *tables), read, 0.5 / 255).share(), 0);
  EXPECT_GT(measure_errors(right, read, 2.5 / 255).share(), 0.1);
  EXPECT_FALSE(jpeg_tables("no JPEG"));
  EXPECT_FALSE(jpeg_tables(file.substr(0, 20)));
}

TEST_F(HandedIn, CostsMarksWhereMoreIsLeftThanWhatIsAllowed) {
  // The light's z has the wrong sign, and gamma: a fifth of the pixels differ after it was undone.
  const Image picture = with_power(grader.picture(7, Mistake::light_z_reversed), 1 / 2.2);
  const StageGrade grade = judged(picture, {});
  EXPECT_NE(grade.verdict, Verdict::right);
  EXPECT_LT(grade.marks, 1);
}

}  // namespace
}  // namespace zraka
