// SPDX-License-Identifier: Apache-2.0
// What people hand in, by right and otherwise: names, links, sizes, and pictures of nothing.
#include "school/grade/submission.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "course_scenes.hpp"
#include "image/alter.hpp"
#include "picture_files.hpp"
#include "school/grade/words.hpp"
#include "school/report/archive.hpp"

namespace zraka {
namespace {

namespace fs = std::filesystem;

class Submissions : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "submission-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
  }
  /// Names and stages of what is found, or what is wrong.
  static std::string found(const std::string& path, Links links = Links::follow) {
    const Result<std::vector<SubmittedPicture>> pictures = read_submission(path, links);
    if (!pictures) return pictures.error().front().message;
    std::string text;
    for (const SubmittedPicture& picture : *pictures) {
      text += fmt::format("{}{}:{}", text.empty() ? "" : " ", picture.file, picture.stage);
      if (!picture.problems.empty()) text += " " + picture.problems.front().message;
    }
    return text;
  }
  fs::path folder_;
};

/// An archive with other bytes for the letters @ of its names, and the flag that says UTF-8.
std::string named_anew(std::string zip, const std::string& bytes, bool utf8) {
  for (std::size_t at = zip.find("@@"); at != std::string::npos; at = zip.find("@@", at + 2))
    zip.replace(at, 2, bytes);
  const auto flag = [&](const char* signature, std::size_t offset) {
    for (std::size_t at = zip.find(signature); at != std::string::npos;
         at = zip.find(signature, at + 4))
      zip[at + offset] = static_cast<char>(utf8 ? zip[at + offset] | 8 : zip[at + offset] & ~8);
  };
  flag("PK\3\4", 7);
  flag("PK\1\2", 9);
  return zip;
}

TEST_F(Submissions, MayHaveNamesOfAnyEncoding) {
  const std::string zip =
      zip_of({{"opis-@@itaj.txt", "text"}, {"7-@@.png", "no picture"}, {"1.png", "none"}}).value();
  write("utf8.zip", named_anew(zip, "č", true));
  EXPECT_EQ(found(path("utf8.zip")), "1.png:1 7-č.png:7");
  write("cp852.zip", named_anew(zip, "\x9F\xE7", false));
  EXPECT_EQ(found(path("cp852.zip")), "1.png:1 7-\x9F\xE7.png:7");
  write("wrong.zip", named_anew(zip, "\x9F\xE7", true));
  EXPECT_EQ(found(path("wrong.zip")), "1.png:1 ?:0 ?:0") << "both may be pictures";
}

TEST_F(Submissions, FollowNoLinks) {
  fs::create_directories(path("ana/in"));
  write("outside.png", "x");
  write("ana/1.png", "x");
  fs::create_symlink(path("outside.png"), path("ana/7.png"));
  fs::create_symlink(folder_, path("ana/in/up"));
  EXPECT_EQ(found(path("ana")), "1.png:1 7.png:7 it is a link, which is not followed");
  fs::create_symlink("ana", path("link"));
  EXPECT_EQ(found(path("link")), found(path("ana"))) << "whoever names a link means what it is to";
  EXPECT_EQ(found(path("link"), Links::refuse), "it is a link, which is not followed");
  EXPECT_EQ(found(path("link/"), Links::refuse), "it is a link, which is not followed");
  EXPECT_EQ(found(path("ana"), Links::refuse), found(path("ana")));
}

TEST_F(Submissions, AreReadToTheirDepthsOrRefused) {
  fs::create_directories(path("ana/a/b/c/d"));
  write("ana/a/b/c/d/5.png", "x");
  EXPECT_EQ(found(path("ana")), "a/b/c/d/5.png:5");
  if (::geteuid() == 0) return;  // whom nothing stays closed to
  fs::permissions(path("ana/a/b"), fs::perms::none);
  EXPECT_EQ(found(path("ana")), "the folder 'a/b' cannot be read: Permission denied");
  fs::permissions(path("ana/a/b"), fs::perms::owner_all);
  fs::permissions(path("ana"), fs::perms::none);
  EXPECT_EQ(found(path("ana")), "the folder cannot be read: Permission denied");
  fs::permissions(path("ana"), fs::perms::owner_all);
}

TEST_F(Submissions, TellOfPicturesThatCannotBeReadWhateverTheirNames) {
  const Scene scene = course_scene();
  const Grader grader = Grader::create(scene, lab_options()).value();
  fs::create_directories(path("ana"));
  write("ana/slika.bmp", "BM");
  write("ana/7.png", "nothing");
  const Grade grade = grader.grade(path("ana"));
  ASSERT_EQ(grade.stages.size(), 7u);
  EXPECT_EQ(grade.stages[6].file, "7.png");
  EXPECT_EQ(grade.stages[6].verdict, Verdict::unreadable);
  EXPECT_EQ(grade.stages[5].file, "slika.bmp");
  EXPECT_EQ(grade.stages[5].stage, 6);
  EXPECT_EQ(grade.stages[5].verdict, Verdict::unreadable);
  EXPECT_EQ(grade.stages[4].verdict, Verdict::missing);
}

