// SPDX-License-Identifier: Apache-2.0
// Pictures of mistakes that lie elsewhere than the right one, or have other outlines, altered.
#include <gtest/gtest.h>

#include "handed_in.hpp"
#include "outside_tracer.hpp"

namespace zraka {
namespace {

using altered::Alteration;

class ByMistakes : public HandedInPictures {
 protected:
  using HandedInPictures::HandedInPictures;

  void expect_named(Mistake mistake, int stage, const std::vector<Alteration>& how) {
    constexpr const char* kNames[] = {"",         "silhouette", "ambient",    "diffuse",
                                      "specular", "shadow",     "reflection", "refraction"};
    const StageGrade grade = judged(grader.picture(stage, mistake), how, kNames[stage]);
    std::string altered_how;
    for (const Alteration one : how)
      altered_how += std::string(altered::kNames[static_cast<std::size_t>(one)]) + ", ";
    EXPECT_EQ(grade.mistakes, std::vector<Mistake>{mistake})
        << entry_of(mistake).key << ", " << altered_how << key_of(grade.verdict);
    EXPECT_NE(grade.verdict, Verdict::unknown) << entry_of(mistake).key << ", " << altered_how;
  }
};

class ByMistakesOfTheThirdScene : public ByMistakes {
 protected:
  ByMistakesOfTheThirdScene() : ByMistakes(third_scene()) {}
};

TEST_F(ByMistakes, AnotherViewIsNamedWhereItWasCutOrFramed) {
  expect_named(Mistake::view_narrow, 7, {Alteration::crop});
  expect_named(Mistake::view_narrow, 7, {Alteration::desktop});
  expect_named(Mistake::eye_reversed, 7, {Alteration::crop});
  expect_named(Mistake::eye_reversed, 7, {Alteration::fraction, Alteration::transposed});
}

/// Twice as much is seen, and the right picture is in the middle.
TEST_F(ByMistakes, AViewThatIsTooWideIsNotRightInItsMiddle) {
  expect_named(Mistake::view_wide, 2, {Alteration::crop});
  expect_named(Mistake::view_wide, 7, {Alteration::title_bar});
  expect_named(Mistake::view_wide, 7, {Alteration::scaled_125_smooth});
}

TEST_F(ByMistakes, WhatHasOtherOutlinesIsNamed) {
  expect_named(Mistake::offset_zero, 7, {Alteration::crop, Alteration::scaled_125_smooth});
  expect_named(Mistake::light_z_reversed, 3, {Alteration::desktop, Alteration::scaled_125_smooth});
  expect_named(Mistake::mirror_sum, 7, {Alteration::scaled_any, Alteration::edges_clear});
}

TEST_F(ByMistakesOfTheThirdScene, WhatWasShiftedByAFractionIsNamed) {
  expect_named(Mistake::half_vector, 4, {Alteration::fraction});
}

TEST_F(ByMistakes, MirroredAndUpsideDownIsMirrored) {
  expect_named(Mistake::x_mirrored, 7, {Alteration::upside_down});
  expect_named(Mistake::x_mirrored, 2, {Alteration::crop});
}

/// It is right as it is turned back, and as its own stage.
TEST_F(ByMistakes, WhatIsAllowedIsRightAsNoOtherStage) {
  for (const Mistake mistake : {Mistake::y_down, Mistake::shifted}) {
    const StageGrade grade = judged(grader.picture(7, mistake), {}, "refraction");
    EXPECT_EQ(grade.verdict, Verdict::mistaken) << entry_of(mistake).key;
    EXPECT_EQ(grade.right_as, 0) << entry_of(mistake).key;
    EXPECT_EQ(grade.marks, 1) << entry_of(mistake).key;
  }
}

/// The middle of the right picture is what a narrow view shows: here more is there around it.
TEST_F(ByMistakesOfTheThirdScene, WhatWasCutAndFramedIsNoNarrowView) {
  for (const unsigned seed : {1u, 2u, 5u}) {
    altered::Random random(seed);
    altered::Altered a{outside::Tracer(scene, 3).picture()};
    altered::alter(a, Alteration::crop, random);
    altered::alter(a, Alteration::title_bar, random);
    EXPECT_NE(judged(a.image, {}, "diffuse").verdict, Verdict::mistaken) << seed;
  }
}

/// What is left has a shape: a part of a sphere that lies behind another one.
TEST_F(ByMistakesOfTheThirdScene, IsNotProbableWhereAShapeIsLeft) {
#ifdef ZRAKA_SANITIZED
  GTEST_SKIP() << "its pictures are too small for that part to be a shape";
#endif
  const Image picture = outside::Tracer(scene, 2, outside::Slip::farthest_hit).picture();
  EXPECT_EQ(judged(picture, {}, "ambient").verdict, Verdict::unknown);
  // It is too faint for a JPEG's tolerance, but rounding makes no shapes.
  EXPECT_EQ(judged(picture, {Alteration::jpeg_85}, "ambient").verdict, Verdict::unknown);
}

/// All is unlit: whatever the cause, it is the ambient stage's picture.
TEST_F(ByMistakesOfTheThirdScene, IsNotProbableWhereAllThatAStageAddsIsHidden) {
  const Image picture = outside::Tracer(scene, 5, outside::Slip::shadow_inverted).picture();
  EXPECT_EQ(judged(picture, {}, "shadow").verdict, Verdict::unknown);
}

}  // namespace
}  // namespace zraka
