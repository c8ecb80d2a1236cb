// SPDX-License-Identifier: Apache-2.0
// Submissions: what is wrong with each picture, and how many points that leaves.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "course_scenes.hpp"
#include "image/alter.hpp"
#include "picture_files.hpp"
#include "school/grade/align.hpp"
#include "school/grade/submission.hpp"
#include "school/grade/words.hpp"

namespace zraka {
namespace {

/// A folder that is gone when the test is over.
struct Folder {
  std::filesystem::path path;
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "grade-XXXXXX").string();
    path = mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path); }
  std::string file(const std::string& name) const { return (path / name).string(); }
};

/// Names the cause of every mistake that can be seen in the scenes, in a form of the picture:
/// bench/grader has all forms in all scenes.
void expect_named(const std::vector<Scene>& scenes,
                  const std::function<void(const Image&, const Folder&)>& write, double least) {
  int right = 0, all = 0;
  std::string wrong;
  for (const Scene& scene : scenes) {
    const Grader grader = Grader::create(scene, lab_options()).value();
    for (const MistakeEntry& entry : lab_mistakes()) {
      // Where it shows first, in one of the scenes; the stage is known by the name.
      const int first = entry.first_stage == 1 || entry.first_stage == 5 ? 7 : entry.first_stage;
      const int stage = &scene == &scenes.back() ? first : 7;
      const Image picture = grader.picture(stage, entry.mistake);
      const Errors seen = measure_errors(picture, grader.picture(stage), 2.5 / 255);
      if (seen.share() < 0.005) continue;
      const Folder folder;
      write(picture, folder);
      for (const auto& file : std::filesystem::directory_iterator(folder.path))
        std::filesystem::rename(
            file.path(), folder.path / (std::to_string(stage) + file.path().extension().string()));
      std::ofstream(folder.file("8-letter.png")) << "no picture, and nobody looks";
      const Grade grade = grader.grade(folder.path.string());
      ASSERT_EQ(grade.stages.size(), 7u);
      const StageGrade& judged = grade.stages[static_cast<std::size_t>(stage - 1)];
      // Upside down and exchanged colours may also be undone before.
      const bool undone = judged.verdict == Verdict::right &&
                          // Upside down twice, it is as it should be.
                          (entry.mistake == Mistake::y_down ||
                           // Half of a pixel is less than what is found anyway.
                           entry.mistake == Mistake::pixel_center ||
                           (entry.mistake == Mistake::transposed && judged.alignment.transposed) ||
                           (entry.mistake == Mistake::shifted && judged.alignment.cut) ||
                           (entry.mistake == Mistake::red_and_blue && judged.alignment.swapped) ||
                           (entry.mistake == Mistake::gamma_applied &&
                            judged.alignment.curve != Alignment::Curve::none));
      const bool named = std::find(judged.mistakes.begin(), judged.mistakes.end(), entry.mistake) !=
                         judged.mistakes.end();
      ++all;
      if (named || undone)
        ++right;
      else
        wrong += fmt::format(
            "{} (stage {}, {:.1f} %) taken for {}\n", entry.key, stage, 100 * seen.share(),
            judged.mistakes.empty() ? std::to_string(static_cast<int>(judged.verdict))
                                    : std::string(entry_of(judged.mistakes[0]).key));
    }
  }
  EXPECT_GE(right, least * all) << wrong;
  EXPECT_GT(all, 40 * static_cast<int>(scenes.size()));
  testing::Test::RecordProperty("named", right);
  testing::Test::RecordProperty("of", all);
}

void save_png(const Image& image, const std::string& path) {
  ASSERT_TRUE(write_png(image, path, {8, Transfer::linear}));
}

TEST(Grade, NamesTheCauseInPng) {
  expect_named(
      {second_scene(), course_scene()},
      [](const Image& image, const Folder& f) { save_png(image, f.file("a.png")); }, 0.99);
}

TEST(Grade, NamesTheCauseInJpeg) {
#ifdef ZRAKA_SANITIZED
  GTEST_SKIP() << "takes a minute under a sanitizer, and runs no other code than its neighbours";
#endif
  expect_named(
      {course_scene()},
      [](const Image& image, const Folder& f) {
        std::ofstream(f.file("a.jpg"), std::ios::binary) << jpeg_file(image, 90);
      },
      0.95);
}

TEST(Grade, NamesTheCauseUpsideDown) {
#ifdef ZRAKA_SANITIZED
  GTEST_SKIP() << "takes a minute under a sanitizer, and runs no other code than its neighbours";
#endif
  expect_named(
      {third_scene()},
      [](const Image& image, const Folder& f) {
        save_png(flipped_vertically(image), f.file("a.png"));
      },
      0.95);
}

