// SPDX-License-Identifier: Apache-2.0
#include "core/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>
#include <zraka/formats.hpp>

#include "core/new_file.hpp"

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

TEST_F(Files, AreWrittenThroughChainsOfLinks) {
  fs::create_directories(path("in"));
  ASSERT_TRUE(write_text_file(path("in/a"), "old"));
  fs::create_symlink("in/second", path("first"));
  fs::create_symlink("third", path("in/second"));
  fs::create_symlink(path("in/a"), path("in/third"));
  ASSERT_TRUE(write_text_file(path("first"), "new"));
  EXPECT_EQ(content(path("in/a")), "new");
  fs::remove(path("in/a"));
  ASSERT_TRUE(write_text_file(path("first"), "newer")) << "where the last one leads nowhere yet";
  EXPECT_EQ(content(path("in/a")), "newer");
  for (const char* link : {"first", "in/second", "in/third"})
    EXPECT_TRUE(fs::is_symlink(path(link))) << link;

  fs::create_symlink("here", path("there"));
  fs::create_symlink("there", path("here"));
  const Result<void> looped = write_text_file(path("here"), "x");
  ASSERT_FALSE(looped);
  EXPECT_EQ(to_string(looped.error().front()),
            path("here") + ": error: cannot be written: Too many levels of symbolic links\n");
  EXPECT_TRUE(fs::is_symlink(path("here")));
}

TEST_F(Files, WithoutANameAreWrittenAsTheyStand) {
  const int descriptor = ::open(path("gone").c_str(), O_RDWR | O_CREAT, 0600);
  ASSERT_GE(descriptor, 0);
  ASSERT_TRUE(fs::remove(path("gone")));
  ASSERT_TRUE(write_text_file(fmt::format("/proc/self/fd/{}", descriptor), "text"));
  char text[5] = {};
  EXPECT_EQ(::pread(descriptor, text, 4, 0), 4);
  EXPECT_STREQ(text, "text");
  EXPECT_EQ(count(), 0u);
  ::close(descriptor);
}

TEST_F(Files, MayHaveTheLongestNames) {
  std::string longest(255, 'x');
  ASSERT_TRUE(write_text_file(path(longest), "a"));
  EXPECT_EQ(content(path(longest)), "a");
  std::string letters;
  while (letters.size() < 252) letters += "š";  // 2 bytes, of which none is to be cut
  ASSERT_TRUE(write_text_file(path(letters), "b"));
  EXPECT_EQ(content(path(letters)), "b");
  EXPECT_EQ(count(), 2u);
  longest += 'x';
  const Result<void> written = write_text_file(path(longest), "c");
  ASSERT_FALSE(written);
  EXPECT_EQ(to_string(written.error().front()),
            path(longest) + ": error: cannot be written: File name too long\n");
}

TEST_F(Files, AreRemovedWhenInterrupted) {
  const auto interrupted = [&] {
    const Result<NewFile> file = NewFile::create(path("a"));
    if (!file || count() != 1) ::_exit(1);
    remove_incomplete_files();
    ::_exit(count() == 0 ? 0 : 2);
  };
  EXPECT_EXIT(interrupted(), testing::ExitedWithCode(0), "");
}

/// A process in which two threads make files without end until a signal reaches a third.
[[noreturn]] void make_files_until_a_signal(const std::string& folder, int ready) {
  const auto make = [&](int which) {
    for (;;) {
      const Result<NewFile> file = NewFile::create(fmt::format("{}/{}", folder, which));
      if (!file) ::_exit(2);
    }
  };
  sigset_t term, before;
  sigemptyset(&term);
  sigaddset(&term, SIGTERM);
  ::pthread_sigmask(SIG_BLOCK, &term, &before);
  std::thread first(make, 1), second(make, 2);
  struct sigaction action {};
  action.sa_handler = [](int) {
    remove_incomplete_files();
    ::_exit(0);
  };
  ::sigaction(SIGTERM, &action, nullptr);
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (::write(ready, "!", 1) != 1) ::_exit(3);
  for (;;) ::pause();
}

TEST_F(Files, AreRemovedWhenASignalReachesAnotherThread) {
  for (int i = 0; i < 50; ++i) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) make_files_until_a_signal(folder_.string(), ends[1]);
    char byte = 0;
    ASSERT_EQ(::read(ends[0], &byte, 1), 1);
    ::usleep(static_cast<useconds_t>(100 + 37 * (i % 20)));
    ::kill(child, SIGTERM);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ::close(ends[0]);
    ::close(ends[1]);
    ASSERT_EQ(status, 0);
    ASSERT_EQ(count(), 0u) << "in round " << i;
  }
}

