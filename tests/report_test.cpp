// SPDX-License-Identifier: Apache-2.0
// The report's numbers against counts of another kind, and its words against what was counted.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>

#include "core/counted.hpp"
#include "image/alter.hpp"
#include "image/page_picture.hpp"
#include "language.hpp"
#include "scenes.hpp"
#include "school/report/archive.hpp"
#include "school/report/comments.hpp"
#include "school/report/page.hpp"

namespace zraka {
namespace {

constexpr ProfileName kProfiles[] = {ProfileName::lab, ProfileName::physical, ProfileName::spd};

SceneFacts facts_of(const Scene& scene, const RenderOptions& options) {
  return measure_stages(scene, options, [](Stage, const StagePictures&) { return Result<void>(); })
      .value();
}

RenderOptions with(ProfileName profile) {
  return {.profile = profile_of(profile)};
}

std::string all_comments(Language language, const SceneFacts& facts, Stage stage) {
  std::string all;
  for (const std::string& sentence : comments_on(language, facts, stage)) all += sentence + " ";
  return all;
}

std::string page_of(const Scene& scene, const ReportOptions& options,
                    const std::optional<ReportLetter>& letter = std::nullopt) {
  std::array<ReportPicture, 7> pictures;
  const SceneFacts facts =
      measure_stages(scene, with(options.profile), [&](Stage stage, const StagePictures& made) {
        ReportPicture& to = pictures[static_cast<std::size_t>(stage) - 1];
        to.picture = png_for_page(made.picture).value();
        if (stage != Stage::silhouette) to.changes = png_for_page(made.changes).value();
        to.brightest = made.brightest;
        return Result<void>();
      }).value();
  return report_page(facts, pictures, letter, options);
}

/// What people read: no styles, no pictures, no tags, no formulas.
std::string visible(std::string page) {
  page = std::regex_replace(page, std::regex("<style>[^]*?</style>"), " ");
  for (std::size_t at; (at = page.find("<math")) != std::string::npos;)
    page.erase(at, page.find("</math>", at) + 7 - at);
  std::string text;
  bool tag = false;
  for (const char c : page) {
    if (c == '<') tag = true;
    if (!tag) text += c;
    if (c == '>') tag = false, text += ' ';
  }
  return text;
}

TEST(Report, CountsThePixelsThatChangeInTheFiles) {
  for (const ProfileName profile : kProfiles) {
    const Scene scene = tangled_scene(60);
    RenderOptions options = with(profile);
    const SceneFacts facts = facts_of(scene, options);
    Image before;
    for (int s = 1; s <= 7; ++s) {
      options.terms = terms_of(static_cast<Stage>(s));
      const Rendering rendering = render(scene, options).value();
      const Image now = as_stored(rendering.image, options.profile.transfer, 8);
      const StageFacts& stage = facts.stages[static_cast<std::size_t>(s - 1)];
      EXPECT_EQ(stage.rays.total(), rendering.stats.rays.total());
      EXPECT_EQ(stage.points + stage.later_points, rendering.stats.rays.hits) << s;
      EXPECT_EQ(stage.entering + stage.leaving, stage.rays.refracted) << s;
      if (s > 1) {
        EXPECT_EQ(stage.change.pixels, measure_errors(before, now).over) << s;
        EXPECT_EQ(stage.change.largest, std::lround(255 * measure_errors(before, now).largest));
        EXPECT_LE(stage.change.brighter + stage.change.darker, stage.change.pixels);
      }
      std::uint64_t facing = 0, blocked = 0;
      for (const LightFacts& light : stage.lights) {
        facing += light.facing;
        blocked += light.blocked;
        EXPECT_EQ(light.facing + light.away, stage.points);
      }
      if (s == 5) {
        EXPECT_EQ(facing, stage.rays.shadow)
            << "each shadow ray starts at a point that faces a light";
        EXPECT_GE(stage.shadowed, stage.change.pixels);
        EXPECT_EQ(stage.change.darker, stage.change.pixels);
        EXPECT_GT(blocked, 0u);
      }
      before = now;
    }
  }
}

/// Everything that is counted, once more from the explanations of all pixels.
TEST(Report, CountsWhatTheExplanationsSay) {
  for (NamedScene& named : test_scenes(20)) {
    named.scene.resolution = {20, 20};
    RenderOptions options = with(ProfileName::lab);
    options.tile = 7;
    options.max_depth = 5;
    const SceneFacts facts = facts_of(named.scene, options);
    const StageFacts &shadows = facts.stages[4], &last = facts.stages[6];
    std::map<ShapeId, std::uint64_t> seen, throws, total, mirrored, through;
    std::uint64_t times = 0, ended_reflected = 0, ended_refracted = 0, unlit = 0, total_pixels = 0;
    std::vector<std::uint64_t> blocked(named.scene.lights.size());
    RenderOptions shadow_options = options;
    shadow_options.terms = terms_of(Stage::shadows);
    Explainer explainer = Explainer::create(named.scene, options).value();
    Explainer shadow_explainer = Explainer::create(named.scene, shadow_options).value();
    for (std::uint32_t y = 0; y < 20; ++y)
      for (std::uint32_t x = 0; x < 20; ++x) {
        const Explanation shadow = shadow_explainer.pixel(x, y).value();
        if (const auto& hit = shadow.trees[0].rays[0].hit) {
          ++seen[hit->shape.id];
          std::set<ShapeId> blockers;
          bool lit = false;
          for (std::size_t i = 0; i < hit->lights.size(); ++i) {
            const LightTerms& light = hit->lights[i];
            lit = lit || light.reach == Reach::lit;
            if (!light.blocker) continue;
            ++blocked[i];
            blockers.insert(light.blocker->shape.id);
          }
          unlit += !lit;
          for (const ShapeId& id : blockers) ++throws[id];
        }
        std::set<ShapeId> totals, in_mirror, behind_glass;
        std::vector<bool> bent;  // by ray: was it refracted, or one that it comes from?
        const Explanation whole = explainer.pixel(x, y).value();
        for (const ExplainedRay& ray : whole.trees[0].rays) {
          bent.push_back(ray.kind == RayKind::refracted ||
                         (ray.parent >= 0 && bent[static_cast<std::size_t>(ray.parent)]));
          if (!ray.hit) continue;
          if (ray.depth > 0 && !bent.back()) in_mirror.insert(ray.hit->shape.id);
          if (bent.back() && (!ray.hit->flipped || ray.hit->k2 == 0))
            behind_glass.insert(ray.hit->shape.id);
          if (ray.hit->refracted.absence == Absence::total) {
            ++times;
            totals.insert(ray.hit->shape.id);
          }
          ended_reflected += ray.depth == 5 && ray.hit->k1 != 0;
          ended_refracted += ray.depth == 5 && ray.hit->k2 != 0;
        }
        total_pixels += !totals.empty();
        for (const ShapeId& id : totals) ++total[id];
        for (const ShapeId& id : in_mirror) ++mirrored[id];
        for (const ShapeId& id : behind_glass) ++through[id];
      }
    const auto as_map = [](const std::vector<ShapePixels>& shapes) {
      std::map<ShapeId, std::uint64_t> map;
      for (const ShapePixels& shape : shapes) map[shape.shape.id] = shape.pixels;
      return map;
    };
    EXPECT_EQ(as_map(facts.seen), seen) << named.name;
    EXPECT_EQ(as_map(last.total.on), total) << named.name;
    EXPECT_EQ(as_map(last.mirrored), mirrored) << named.name;
    EXPECT_EQ(as_map(last.seen_through), through) << named.name;
    EXPECT_EQ(last.total.pixels, total_pixels);
    EXPECT_EQ(last.total.entering + last.total.leaving, times) << named.name;
    EXPECT_EQ(last.ended_reflected, ended_reflected) << named.name;
    EXPECT_EQ(last.ended_refracted, ended_refracted) << named.name;
    EXPECT_EQ(shadows.unlit, unlit) << named.name;
    std::map<ShapeId, std::uint64_t> thrown;
    for (const ShadowFacts& shadow : shadows.shadows) {
      thrown[shadow.by.shape.id] = shadow.by.pixels;
      EXPECT_LE(shadow.mostly_on.pixels, shadow.by.pixels);
    }
    EXPECT_EQ(thrown, throws) << named.name;
    for (std::size_t i = 0; i < blocked.size(); ++i)
      EXPECT_EQ(shadows.lights[i].blocked, blocked[i]) << named.name;
  }
}

TEST(Report, DoesNotDependOnThreadsAndTiles) {
  for (const ProfileName profile : kProfiles) {
    RenderOptions options = with(profile);
    const Scene scene = tangled_scene(50);
    const SceneFacts want = facts_of(scene, options);
    options.threads = 3;
    options.tile = 9;
    const SceneFacts found = facts_of(scene, options);
    for (const Language language : {Language::english, Language::croatian})
      for (int s = 1; s <= 7; ++s)
        EXPECT_EQ(all_comments(language, found, static_cast<Stage>(s)),
                  all_comments(language, want, static_cast<Stage>(s)));
    EXPECT_EQ(found.covered, want.covered);
  }
}

TEST(Report, MentionsNothingThatDoesNotOccur) {
  // One matt sphere before a light: no shadow, no highlight, no mirror, no glass.
  Scene scene = lab_scene(40);
  scene.lights[0].position = {0, 0, 3};
  add_sphere(scene, {0, 0, -2}, 1, {.ambient = {0.2, 0.1, 0.1}, .diffuse = {0.7, 0.2, 0.2}});
  const SceneFacts facts = facts_of(scene, with(ProfileName::lab));
  const auto said = [&](Stage stage) { return all_comments(Language::english, facts, stage); };
  const std::string same = "No pixel changes: the picture is the same as the one before. ";
  EXPECT_EQ(said(Stage::specular),
            same +
                "No shape that the eye sees has a specular share (ks = 0), so that there are no "
                "highlights. ");
  EXPECT_EQ(
      said(Stage::shadows),
      same + fmt::format("This takes {} shadow rays from points that face a light, to ask whether "
                         "anything stands in the way; blocked: 0 (0.0 %). No shadow ray hits a "
                         "shape on its way: every point that faces a light is lit by it. ",
                         facts.stages[4].rays.shadow));
  EXPECT_EQ(said(Stage::reflection), same +
                                         "No shape that the eye sees reflects (k1 = 0), so that "
                                         "there are no reflected rays. ");
  EXPECT_EQ(said(Stage::refraction), same +
                                         "No shape that the eye sees refracts (k2 = 0), so that "
                                         "there are no refracted rays. ");
}

TEST(Report, IsTrueOfScenesWithNextToNothing) {
  Scene scene = lab_scene(10);
  EXPECT_EQ(
      all_comments(Language::english, facts_of(scene, with(ProfileName::lab)), Stage::silhouette),
      "The picture takes 100 rays from the eye, one through each pixel. The scene has no "
      "shapes. No ray from the eye hits a shape, so that the picture is nothing but "
      "background. ");
  scene.lights.clear();
  add_sphere(scene, {0, 0, -2}, 50, {.reflection = 0.5, .refraction = 0.5});
  RenderOptions options = with(ProfileName::lab);
  options.max_depth = 0;
  const SceneFacts facts = facts_of(scene, options);
  const std::string same = "No pixel changes: the picture is the same as the one before. ";
  for (const Stage stage : {Stage::diffuse, Stage::specular, Stage::shadows})
    EXPECT_EQ(all_comments(Language::english, facts, stage),
              same + "The scene has no light, so that this stage has nothing to add. ");
  EXPECT_EQ(all_comments(Language::english, facts, Stage::reflection),
            same + "The depth is 0, so that rays from the eye have no successors. ");
  EXPECT_EQ(all_comments(Language::english, facts, Stage::refraction),
            same +
                "The depth of 0 is reached: points whose reflected ray is not followed: 100; "
                "whose refracted ray is not followed: 100. ");
}

TEST(Report, IsCroatianInCroatian) {
  for (NamedScene& named : test_scenes(30)) {
    named.scene.resolution = {30, 30};
    named.scene.names.clear();  // a scene's own names may be of any language
    for (const ProfileName profile : kProfiles) {
      const std::string page =
          page_of(named.scene, {Language::croatian, "", "Ana Šarić", profile},
                  ReportLetter{"Š", 23, {}, png_for_page(Image(4, 4)).value()});
      EXPECT_EQ(english_words_in(visible(page)), "") << named.name;
      EXPECT_NE(page.find("<html lang=\"hr\">"), std::string::npos);
    }
  }
}

TEST(Report, SaysWhereThisProfileClamps) {
  const auto says = [](ProfileName profile, const char* what) {
    return page_of(tangled_scene(20), {Language::english, "", "", profile}).find(what) !=
           std::string::npos;
  };
  EXPECT_TRUE(says(ProfileName::lab, "At every level each channel of the sum is limited to 0…1"));
  EXPECT_FALSE(says(ProfileName::lab, "At the end each channel"));
  EXPECT_TRUE(says(ProfileName::physical, "At the end each channel is limited to 0…1"));
  EXPECT_FALSE(says(ProfileName::physical, "At every level"));
}

TEST(Report, IsOneFileWithAllItsPictures) {
  const std::string page = page_of(tangled_scene(20), {Language::english, "s.txt", "A <b>", {}});
  std::size_t pictures = 0;
  for (std::size_t at = 0; (at = page.find("src=\"", at)) != std::string::npos; ++at) {
    EXPECT_EQ(page.compare(at, 27, "src=\"data:image/png;base64,"), 0);
    ++pictures;
  }
  EXPECT_EQ(pictures, 13u);
  EXPECT_EQ(page.find("http"), std::string::npos);
  EXPECT_NE(page.find("Author: A &lt;b&gt;"), std::string::npos);
}

TEST(Report, CountsInCroatian) {
  const auto pixels = [](std::uint64_t n) {
    return counted(Language::croatian, Counted::pixel, n);
  };
  EXPECT_EQ(pixels(1), "1 piksel");
  EXPECT_EQ(pixels(3), "3 piksela");
  EXPECT_EQ(pixels(11), "11 piksela");
  EXPECT_EQ(pixels(101), "101 piksel");
  const auto rays = [](std::uint64_t n) {
    return counted(Language::croatian, Counted::reflected, n);
  };
  EXPECT_EQ(rays(1), "1 odbijene zrake");
  EXPECT_EQ(rays(22), "22 odbijene zrake");
  EXPECT_EQ(rays(12), "12 odbijenih zraka");
  EXPECT_EQ(rays(112), "112 odbijenih zraka");
  EXPECT_EQ(counted(Language::english, Counted::time, 1), "1 time");
  EXPECT_EQ(counted(Language::english, Counted::pixel, 21), "21 pixels");
  EXPECT_EQ(decimal(Language::croatian, 7.25, 1), "7,2");
}

TEST(Report, NamesTheArchiveAfterTheAuthor) {
  EXPECT_EQ(archive_name("Ana Šarić"), "OVO-V3-Rezultati-AnaŠarić.zip");
  EXPECT_EQ(archive_name("đuro horvat-babić"), "OVO-V3-Rezultati-ĐuroHorvatBabić.zip");
  EXPECT_EQ(archive_name("../../etc/passwd"), "OVO-V3-Rezultati-EtcPasswd.zip");
  EXPECT_EQ(archive_name("a\\b\n*?\"<>|:x"), "OVO-V3-Rezultati-ABX.zip");
  EXPECT_EQ(archive_name("«Ana» × ª÷Šarić"), "OVO-V3-Rezultati-AnaŠarić.zip");
  EXPECT_EQ(archive_name("Conan O'Brien"), "OVO-V3-Rezultati-ConanOBrien.zip");
  EXPECT_EQ(archive_name(std::string(1000, 'a')).size(), 17u + 100u + 4u);
  for (const char* none : {"", " ", "..", "1234", "\xFF", "张伟"})
    EXPECT_EQ(archive_name(none), "");
  EXPECT_EQ(initial_of("Ana Šarić"), "Š");
  EXPECT_EQ(initial_of("Petar njegoš "), "Nj");
  EXPECT_EQ(initial_of("Ljubić"), "Lj");
  EXPECT_EQ(initial_of("Mia Džaja"), "Dž");
  EXPECT_EQ(initial_of("Ivo Lovrić"), "L");
  EXPECT_EQ(initial_of(""), "");
}

TEST(Report, StopsWhereItCannotGoOn) {
  std::atomic<bool> cancel{true};
  RenderOptions options;
  options.cancel = &cancel;
  const auto take = [](Stage, const StagePictures&) { return Result<void>(); };
  EXPECT_EQ(measure_stages(tangled_scene(10), options, take).error().front().message,
            "the report was cancelled");
  EXPECT_EQ(measure_stages(tangled_scene(10), {.isa = Isa::oracle}, take).error().front().message,
            "the oracle's numbers are doubles, and no picture's: it explains nothing");
  int calls = 0;
  const auto refuse = [&](Stage, const StagePictures&) -> Result<void> {
    ++calls;
    return failure("", "enough");
  };
  EXPECT_EQ(measure_stages(tangled_scene(10), {}, refuse).error().front().message, "enough");
  EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace zraka
