// SPDX-License-Identifier: Apache-2.0
// Right pictures that were altered twice on their way to the grader, each as it was not judged
// right before.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "handed_in.hpp"
#include "school/grade/align.hpp"
#include "school/grade/refine.hpp"
#include "school/grade/unpainted.hpp"

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

/// Whole pixels lose nothing by their scaling, and are the nearest where only that is seen.
TEST_F(AlteredTwice, IsFoundWhereItLiesByTenthsOfAPixel) {
  for (const int stage : {4, 6}) {
    const StageGrade grade = judged(shifted(grader.picture(stage), 0.92, 0.84), {},
                                    stage == 4 ? "specular" : "reflection");
    expect_right(grade);
    EXPECT_NEAR(grade.alignment.left, 0.92, 0.03);
    EXPECT_NEAR(grade.alignment.top, 0.84, 0.03);
  }
}

/// A window's corners are round, and what lies behind it shows there: that leaves nothing, and what
/// is as dark at other places does.
TEST_F(AlteredTwice, MayHaveRoundCorners) {
  const Image& right = grader.picture(5);
  const Region whole{0, 0, kSide, kSide};
  Closeness close{};
  close.tolerance = 3.0F / 255;
  close.blur = 1;
  const auto rest = [&](const Image& picture) {
    return rest_of(smoothed(picture, close.blur), right, whole, close);
  };
  const double radius = 0.035 * kSide;
  Image round = right;
  for (std::uint32_t y = 0; y < kSide; ++y)
    for (std::uint32_t x = 0; x < kSide; ++x) {
      const double across = std::max(radius - std::min(x + 0.5, kSide - x - 0.5), 0.0);
      const double down = std::max(radius - std::min(y + 0.5, kSide - y - 0.5), 0.0);
      if (std::hypot(across, down) > radius)
        std::fill_n(round.row(y) + std::size_t{3} * x, 3, 0.9F);
    }
  EXPECT_EQ(rest(round).solid, 0);
  EXPECT_LT(rest(round).share, 0.001);
  Image marked = right;
  for (std::uint32_t y = kSide / 2; y < kSide / 2 + 5; ++y)
    std::fill_n(marked.row(y), 15, 0.9F);
  EXPECT_GT(rest(marked).solid, 0);
}

/// Where so little is lost that outlines are alike.
TEST_F(AlteredTwice, IsFoundWhereItLiesByHundredthsOfAPixel) {
  for (const double by : {2.02, 2.04})
    expect_right(judged(shifted(grader.picture(4), by, 2.03), {}, "specular"));
}

/// What a screen scales by repeating pixels loses nothing where others are repeated alike.
TEST_F(AlteredTwice, RepeatsThePixelsThatAWindowRepeated) {
#ifdef ZRAKA_SANITIZED
  GTEST_SKIP() << "its pictures are too small";
#endif
  for (const int stage : {3, 5, 7}) {
    const Image& right = grader.picture(stage);
    altered::Random random(2);
    const Image window = altered::nearest(altered::framed(right, random), 1.17);
    // By outlines alone.
    const double left = 0.5 * (window.width - 1.17 * kSide),
                 top = window.height - left - 1.17 * kSide;
    Fitted fitted =
        fitted_at({{}, {left + 0.4, top + 0.7, 1.168, 1.173}, 1}, window, false, kSide, kSide);
    refine(fitted, right);
    EXPECT_LT(mean_square(fitted.image, through_scaling(right, fitted), fitted.region), 4e-5)
        << stage;
  }
}