TEST(Grade, NamesTheCauseInAScaledScreenshot) {
  expect_named(
      {second_scene()},
      [](const Image& image, const Folder& f) {
        save_png(scaled_bilinearly(image, image.width * 5 / 4, image.height * 5 / 4),
                 f.file("a.png"));
      },
      0.95);
}

TEST(Grade, GivesFullMarksToWhatIsRight) {
  const Scene scene = course_scene();
  const Grader grader = Grader::create(scene, lab_options()).value();
  const auto expect_full = [&](const char* what, const auto& change, const char* extension) {
    const Folder folder;
    for (int stage = 1; stage <= 7; ++stage) {
      const Image image = change(grader.picture(stage));
      const std::string file = folder.file(fmt::format("slika{}.{}", stage, extension));
      if (std::string(extension) == "jpg")
        std::ofstream(file, std::ios::binary) << jpeg_file(image, 90);
      else
        save_png(image, file);
    }
    const Grade grade = grader.grade(folder.path.string());
    EXPECT_EQ(grade.marks, 7) << what << "\n" << grade_text(Language::english, grader, grade);
  };
  const auto same = [](const Image& image) { return image; };
  expect_full("png", same, "png");
  expect_full("jpeg", same, "jpg");
  expect_full("flip", flipped_vertically, "png");
  expect_full("swapped", with_red_and_blue_swapped, "png");
  expect_full(
      "scaled",
      [](const Image& image) {
        return scaled_bilinearly(image, image.width * 5 / 4, image.height * 5 / 4);
      },
      "png");
  expect_full(
      "gamma", [](const Image& image) { return with_power(image, 1 / 2.2); }, "png");
  expect_full(
      "window",
      [](const Image& image) {
        Image window(image.width + 6, image.height + 22);
        for (float& value : window.pixels) value = 0.8F;
        for (std::uint32_t y = 0; y < image.height; ++y)
          std::copy_n(image.row(y), 3 * image.width, window.row(y + 19) + 9);
        return window;
      },
      "png");
  expect_full(
      "cut off",
      [](const Image& image) { return cropped(image, 0, 9, image.width, image.height - 9); },
      "png");
}

TEST(Grade, CountsAMistakeOnce) {
  const Scene scene = course_scene();
  const Grader grader = Grader::create(scene, lab_options()).value();
  const Folder folder;
  for (int stage = 1; stage <= 7; ++stage)
    save_png(grader.picture(stage, Mistake::diffuse_sine),
             folder.file(fmt::format("{}.png", stage)));
  const Grade grade = grader.grade(folder.path.string());
  EXPECT_EQ(grade.marks, 6.5);
  EXPECT_EQ(grade.stages[2].mistakes, std::vector<Mistake>{Mistake::diffuse_sine});
  EXPECT_TRUE(grade.stages[3].repeated);
  const std::string text = grade_text(Language::croatian, grader, grade);
  EXPECT_NE(text.find("difuzna komponenta ima sinus kuta umjesto kosinusa"), std::string::npos);
}

TEST(Grade, SaysWhatIsWrongWithSubmissions) {
  const Scene scene = course_scene();
  const Grader grader = Grader::create(scene, lab_options()).value();
  const Folder folder;
  const auto problem = [&](const std::string& path) {
    const Grade grade = grader.grade(path);
    EXPECT_EQ(grade.marks, 0);
    return grade.problems.empty() ? std::string() : grade.problems.front().message;
  };
  EXPECT_EQ(problem(folder.file("nobody")), "there is no such file or folder");
  EXPECT_NE(grade_text(Language::croatian, grader, grader.grade(folder.file("nobody")))
                .find(": pogreška: nema takve datoteke ni mape\n"),
            std::string::npos);
  EXPECT_EQ(problem(folder.path.string()), "there is no picture in it");
  std::ofstream(folder.file("a.zip")) << "no archive";
  EXPECT_EQ(problem(folder.file("a.zip")), "the archive is damaged or no zip");
  std::ofstream(folder.file("7.png")) << "no picture";
  const Grade grade = grader.grade(folder.path.string());
  EXPECT_TRUE(grade.problems.empty());
  EXPECT_EQ(grade.stages.back().verdict, Verdict::unreadable);
}

TEST(Grade, RefusesALetterAlone) {
  const Scene scene = course_scene();
  const Grader grader = Grader::create(scene, lab_options()).value();
  const Folder folder;
  save_png(grader.picture(7), folder.file("slovo.png"));
  const Grade grade = grader.grade(folder.file("slovo.png"));
  ASSERT_EQ(grade.problems.size(), 1U);
  EXPECT_EQ(grade.problems.front().message,
            "'slovo.png' is called like a letter or a difference, which get no marks");
}

