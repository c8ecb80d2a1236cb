// SPDX-License-Identifier: Apache-2.0
// The page of a pixel, as far as it can be judged without a browser (explain_page.sh has one).
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "explain/page.hpp"
#include "language.hpp"
#include "scenes.hpp"

namespace zraka {
namespace {

std::string page_of(Scene scene, const RenderOptions& options, std::uint32_t x, std::uint32_t y,
                    const PageOptions& page = {}) {
  Explainer explainer = Explainer::create(scene, options).value();
  const Explanation explanation = explainer.pixel(x, y).value();
  return to_page(scene, explanation,
                 {picture_for_page(scene, options).value(), explainer.around(x, y, 15)}, page)
      .value();
}

RenderOptions with(ProfileName profile, Stage stage = Stage::refraction) {
  return {.terms = terms_of(stage), .profile = profile_of(profile)};
}

std::string between(const std::string& text, const std::string& start, const std::string& end) {
  const std::size_t at = text.find(start);
  if (at == std::string::npos) return "";
  const std::size_t from = at + start.size();
  return text.substr(from, text.find(end, from) - from);
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size())
    ++count;
  return count;
}

/// The page without scripts and styles: what people read, and its tags.
std::string visible(std::string page) {
  for (const char* tag : {"script", "style"})
    for (std::size_t at; (at = page.find(std::string("<") + tag)) != std::string::npos;) {
      const std::string end = std::string("</") + tag + ">";
      page.erase(at, page.find(end, at) + end.size() - at);
    }
  return page;
}

/// What is wrong with the nesting of tags; "" if nothing is.
std::string nesting(const std::string& page) {
  const std::set<std::string> empty = {"meta", "img", "input", "!DOCTYPE"};
  std::vector<std::string> open;
  for (std::size_t at = 0; (at = page.find('<', at)) != std::string::npos; ++at) {
    const std::size_t end = page.find_first_of(" >", at);
    const std::string name = page.substr(at + 1, end - at - 1);
    if (empty.contains(name)) continue;
    if (!name.starts_with('/')) {
      open.push_back(name);
    } else {
      if (open.empty() || open.back() != name.substr(1))
        return "</" + name.substr(1) + "> closes " + (open.empty() ? "nothing" : open.back());
      open.pop_back();
    }
  }
  return open.empty() ? "" : open.back() + " is open";
}

TEST(ExplainPage, HoldsEachRayOnce) {
  const RenderOptions options = with(ProfileName::lab);
  const Scene scene = tangled_scene(60);
  // The scene's random numbers come in another order with another compiler.
  std::uint32_t x = 0;
  while (x < 59 && explain(scene, options, x, 30)->trees[0].rays.size() <= 5) ++x;
  const Explanation e = explain(scene, options, x, 30).value();
  const std::string page = page_of(scene, options, x, 30);
  ASSERT_GT(e.trees[0].rays.size(), 5u);
  EXPECT_EQ(count_of(page, "<details"), e.trees[0].rays.size());
  for (std::size_t r = 0; r < e.trees[0].rays.size(); ++r)
    EXPECT_EQ(count_of(page, "id=\"t0r" + std::to_string(r) + "\""), 1u);
  const auto data = nlohmann::json::parse(
      between(page, "<script type=\"application/json\" id=\"space-data\">", "</script>"));
  std::set<std::string> drawn;
  for (const auto& ray : data["rays"])
    if (ray["kind"].get<int>() < 3) drawn.insert(ray["ray"].get<std::string>());
  EXPECT_EQ(drawn.size(), e.trees[0].rays.size());
  EXPECT_EQ(data["shapes"].size(), scene.spheres.size());
}

TEST(ExplainPage, IsWellFormedAndAlone) {
  for (const NamedScene& named : test_scenes(50))
    for (const ProfileName profile : {ProfileName::lab, ProfileName::physical, ProfileName::spd})
      for (const Stage stage : {Stage::silhouette, Stage::diffuse, Stage::refraction}) {
        const std::string page = page_of(named.scene, with(profile, stage), 25, 20,
                                         {.scene = "scene.txt", .profile = profile});
        EXPECT_EQ(nesting(visible(page)), "") << named.name;
        EXPECT_EQ(count_of(page, "<img"), 2u);
        EXPECT_EQ(count_of(page, "src=\"data:image/png;base64,iVBOR"), 2u);
        for (const char* outside : {"<link", "@import", "url(", "src=\"http", "fetch("})
          EXPECT_EQ(count_of(page, outside), 0u) << outside;
      }
}

TEST(ExplainPage, HasNoEnglishWordInCroatian) {
  for (NamedScene named : test_scenes(50)) {
    named.scene.names.clear();
    for (const ProfileName profile : {ProfileName::lab, ProfileName::spd}) {
      const std::string page =
          visible(page_of(named.scene, with(profile), 25, 20,
                          {.language = Language::croatian, .scene = "x.txt", .profile = profile}));
      EXPECT_NE(page.find("<html lang=\"hr\">"), std::string::npos);
      std::string text;
      bool in_tag = false;
      for (const char c : page) {
        if (c == '<') in_tag = true;
        if (!in_tag) text += c;
        if (c == '>') in_tag = false, text += ' ';
      }
      for (const char* attribute : {"alt=\"", "aria-label=\""})
        for (std::size_t at = 0; (at = page.find(attribute, at)) != std::string::npos; ++at)
          text += between(page.substr(at), attribute, "\"") + " ";
      EXPECT_EQ(english_words_in(text), "") << named.name;
    }
  }
}

TEST(ExplainPage, CannotBeBrokenByNames) {
  Scene scene = lab_scene(50);
  add_sphere(scene, {0, 0, -1}, 1, {});
  scene.names[{0, 0}] = "</script><script>alert(1)</script>";
  const std::string page = page_of(scene, with(ProfileName::lab), 25, 25,
                                   {.scene = "<img src=x onerror=alert(1)>\"&\xFF.txt"});
  EXPECT_EQ(count_of(page, "alert(1)</script>"), 0u);
  EXPECT_EQ(count_of(page, "<img src=x"), 0u);
  EXPECT_EQ(nesting(visible(page)), "");
  EXPECT_NE(page.find("&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;"), std::string::npos);
}

TEST(ExplainPage, RefusesTreesThatNobodyCanRead) {
  Scene scene = lab_scene(10);
  add_sphere(scene, {0, 0, 2}, 10, {.reflection = 0.5, .refraction = 0.5, .ior = 1});
  add_sphere(scene, {0, 0, 2}, 30, {.reflection = 0.5, .refraction = 0.5, .ior = 1});
  RenderOptions options = with(ProfileName::lab);
  options.max_depth = 16;
  const Explanation e = explain(scene, options, 5, 5).value();
  ASSERT_GT(e.trees[0].rays.size(), kMaxPageRays);
  const Result<std::string> page = to_page(scene, e, {Image(1, 1), {0, 0, Image(1, 1)}}, {});
  ASSERT_FALSE(page);
  EXPECT_EQ(to_string(page.error().front()),
            "error: the ray tree of pixel (5, 5) has " + std::to_string(e.trees[0].rays.size()) +
                " rays: a page shows 2048 at most\n"
                "  ask for fewer levels with a smaller depth, or for JSON\n");
}

TEST(ExplainPage, ShowsThePicturesOwnPixels) {
  for (const ProfileName profile : {ProfileName::lab, ProfileName::physical, ProfileName::spd}) {
    Scene scene = tangled_scene(40);
    const RenderOptions options = with(profile);
    const Image image = render(scene, options).value().image;
    Explainer explainer = Explainer::create(scene, options).value();
    for (const auto& [x, y, left, top] :
         {std::tuple{20u, 20u, 13u, 13u}, {0u, 39u, 0u, 25u}, {39u, 3u, 25u, 0u}}) {
      const Neighbourhood near = explainer.around(x, y, 15);
      EXPECT_EQ(near.left, left);
      EXPECT_EQ(near.top, top);
      ASSERT_EQ(near.image.width, 15u);
      ASSERT_EQ(near.image.height, 15u);
      for (std::uint32_t j = 0; j < 15; ++j)
        for (std::uint32_t i = 0; i < 45; ++i)
          ASSERT_EQ(near.image.row(j)[i], image.row(top + j)[3 * left + i]);
    }
    EXPECT_EQ(picture_for_page(scene, options).value().pixels, image.pixels);
    EXPECT_EQ(explainer.around(3, 3, 63).image.width, 40u);
  }
}

TEST(ExplainPage, ShowsLargePicturesSmaller) {
  Scene scene = lab_scene(4);
  scene.resolution = {6000, 20};
  const Image image = picture_for_page(scene, with(ProfileName::lab)).value();
  EXPECT_EQ(image.width, 560u);
  EXPECT_EQ(image.height, 1u);
  EXPECT_EQ(scene.resolution.width, 6000u) << "the scene is as it was";
}

}  // namespace
}  // namespace zraka
