// SPDX-License-Identifier: Apache-2.0
#include "core/file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <zraka/formats.hpp>

namespace zraka {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        fs::path(testing::TempDir()) /
        (std::string("zraka-") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  static std::string content(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }
  std::size_t count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }
  fs::path folder_;
};

TEST_F(Files, AreThereOnlyOnceTheyAreComplete) {
  ASSERT_TRUE(write_text_file(path("a"), "old"));
  {
    Result<NewFile> file = NewFile::create(path("a"));
    ASSERT_TRUE(file);
    std::fputs("half", file->stream());
    std::fflush(file->stream());
    EXPECT_EQ(content(path("a")), "old");
    EXPECT_EQ(count(), 2u);
  }
  EXPECT_EQ(content(path("a")), "old");
  EXPECT_EQ(count(), 1u) << "the half file is gone";
  ASSERT_TRUE(write_text_file(path("a"), "new"));
  EXPECT_EQ(content(path("a")), "new");
  EXPECT_EQ(count(), 1u);
}

TEST_F(Files, KeepPermissionsAndLinks) {
  ASSERT_TRUE(write_text_file(path("a"), "old"));
  ::chmod(path("a").c_str(), 0640);
  fs::create_symlink(path("a"), path("link"));
  ASSERT_TRUE(write_text_file(path("link"), "new"));
  EXPECT_TRUE(fs::is_symlink(path("link")));
  fs::create_symlink("new", path("to-new"));
  ASSERT_TRUE(write_text_file(path("to-new"), "first"));
  EXPECT_TRUE(fs::is_symlink(path("to-new")));
  EXPECT_TRUE(fs::is_regular_file(path("new")));
  EXPECT_EQ(content(path("a")), "new");
  EXPECT_EQ(static_cast<int>(fs::status(path("a")).permissions()), 0640);
}

TEST_F(Files, AreRemovedWhenInterrupted) {
  Result<NewFile> file = NewFile::create(path("a"));
  ASSERT_TRUE(file);
  EXPECT_EQ(count(), 1u);
  remove_incomplete_files();
  EXPECT_EQ(count(), 0u);
}

TEST_F(Files, ThatCannotBeWrittenSayWhy) {
  const auto error = [](const std::string& path) {
    const Result<void> written = write_text_file(path, "text");
    return written ? std::string("written") : to_string(written.error().front());
  };
  EXPECT_EQ(error("/nowhere/a"),
            "/nowhere/a: error: cannot be written: No such file or directory\n  does its folder "
            "exist?\n");
  EXPECT_EQ(error(folder_.string()),
            folder_.string() + ": error: cannot be written: it is a folder\n");
  EXPECT_EQ(error("/dev/full"), "/dev/full: error: cannot be written: No space left on device\n");
}

TEST_F(Files, ThatCannotBeReadSayWhy) {
  const auto error = [](const std::string& path, std::uint64_t limit = 100) {
    const Result<std::string> text = read_file(path, limit);
    return text ? std::string("read") : to_string(text.error().front());
  };
  EXPECT_EQ(error("/nowhere"),
            "/nowhere: error: cannot be read: No such file or directory\n  is the name right, and "
            "the folder?\n");
  EXPECT_EQ(error(folder_.string()), folder_.string() + ": error: is a folder, not a file\n");
  EXPECT_EQ(error("/dev/zero"),
            "/dev/zero: error: is no file that can be read: a device or a socket\n");
  ::mkfifo(path("pipe").c_str(), 0600);
  EXPECT_EQ(read_file(path("pipe"), 100).value(), "")
      << "a pipe that nobody writes to ends at once";
  ASSERT_TRUE(write_text_file(path("large"), std::string(101, 'x')));
  EXPECT_EQ(error(path("large")), path("large") + ": error: is too large: over 100 bytes\n");
}

}  // namespace
}  // namespace zraka