TEST(Grade, FindsTheStagesOfPicturesWithoutNames) {
  const Scene scene = course_scene();
  const Grader grader = Grader::create(scene, lab_options()).value();
  const Folder folder;
  const char* names[] = {"d", "a", "f", "c", "g", "b", "e"};
  for (int stage = 1; stage <= 7; ++stage)
    save_png(grader.picture(stage), folder.file(fmt::format("{}.png", names[stage - 1])));
  const Grade grade = grader.grade(folder.path.string());
  EXPECT_EQ(grade.marks, 7);
  for (const StageGrade& stage : grade.stages)
    EXPECT_EQ(stage.file, fmt::format("{}.png", names[stage.stage - 1]));
}

TEST(Grade, SaysWhichOtherStageAPictureIsRightAs) {
  const Scene scene = course_scene();
  const Grader grader = Grader::create(scene, lab_options()).value();
  const Folder folder;
  // The second once more as the third; what the fifth is called says that it has shadows.
  for (const int stage : {1, 2, 4, 6, 7})
    save_png(grader.picture(stage), folder.file(std::to_string(stage) + ".png"));
  save_png(grader.picture(2), folder.file("3.png"));
  save_png(grader.picture(7), folder.file("shadows.png"));
  const Grade grade = grader.grade(folder.path.string());
  ASSERT_EQ(grade.stages.size(), 7u);
  EXPECT_EQ(grade.marks, 5);  // none for the third, where whoever marks has to look
  const StageGrade &third = grade.stages[2], &fifth = grade.stages[4];
  EXPECT_EQ(third.right_as, 2);
  EXPECT_EQ(third.verdict, Verdict::unknown);
  EXPECT_EQ(findings(Language::english, grader, third)[0],
            "right, but as stage 2: ambient component");
  EXPECT_EQ(findings(Language::english, grader, third)[1],
            "nothing of what this stage adds can be seen");
  EXPECT_EQ(fifth.right_as, 7);
  EXPECT_EQ(findings(Language::croatian, grader, fifth)[0],
            "točno, ali kao faza 7: refraktirane zrake");
}

TEST(Submission, KnowsStagesByNames) {
  const std::pair<const char*, int> names[] = {
      {"1.png", 1},         {"v3-slika-5.jpg", 5},          {"Slika07.PNG", 7},
      {"5-shadows.png", 5}, {"refrakcija.png", 7},          {"ambijentna+difuzna.png", 3},
      {"siluete.png", 1},   {"contact-sheet.png", 8},       {"IMG_20261122.png", 0},
      {"letter.png", 8},    {"reference-3-diffuse.png", 3}, {"stage-6-reflection.png", 6},
      {"x.png", 0}};
  for (const auto& [name, stage] : names) EXPECT_EQ(stage_of_name(name), stage) << name;
}

TEST(Rubric, IsReadOrRefused) {
  const Folder folder;
  const auto read = [&](const char* text) {
    std::ofstream(folder.file("r.json")) << text;
    const Result<Rubric> rubric = read_rubric(folder.file("r.json"));
    if (rubric) return std::string("read");
    const Diagnostic& problem = rubric.error().front();
    return (problem.line > 0 ? fmt::format("{}:{}: ", problem.line, problem.column) : "") +
           problem.message;
  };
  EXPECT_EQ(read(R"({"marks": [1,1,2,2,3,3,4], "allowed": ["gamma"], "tolerance": 3})"), "read");
  EXPECT_EQ(read("[]"), "it is no JSON object");
  EXPECT_EQ(read(R"({"marks": [1]})"), "\"marks\" is not an array of seven numbers");
  EXPECT_EQ(read(R"({"share": 2})"), "\"share\" is not a number from 0 to 1");
  EXPECT_EQ(read(R"({"allowed": ["gama"]})"), "\"allowed\": there is no mistake 'gama'");
  EXPECT_EQ(read(R"({"bonus": 1})"), "there is no \"bonus\" in a rubric");
  EXPECT_EQ(read("{\n  \"once\": yes}"), "2:11: it is no JSON");
  EXPECT_EQ(read((std::string("{\"allowed\":\n[") + std::string(30000, '[')).c_str()),
            "2:64: brackets are nested more than 64 deep");
  EXPECT_EQ(read(std::string(100000, '[').c_str()), "is too large: over 65536 bytes");
  EXPECT_EQ(read(R"({"allowed": [[[["\"]"]]]]})"),
            "\"allowed\": there is no mistake '[[[\"\\\"]\"]]]'");
}

}  // namespace
}  // namespace zraka
