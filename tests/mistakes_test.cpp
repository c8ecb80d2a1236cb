// SPDX-License-Identifier: Apache-2.0
// Pictures with mistakes: from which stage on they show, and that they are explained.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "course_scenes.hpp"
#include "explain/json.hpp"
#include "fold.hpp"
#include "image/alter.hpp"
#include "language.hpp"
#include "school/grade/words.hpp"

namespace zraka {
namespace {

TEST(Mistakes, AreNamedInBothLanguages) {
#define ZRAKA_MISTAKE(...) +1
  constexpr std::size_t kMistakes = 0
#include <zraka/school/mistakes.def>
      ;
#undef ZRAKA_MISTAKE
  ASSERT_EQ(all_mistakes().size(), kMistakes);
  std::set<std::string_view> words;
  for (const MistakeEntry& entry : all_mistakes()) {
    for (const std::string_view word : {entry.key, entry.english, entry.croatian}) {
      EXPECT_FALSE(word.empty()) << entry.key;
      EXPECT_TRUE(words.insert(word).second) << "twice: " << word;
    }
    EXPECT_EQ(mistake_named(entry.key), entry.mistake);
    EXPECT_EQ(&entry_of(entry.mistake), &entry);
    EXPECT_EQ(english_words_in(entry.croatian), "") << entry.croatian;
  }
  EXPECT_FALSE(mistake_named("none"));
}

TEST(Mistakes, OfNoneIsTheRightPicture) {
  const Scene scene = second_scene();
  RenderOptions options = lab_options();
  const Image right = render(scene, options).value().image;
  // What cannot be seen leaves every bit as it is, by the kernel that makes mistakes.
  Scene plain = scene;
  for (Material& material : plain.materials) material.refraction = material.reflection = 0;
  const std::string all = sha256(render(plain, options).value().image);
  const auto clamped = [&](const Scene& of) {
    return sha256(render_mistaken(of, options, Mistake::total_clamped).value().image);
  };
  EXPECT_EQ(clamped(plain), all);
  EXPECT_NE(clamped(scene), sha256(right));
}

TEST(Mistakes, AreTheSameBitsWhateverTheInstructionSet) {
  Scene scene = second_scene();
  scene.resolution = {41, 37};  // rows end in the middle of registers
  RenderOptions options = lab_options();
  for (const MistakeEntry& entry : all_mistakes()) {
    std::set<std::string> hashes;
    for (const Isa isa : available_isas()) {
      options.isa = isa;
      hashes.insert(sha256(render_mistaken(scene, options, entry.mistake).value().image));
    }
    EXPECT_EQ(hashes.size(), 1U) << entry.key;
  }
}

TEST(Mistakes, ShowFromTheirStageOn) {
#ifdef ZRAKA_SANITIZED
  GTEST_SKIP() << "takes a minute under a sanitizer, and runs no other code than its neighbours";
#endif
  const Scene scenes[] = {course_scene(), second_scene(), third_scene()};
  for (const MistakeEntry& entry : lab_mistakes()) {
    bool seen = false;
    for (const Scene& scene : scenes)
      for (int stage = 1; stage <= 7; ++stage) {
        const RenderOptions options = lab_options(static_cast<Stage>(stage));
        const auto stored = [&](Mistake mistake) {
          return sha256(as_stored(render_mistaken(scene, options, mistake).value().image,
                                  Transfer::linear, 8));
        };
        const bool differs = stored(entry.mistake) != stored(Mistake::none);
        seen = seen || differs;
        EXPECT_TRUE(!differs || stage >= entry.first_stage) << entry.key << " in stage " << stage;
      }
    EXPECT_TRUE(seen) << entry.key;
  }
}

TEST(Mistakes, AreExplainedToTheBit) {
  const Scene scenes[] = {course_scene(), second_scene(), third_scene()};
  std::uint32_t at = 7;
  for (const MistakeEntry& entry : lab_mistakes())
    for (const Scene& scene : scenes) {
      const RenderOptions options = lab_options();
      const Image image = render_mistaken(scene, options, entry.mistake).value().image;
      Explainer explainer = mistaken_explainer(scene, options, entry.mistake).value();
      for (int i = 0; i < 12; ++i) {
        at = at * 1664525u + 1013904223u;
        const std::uint32_t x = (at >> 8) % kSide, y = (at >> 20) % kSide;
        const Result<Explanation> e = explainer.pixel(x, y);
        ASSERT_TRUE(e) << entry.key << ": " << to_string(e.error().front());
        const float* pixel = image.row(y) + 3 * x;
        for (std::size_t c = 0; c < 3; ++c)
          EXPECT_EQ(e->color[c], pixel[c]) << entry.key << " (" << x << ", " << y << ")";
        // Half of a light is told as none, and a byte that overflows only at the end.
        if (entry.mistake == Mistake::shadow_half || entry.mistake == Mistake::bytes_overflow)
          continue;
        const nlohmann::json json = nlohmann::json::parse(to_json(*e, "", "", ""));
        Image one(1, 1);
        const Float3 color = Fold{json, entry.mistake}.color();
        std::copy(color.begin(), color.end(), one.pixels.begin());
        if (entry.mistake == Mistake::red_and_blue) std::swap(one.pixels[0], one.pixels[2]);
        for (std::size_t c = 0; c < 3; ++c) {
          if (entry.mistake != Mistake::gamma_applied) {
            EXPECT_EQ(one.pixels[c], pixel[c]) << entry.key << " (" << x << ", " << y << ")";
          }
        }
      }
    }
}

}  // namespace
}  // namespace zraka
