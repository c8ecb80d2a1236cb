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

}  // namespace
}  // namespace zraka
