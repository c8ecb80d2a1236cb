// SPDX-License-Identifier: Apache-2.0
// Pictures of all kinds against each other, and what is said of them.
#include <gtest/gtest.h>

#include <cmath>
#include <zraka/compare.hpp>

#include "compare/words.hpp"
#include "patterns.hpp"

namespace zraka {
namespace {

ReadImage integers(const Image& image, Transfer transfer, int bits = 8) {
  return parse_image(encode_png(image, {bits, transfer}).value(), "a").value();
}
ReadImage floats(const Image& image) {
  return {.image = image, .format = "OpenEXR", .bits = 32, .floats = true};
}

TEST(Compare, TakesAPictureAndItsCopyInAnotherKindForEqual) {
  const Image light = pattern();
  EXPECT_EQ(compare(integers(light, Transfer::srgb), floats(light))->errors.largest, 0);
  EXPECT_EQ(compare(floats(light), integers(light, Transfer::srgb, 16))->errors.largest, 0);
  EXPECT_EQ(
      compare(floats(light), integers(light, Transfer::linear), {.transfer = Transfer::linear})
          ->errors.largest,
      0);
  const Comparison depths =
      compare(integers(light, Transfer::srgb), integers(light, Transfer::srgb, 16)).value();
  EXPECT_EQ(depths.bits, 8);
  EXPECT_LE(depths.errors.largest, 1.001 / 255);
  EXPECT_LT(depths.errors.share(), 0.01) << "a value on the verge may be rounded twice";
}

TEST(Compare, TellsWhenTheOtherCurveFits) {
  const Image light = pattern();
  const Comparison wrong = compare(floats(light), integers(light, Transfer::linear)).value();
  EXPECT_GT(wrong.errors.largest, 0.1);
  EXPECT_EQ(wrong.better_by_other_transfer, 0.0);
  EXPECT_EQ(compare(floats(light), integers(light, Transfer::srgb))->better_by_other_transfer,
            std::nullopt);
}

TEST(Compare, ComparesFloatsAsTheyAre) {
  Image a = pattern(), b = pattern();
  a.pixels[300] = 7;
  b.pixels[300] = 9;
  b.pixels[9] = std::nextafter(b.pixels[9], 2.0f);
  const Comparison c = compare(floats(a), floats(b)).value();
  EXPECT_EQ(c.errors.over, 2u);
  EXPECT_EQ(c.errors.largest, 2);
  EXPECT_LT(c.flip.largest, 0.01) << "both are white on a screen";
}

TEST(Compare, IsWithinToleranceAndShare) {
  Image a(10, 10), b(10, 10);
  for (std::size_t i = 0; i < 6; ++i) b.pixels[3 * i] = 3 / 255.0f;
  const auto within = [&](double tolerance, double allow) {
    return compare(integers(a, Transfer::linear), integers(b, Transfer::linear),
                   {.tolerance = tolerance, .allow = allow})
        ->within;
  };
  EXPECT_FALSE(within(0, 0));
  EXPECT_FALSE(within(2, 0));
  EXPECT_TRUE(within(3, 0));
  EXPECT_FALSE(within(2.9, 0.05));
  EXPECT_TRUE(within(2.9, 0.06));
  EXPECT_TRUE(within(0, 1));
}

TEST(Compare, RefusesPicturesOfDifferentSizes) {
  const Result<Comparison> c =
      compare(integers(Image(4, 3), Transfer::linear), integers(Image(3, 4), Transfer::linear));
  ASSERT_FALSE(c);
  EXPECT_EQ(c.error().front().message, "the pictures have different sizes: 4×3 and 3×4");
}

TEST(Compare, SaysInOneSentence) {
  Image a(10, 10), b(10, 10);
  const auto verdict = [&](CompareOptions options) {
    return verdict_on(
        compare(integers(a, Transfer::linear), integers(b, Transfer::linear), options).value());
  };
  EXPECT_EQ(verdict({}), "The pictures are equal.");
  b.pixels[0] = b.pixels[3] = 3 / 255.0f;
  EXPECT_EQ(verdict({}), "2 of 100 pixels (2 %) differ.");
  EXPECT_EQ(verdict({.tolerance = 2, .allow = 0.01}),
            "2 of 100 pixels (2 %) differ by more than 2 of 255; 1 % are allowed.");
  EXPECT_EQ(verdict({.tolerance = 4}),
            "The pictures differ by at most 3 of 255, within the tolerance of 4.");
}

TEST(Page, HoldsAllThatItNeedsAndEscapesNames) {
  const Comparison c =
      compare(integers(pattern(), Transfer::linear), integers(changed_pattern(), Transfer::linear))
          .value();
  const std::string page =
      comparison_page(c, "<script>alert(1)</script>\".png", "b\xFF&\x1B.png").value();
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_NE(page.find("&lt;script&gt;alert(1)&lt;/script&gt;&quot;.png"), std::string::npos);
  EXPECT_NE(page.find("b\xEF\xBF\xBD&amp;\xEF\xBF\xBD.png"), std::string::npos);
  EXPECT_EQ(page.find("{{"), std::string::npos);
  EXPECT_EQ(page.find("http:"), std::string::npos);
  EXPECT_EQ(page.find("https:"), std::string::npos);
  std::size_t pictures = 0;
  for (std::size_t at = 0;
       (at = page.find("src=\"data:image/png;base64,iVBOR", at + 1)) != std::string::npos;)
    ++pictures;
  EXPECT_EQ(pictures, 4u);
  EXPECT_EQ(comparison_page(c, "a", "b").value(), comparison_page(c, "a", "b").value());
}

}  // namespace
}  // namespace zraka