TEST_F(Files, AreNotWrittenOverInputs) {
  const auto problem = [&](const std::vector<std::string>& in,
                           const std::vector<std::string>& out) {
    const Result<void> good = check_outputs(in, out);
    return good ? std::string() : to_string(good.error().front());
  };
  ASSERT_TRUE(write_text_file(path("in"), "scene"));
  fs::create_symlink("in", path("link"));
  fs::create_symlink("link", path("chain"));
  fs::create_hard_link(path("in"), path("hard"));
  fs::create_directories(path("folder"));
  const std::string over =
      ": error: would be written over an input of this command: it needs "
      "another name\n";
  EXPECT_EQ(problem({path("in")}, {"", "-", path("in")}), path("in") + over);
  for (const char* same : {"link", "chain", "hard", "folder/../in"})
    EXPECT_EQ(problem({path("other"), path("in")}, {path("new"), path(same)})
                  .substr(0, path(same).size() + over.size()),
              path(same) + over);
  EXPECT_EQ(problem({path("in")}, {path("new"), path("newer"), path("folder/in")}), "");
  EXPECT_EQ(problem({"-", "", "/dev/null"}, {"-", "/dev/null", "/dev/null"}), "");
  fs::create_symlink("new", path("to-new"));
  const std::string twice =
      ": error: would be written twice: each output needs a name of its own\n";
  for (const char* same : {"new", "folder/../new", "to-new"})
    EXPECT_EQ(problem({}, {path("new"), path(same)}), path(same) + twice);
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

TEST_F(Files, ThatMayHaveNoEndAreReadAsFarAsTheyAreOfUse) {
  const int all = ::open("/dev/zero", O_RDONLY), before = ::dup(STDIN_FILENO);
  ::dup2(all, STDIN_FILENO);
  std::size_t asked = 0;
  const Result<std::string> text =
      read_file("-", std::uint64_t{1} << 36, [&](std::string_view beginning) {
        EXPECT_EQ(beginning.size(), std::size_t{1} << 20);
        ++asked;
        return false;
      });
  const Result<ReadScene> scene = read_scene("-");
  ::dup2(before, STDIN_FILENO);
  ::close(all), ::close(before);
  EXPECT_EQ(asked, 1u);
  EXPECT_EQ(text.value().size(), std::size_t{1} << 20);
  ASSERT_FALSE(scene);
  EXPECT_EQ(to_string(scene.error().front()),
            "standard input: error: the file is not text: byte 1 is 0x00\n"
            "  expected the course's input.txt format\n");
}

TEST_F(Files, ThatAreLargeCanBeReadInParts) {
  constexpr std::uint64_t kLimit = std::uint64_t{1} << 30;
  ASSERT_TRUE(write_text_file(path("small"), "text"));
  EXPECT_FALSE(LargeFile::open(path("small"), kLimit));
  EXPECT_FALSE(LargeFile::open(path("none"), kLimit));
  EXPECT_FALSE(LargeFile::open(folder_.string(), kLimit));
  std::string text(std::size_t{1} << 24, 'x');
  text[1000] = 'y';
  ASSERT_TRUE(write_text_file(path("large"), text));
  EXPECT_FALSE(LargeFile::open(path("large"), text.size() - 1));
  std::optional<LargeFile> file = LargeFile::open(path("large"), kLimit);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->size(), text.size());
  std::string part(1000, ' ');
  EXPECT_EQ(file->read(part.data(), 1000), 1000u);
  EXPECT_EQ(file->read(part.data(), 1), 1u);
  EXPECT_EQ(part[0], 'y');
  file->rewind();
  EXPECT_EQ(file->read(part.data(), 1), 1u);
  EXPECT_EQ(part[0], 'x');
  std::string all(text.size() + 5, ' ');
  EXPECT_EQ(file->read(all.data(), text.size() - 1), text.size() - 1);
  EXPECT_FALSE(file->shortened());
  EXPECT_EQ(file->read(all.data(), 5), 0u);
  EXPECT_FALSE(file->shortened()) << "that is its end";
  file->rewind();
  fs::resize_file(path("large"), 500);
  EXPECT_EQ(file->read(all.data(), text.size()), 500u);
  EXPECT_TRUE(file->shortened());
}

}  // namespace
}  // namespace zraka
