// SPDX-License-Identifier: Apache-2.0
// Right pictures that were altered twice on their way to the grader, each as it was not judged
// right before.
#include <gtest/gtest.h>

#include "handed_in.hpp"

namespace zraka {
namespace {

using altered::Alteration;

class AlteredTwice : public HandedInPictures {
 protected:
  AlteredTwice() : HandedInPictures(third_scene()) {}
  void expect_right(const StageGrade& grade) const {
    EXPECT_EQ(grade.verdict, Verdict::right)
        << grade.share_wrong << " " << alignment_text(Language::english, grade.alignment);
  }
};

Image on_screen(const Image& picture) {
  altered::Random random(3);
  return altered::on_desktop(picture, random);
}

/// A wide screen that is larger than what is kept loses as much across as down.
TEST_F(AlteredTwice, IsRightOnALargeScreen) {
  expect_right(judged(altered::smooth(on_screen(grader.picture(7)), 2.2, 2.2), {}));
}

/// Nearly all pixels of a picture that is hardly larger repeat themselves: that tells nothing.
TEST_F(AlteredTwice, IsNotRepeatedWhereItIsHardlyLarger) {
  const Scene first = course_scene();
  const Grader of_first = Grader::create(first, lab_options()).value();
  const auto expect_right_as = [&](const Image& picture, const std::string& name) {
    const std::string file = (folder / name).string();
    ASSERT_TRUE(write_png(picture, file, {8, Transfer::linear}));
    expect_right(of_first.grade(file).stages.front());
  };
  const Image smooth = altered::smooth(of_first.picture(7), 1.25, 1.25);
  expect_right_as(scaled_by_area(smooth, kSide + 1, kSide + 2), "refraction.png");
  const Image nearest = altered::nearest(of_first.picture(2), 1.17);
  expect_right_as(scaled_by_area(nearest, kSide + 3, kSide + 3), "ambient.png");
}

}  // namespace
}  // namespace zraka
