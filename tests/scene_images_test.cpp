// SPDX-License-Identifier: Apache-2.0
// Pictures that scenes name: where they may be, read once, as linear light.
#include "image/scene_images.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "picture_files.hpp"

namespace zraka {
namespace {

namespace fs = std::filesystem;

/// A folder with a scene's folder inside.
class SceneFiles : public testing::Test {
 protected:
  SceneFiles() {
    root_ = fs::path(testing::TempDir()) / ("zraka-scene-images-" + std::to_string(::getpid()));
    fs::create_directories(root_ / "scene" / "maps");
    fs::create_directories(root_ / "scenery");
  }
  ~SceneFiles() override { fs::remove_all(root_); }

  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(root_ / name, std::ios::binary) << bytes;
  }
  void write(const std::string& name, const Image& image) const {
    ASSERT_TRUE(write_png(image, (root_ / name).string()));
  }
  SceneFolder folder(bool allow_outside = false) const {
    return {(root_ / "scene").string(), allow_outside};
  }

  fs::path root_;
};

TEST_F(SceneFiles, AreInTheFolderOrOneInside) {
  for (const char* name : {"a.png", "maps/a.png", "maps/../a.png", "./maps/new/a.png", "-"}) {
    const Result<std::string> path = folder().path_of(name);
    ASSERT_TRUE(path) << name;
    EXPECT_EQ(fs::path(*path), root_ / "scene" / name);
  }
  EXPECT_TRUE(folder().path_of((root_ / "scene" / "a.png").string()));
  EXPECT_EQ(SceneFolder{}.path_of("-").value(), "./-");
}

TEST_F(SceneFiles, AreNowhereElse) {
  fs::create_symlink(root_, root_ / "scene" / "link");
  for (const std::string& name :
       {std::string("../a.png"), std::string("maps/../../scenery/a.png"), std::string("link/a.png"),
        std::string("../scenery"), std::string(".."), (root_ / "a.png").string(),
        std::string("/etc/hostname")}) {
    const Result<std::string> path = folder().path_of(name);
    ASSERT_FALSE(path) << name;
    EXPECT_EQ(to_string(path.error().front()),
              "error: '" + name +
                  "' lies outside of the scene's folder\n"
                  "  put it beside the scene, or allow it with --allow-outside\n");
    EXPECT_TRUE(folder(true).path_of(name)) << name;
  }
  for (const std::string& name : {std::string(), std::string("a\0.png", 6)})
    EXPECT_FALSE(folder(true).path_of(name));
}

TEST_F(SceneFiles, BecomeLinearLight) {
  Image stored(256, 1);
  for (std::size_t i = 0; i < stored.pixels.size(); ++i)
    stored.pixels[i] = static_cast<float>(i / 3) / 255;
  write("scene/ramp.png", stored);
  ASSERT_TRUE(write_png(stored, (root_ / "scene/deep.png").string(), {.bits = 16}));
  SceneImages images(folder());
  for (const char* name : {"ramp.png", "deep.png"}) {
    const auto light = images.load(name);
    const auto numbers = images.load(name, Transfer::linear);
    ASSERT_TRUE(light && numbers);
    for (std::size_t i = 0; i < stored.pixels.size(); ++i) {
      // IEC 61966-2-1.
      const double v = static_cast<double>(stored.pixels[i]);
      const double wanted = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
      ASSERT_NEAR((*light)->pixels[i], wanted, 2e-6 * wanted + 1e-7) << name << " " << i;
      ASSERT_NEAR((*numbers)->pixels[i], v, 1e-7) << name << " " << i;
    }
  }
}

TEST_F(SceneFiles, OfFloatsStayAsTheyAre) {
  write("scene/a.hdr", hdr_file(1, 1, HdrRuns::none, {64, 128, 255, 131}));
  SceneImages images(folder());
  EXPECT_EQ(images.load("a.hdr").value()->pixels, (std::vector<float>{2, 4, 7.96875f}));
}

TEST_F(SceneFiles, WithNumbersThatAreNotFiniteAreRefused) {
  write("scene/bad.pfm", "PF 1 2 -1\n" + std::string(20, '\0') + std::string("\0\0\x80\x7f", 4));
  const auto bad = SceneImages(folder()).load("bad.pfm");
  ASSERT_FALSE(bad);
  EXPECT_EQ(to_string(bad.error().front()),
            (root_ / "scene/bad.pfm").string() +
                ": error: pixel (0, 0) holds inf: a texture needs finite numbers\n");
}

TEST_F(SceneFiles, AreReadOnce) {
  write("scene/a.png", Image(2, 2));
  SceneImages images(folder());
  const auto first = images.load("a.png").value();
  fs::remove(root_ / "scene/a.png");
  EXPECT_EQ(images.load("a.png").value(), first);
  EXPECT_FALSE(images.load("a.png", Transfer::linear)) << "other numbers are another picture";
  EXPECT_FALSE(SceneImages(folder()).load("a.png"));
}

TEST_F(SceneFiles, OfTooManyPixelsAreRefused) {
  write("scene/large.hdr", "#?RADIANCE\n\n-Y 65536 +X 32768\n");
  const auto large = SceneImages(folder()).load("large.hdr");
  ASSERT_FALSE(large);
  EXPECT_EQ(large.error().front().message,
            "is too large: 32768×65536 pixels, where at most 134217728 in all are read");
}

}  // namespace
}  // namespace zraka