/// Clear edges are none of the picture, and do not pull at it.
TEST_F(AlteredTwice, IsFoundBesideClearEdges) {
  const Scene second = second_scene();
  const Grader of_second = Grader::create(second, lab_options()).value();
  for (const auto& [right, down] : {std::pair(1.3, 2.9), std::pair(1.4, 1.75)}) {
    altered::Random random(1);
    altered::Altered a{shifted(of_second.picture(4), right, down)};
    altered::alter(a, Alteration::edges_clear, random);
    const std::string file = (folder / "specular.png").string();
    ASSERT_TRUE(write_png(a.image, file, {8, Transfer::linear}));
    const StageGrade grade = of_second.grade(file).stages.front();
    expect_right(grade);
    EXPECT_NEAR(grade.alignment.left, right, 0.05);
  }
}

TEST_F(AlteredTwice, HasClearEdgesInAJpeg) {
  const Scene second = second_scene();
  const Grader of_second = Grader::create(second, lab_options()).value();
  altered::Random random(1);
  altered::Altered a{of_second.picture(5)};
  altered::alter(a, Alteration::edges_clear, random);
  const std::string file = (folder / "shadow.jpg").string();
  std::ofstream(file, std::ios::binary) << jpeg_file(a.image, 60);
  expect_right(of_second.grade(file).stages.front());
}

TEST_F(AlteredTwice, IsRightWithAGridInAJpeg) {
#ifdef ZRAKA_SANITIZED
  GTEST_SKIP() << "its pictures are too small";
#endif
  for (const Alteration quality : {Alteration::jpeg_85, Alteration::jpeg_60})
    for (const auto& [stage, name] : {std::pair(3, "diffuse"), std::pair(5, "shadow")}) {
      const StageGrade grade = judged(grader.picture(stage), {Alteration::grid, quality}, name);
      expect_right(grade);
      EXPECT_TRUE(grade.alignment.unpainted);
      EXPECT_NEAR(grade.alignment.across, 1.25, 1e-6);
      EXPECT_LT(grade.share_wrong, 0.01);
    }
  const StageGrade wrong =
      judged(grader.picture(7, Mistake::diffuse_sine), {Alteration::grid, Alteration::jpeg_60});
  EXPECT_EQ(wrong.mistakes, std::vector<Mistake>{Mistake::diffuse_sine});
  const StageGrade turned =
      judged(grader.picture(7), {Alteration::transposed, Alteration::grid, Alteration::jpeg_60});
  expect_right(turned);
}

/// Where a screen of any scale leaves lines, which a JPEG's blocks and a picture's own are not.
TEST_F(AlteredTwice, KnowsUnpaintedLinesByWhereTheyLie) {
  const Image right = grader.picture(7);
  for (const double scale : {1.2, 1.25, 1.5, 1.75}) {
    const auto at = [&](std::uint32_t i) { return static_cast<std::uint32_t>(i * scale); };
    Image lines(at(right.width), at(right.height));
    for (float& value : lines.pixels) value = 0.9F;
    for (std::uint32_t y = 0; y < right.height; ++y)
      for (std::uint32_t x = 0; x < right.width; ++x)
        std::copy_n(right.row(y) + std::size_t{3} * x, 3,
                    lines.row(at(y)) + std::size_t{3} * at(x));
    const std::string file = jpeg_file(lines, 85);
    const std::optional<UnpaintedLines> found =
        find_unpainted(parse_image(file, "a.jpg").value().image, jpeg_tables(file).value());
    ASSERT_TRUE(found) << scale;
    EXPECT_EQ(found->columns.size(), right.width) << scale;
    EXPECT_EQ(found->rows.size(), right.height) << scale;
    for (std::uint32_t x = 0; x < found->columns.size(); ++x)
      ASSERT_EQ(found->columns[x], at(x)) << scale;
    EXPECT_NEAR(found->color[1], 0.9, 0.02) << scale;
  }
  for (const int quality : {20, 60, 85}) {
    const std::string file = jpeg_file(on_screen(right), quality);
    EXPECT_FALSE(
        find_unpainted(parse_image(file, "a.jpg").value().image, jpeg_tables(file).value()))
        << quality;
  }
}

}  // namespace
}  // namespace zraka
