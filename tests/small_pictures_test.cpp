// SPDX-License-Identifier: Apache-2.0
// Pictures so small that few pixels tell mistakes apart: what is told as a fact has to be true.
#include <gtest/gtest.h>

#include "handed_in.hpp"
#include "outside_tracer.hpp"

namespace zraka {
namespace {

Scene small(Scene scene) {
  scene.resolution = {48, 48};
  return scene;
}

/// In a scene of 48×48 pixels.
class Small : public HandedInPictures {
 protected:
  explicit Small(const Scene& of = course_scene()) : HandedInPictures(small(of)) {}

  StageGrade of_jpeg(const Image& picture, int quality, const std::string& name) {
    const std::string file = (folder / (name + ".jpg")).string();
    std::ofstream(file, std::ios::binary) << jpeg_file(picture, quality);
    return grader.grade(file).stages.front();
  }
  Image outside_of(outside::Slip slip, int stage) const {
    return outside::Tracer(scene, stage, slip).picture();
  }
};
class SmallOfTwoLights : public Small {
 protected:
  SmallOfTwoLights() : Small(second_scene()) {}
};
class SmallOfTheThirdScene : public Small {
 protected:
  SmallOfTheThirdScene() : Small(third_scene()) {}
};

/// It is the first in the list but for seven pixels.
TEST_F(SmallOfTheThirdScene, HaveNoFactWhereFewPixelsTellThemApart) {
  for (const int quality : {60, 85, 95})
    EXPECT_NE(of_jpeg(outside_of(outside::Slip::farthest_hit, 2), quality, "ambient").verdict,
              Verdict::mistaken)
        << quality;
}

/// Where the picture lies as a whole it says that something is left; a hundredth larger and shifted
/// by less than a pixel that would be lost in what scaling leaves.
TEST_F(SmallOfTwoLights, LieAsAWholeWhereTheyAreNoNearerElsewhere) {
  EXPECT_NE(of_jpeg(outside_of(outside::Slip::diffuse_root, 7), 95, "refraction").verdict,
            Verdict::mistaken);
}

/// Half of what the mistake changes is left there.
TEST_F(SmallOfTheThirdScene, HaveNoFactWhereMoreThanNoiseIsLeftOfWhatTheMistakeChanges) {
  EXPECT_EQ(of_jpeg(outside_of(outside::Slip::diffuse_wrapped, 3), 60, "diffuse").verdict,
            Verdict::unknown);
  for (const int quality : {85, 95})
    EXPECT_EQ(
        of_jpeg(outside_of(outside::Slip::shadow_of_first_only, 7), quality, "refraction").verdict,
        Verdict::unknown)
        << quality;
}

TEST_F(SmallOfTheThirdScene, HaveFactsWhereTheyAreTrue) {
  for (const Mistake mistake :
       {Mistake::first_hit, Mistake::diffuse_sine, Mistake::half_vector, Mistake::shadow_half})
    for (const int quality : {60, 85, 95}) {
      const StageGrade grade = of_jpeg(grader.picture(7, mistake), quality, "refraction");
      EXPECT_EQ(grade.verdict, Verdict::mistaken) << entry_of(mistake).key << " " << quality;
      EXPECT_EQ(grade.mistakes, std::vector<Mistake>{mistake}) << entry_of(mistake).key;
    }
}

}  // namespace
}  // namespace zraka
