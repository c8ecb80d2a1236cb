// SPDX-License-Identifier: Apache-2.0
#include "school/generate/letter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <zraka/zraka.hpp>

namespace zraka {
namespace {

TEST(Letter, IsThereForEverySurname) {
  for (const char* text : {"A", "Č", "Ć", "Đ", "Š", "Ž", "Đorđić", "I i"})
    for (const Packing packing : {Packing::strokes, Packing::fill}) {
      const Result<Scene> scene = generate_letter(text, {.packing = packing});
      ASSERT_TRUE(scene) << text << to_string(scene.error().front());
      EXPECT_GE(scene->spheres.size(), 3u) << text;
      EXPECT_TRUE(check(*scene).empty()) << text;
    }
}

TEST(Letter, CanBeALongText) {
  EXPECT_GT(generate_letter("ABCDEFGHIJKLMNOPQRSTUVWXYZ abcdefghijklmnopqrstuvwxyz", {})
                .value()
                .spheres.size(),
            200u);
}

TEST(Letter, HasMoreSpheresWithACaron) {
  EXPECT_GT(generate_letter("Č", {}).value().spheres.size(),
            generate_letter("C", {}).value().spheres.size() + 2);
}

TEST(Letter, HasSpheresThatDoNotMeet) {
  for (const Packing packing : {Packing::strokes, Packing::fill}) {
    const Scene scene = generate_letter("Š", {.packing = packing}).value();
    for (std::size_t i = 0; i < scene.spheres.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Sphere &a = scene.spheres[i].shape, &b = scene.spheres[j].shape;
        EXPECT_GT(std::hypot(a.center.x - b.center.x, a.center.y - b.center.y),
                  0.97 * (a.radius + b.radius));
      }
  }
}

TEST(Letter, IsFramedInTheWindow) {
  Scene scene = generate_letter("Ž", {.resolution = 64}).value();
  RenderOptions options{.terms = terms_of(Stage::silhouette),
                        .profile = profile_of(ProfileName::lab)};
  const Image image = render(scene, options).value().image;
  int white = 0;
  for (std::uint32_t i = 0; i < 64; ++i) {
    EXPECT_EQ(image.row(0)[3 * i], 0) << "the upper edge is empty";
    EXPECT_EQ(image.row(63)[3 * i], 0) << "the lower edge is empty";
    EXPECT_EQ(image.row(i)[0], 0) << "the left edge is empty";
    EXPECT_EQ(image.row(i)[3 * 63], 0) << "the right edge is empty";
    for (std::uint32_t x = 0; x < 64; ++x) white += image.row(i)[3 * x] > 0;
  }
  EXPECT_GT(white, 64 * 64 / 8);
}

TEST(Letter, HasVariedMaterials) {
  const Scene scene = generate_letter("M", {}).value();
  int mirrors = 0, glasses = 0, matt = 0;
  for (const Material& m : scene.materials) {
    mirrors += m.reflection.r >= 0.5;
    glasses += m.refraction.r > 0;
    matt += m.reflection == 0 && m.refraction == 0;
    EXPECT_LE(m.reflection.r + m.refraction.r, 1);
  }
  EXPECT_GT(mirrors, 0);
  EXPECT_GT(glasses, 0);
  EXPECT_GT(matt, 0);
}

TEST(Letter, CanBeWrittenInTheLabsFormatAndRead) {
  const Scene scene = generate_letter("Z", {}).value();
  const ReadScene read = parse_scene(write_lab_input(scene).value(), "letter.txt").value();
  EXPECT_TRUE(read.warnings.empty());
  EXPECT_EQ(read.scene.spheres.size(), scene.spheres.size());
  EXPECT_EQ(read.scene.materials, scene.materials);
}

TEST(Letter, ThatCannotBeDrawnSaysWhy) {
  const auto error = [](const std::string& text, LetterOptions options = {}) {
    const Result<Scene> scene = generate_letter(text, options);
    return scene ? std::string("drawn") : scene.error().front().message;
  };
  EXPECT_EQ(error(""), "the text has no visible letter");
  EXPECT_EQ(error("  "), "the text has no visible letter");
  EXPECT_EQ(error("\xFF"), "the text is not UTF-8");
  EXPECT_EQ(error("\U0010FFFF"), "has no glyph for U+10FFFF");
  EXPECT_EQ(error(std::string(65, 'a')), "the text has 65 characters: 64 at most");
  EXPECT_EQ(error("A", {.font = "/nowhere.ttf"}), "is no font file that can be read");
}

}  // namespace
}  // namespace zraka
