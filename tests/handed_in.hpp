// SPDX-License-Identifier: Apache-2.0
// Pictures that are altered and handed in to a grader, for tests.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "alterations.hpp"
#include "course_scenes.hpp"
#include "picture_files.hpp"
#include "school/grade/words.hpp"

namespace zraka {

/// A scene, its grader, and a file of its own for each picture, gone when the test is over.
class HandedInPictures : public testing::Test {
 protected:
  explicit HandedInPictures(const Scene& of = course_scene())
      : scene(of), grader(Grader::create(scene, lab_options()).value()) {
    std::filesystem::create_directories(folder);
  }
  ~HandedInPictures() override { std::filesystem::remove_all(folder); }

  /// What the grader makes of a picture in a file of this name.
  StageGrade judged(const Image& picture, const std::vector<altered::Alteration>& how,
                    const std::string& name = "refraction") {
    altered::Random random(7);
    altered::Altered a{picture};
    for (const altered::Alteration one : how) altered::alter(a, one, random);
    const std::string file = (folder / (name + (a.jpeg > 0 ? ".jpg" : ".png"))).string();
    if (a.jpeg > 0)
      std::ofstream(file, std::ios::binary) << jpeg_file(a.image, a.jpeg);
    else
      EXPECT_TRUE(write_png(a.image, file, {8, Transfer::linear}));
    return grader.grade(file).stages.front();
  }

  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("zraka-altered-" + std::to_string(::getpid()));
  const Scene scene;
  const Grader grader;
};

}  // namespace zraka