TEST_F(Submissions, AreJudgedByTheFirstPictureThatCanBeRead) {
  const Scene scene = course_scene();
  const Grader grader = Grader::create(scene, lab_options()).value();
  fs::create_directories(path("ana"));
  write("ana/7.bmp", "BM");
  ASSERT_TRUE(write_png(grader.picture(7), path("ana/7.png"), {8, Transfer::linear}));
  EXPECT_EQ(grader.grade(path("ana")).marks, 1);
}

TEST_F(Submissions, MayBeOfAnyShapeAndTakeNoMoreMemoryThanTheirScene) {
  const auto size = [&](const Image& image) {
    EXPECT_TRUE(write_png(image, path("a.png"), {8, Transfer::linear}));
    const Result<DecodedPicture> read =
        read_picture({.file = "a.png", .path = path("a.png")}, {.width = 40, .height = 30});
    return fmt::format("{}x{}", read->image.width, read->image.height);
  };
  EXPECT_EQ(size(Image(40, 30)), "40x30");
  EXPECT_EQ(size(Image(224, 184)), "224x184");
  EXPECT_EQ(size(Image(1000000, 1)), "448x1");
  EXPECT_EQ(size(Image(1, 1000000)), "1x368");
  EXPECT_EQ(size(Image(2000, 2000)), "203x203");
  EXPECT_EQ(size(Image(1600, 400)), "406x102");
  const Scene scene = course_scene();
  const Grader grader = Grader::create(scene, lab_options()).value();
  fs::create_directories(path("ana"));
  ASSERT_TRUE(write_png(Image(1000000, 1), path("ana/1.png"), {8, Transfer::linear}));
  ASSERT_TRUE(write_png(Image(1, 1000000), path("ana/7.png"), {8, Transfer::linear}));
  EXPECT_EQ(grader.grade(path("ana")).marks, 0);
}

/// Seven pictures that show nothing get no marks, in any scene, size and format.
TEST_F(Submissions, OfNothingGetNoMarks) {
  const auto plain = [](float r, float g, float b) {
    return [=](Image& image) {
      for (std::size_t i = 0; i < image.pixels.size(); i += 3)
        image.pixels[i] = r, image.pixels[i + 1] = g, image.pixels[i + 2] = b;
    };
  };
  const auto noise = [](float most) {
    return [most](Image& image) {
      std::mt19937 random(7);
      for (float& value : image.pixels)
        value = most * static_cast<float>(random() % 1000) / 1000.0F;
    };
  };
  const auto shape = [](bool (*lit)(double, double)) {
    return [lit](Image& image) {
      for (std::uint32_t y = 0; y < image.height; ++y)
        for (std::uint32_t x = 0; x < image.width; ++x)
          if (lit(x / double(image.width), y / double(image.height)))
            std::fill_n(image.row(y) + std::size_t{3} * x, 3, 0.4F);
    };
  };
  std::vector<std::pair<std::string, std::function<void(Image&)>>> nothings = {
      {"red", plain(1, 0, 0)},
      {"brown", plain(0.3F, 0.2F, 0)},
      {"noise", noise(1)},
      {"dark noise", noise(0.2F)},
      {"dark above grey", shape([](double, double y) { return y < 0.5; })},
      {"a disc", shape([](double x, double y) { return std::hypot(x - 0.5, y - 0.5) < 0.4; })}};
  for (const float grey : {0.0F, 0.05F, 0.1F, 0.2F, 0.5F, 1.0F})
    nothings.emplace_back(fmt::format("grey {}", grey), plain(grey, grey, grey));
  const std::vector<Scene> scenes = {course_scene(), third_scene()};
  for (const Scene& scene : scenes) {
    const Grader grader = Grader::create(scene, lab_options()).value();
    const Image right = grader.picture(7);
    for (const auto& [name, fill] : nothings)
      for (const bool in_size : {true, false}) {
        // The same steps again.
        if ((!in_size || &scene != &scenes.front()) && name != "noise" && name != "a disc")
          continue;
        Image image(right.width, right.height);
        if (!in_size) image = Image(right.width * 5 / 4, right.height * 5 / 4);
        fill(image);
        fs::remove_all(path("ana"));
        fs::create_directories(path("ana"));
        for (const int stage : {1, 4, 7}) {
          if (in_size)
            ASSERT_TRUE(write_png(image, path(fmt::format("ana/{}.png", stage))));
          else
            write(fmt::format("ana/{}.jpg", stage), jpeg_file(image, 90));
        }
        const Grade grade = grader.grade(path("ana"));
        EXPECT_EQ(grade.marks, 0) << name << (in_size ? "" : " scaled, in JPEG") << "\n"
                                  << grade_text(Language::english, grader, grade);
        for (const StageGrade& stage : grade.stages)
          EXPECT_EQ(stage.verdict, stage.file.empty() ? Verdict::missing : Verdict::unknown)
              << name;
      }
  }
}

}  // namespace
}  // namespace zraka
