// SPDX-License-Identifier: Apache-2.0
#include "core/new_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <zraka/formats.hpp>

#include "core/phrase.hpp"
#include "core/text.hpp"

namespace zraka {
namespace {

namespace fs = std::filesystem;

/// Names of incomplete files for the signal handler: fixed memory, claimed and released without
/// locks. A name that was given up stays as it was until its slot is claimed again.
struct Incomplete {
  std::atomic<bool> taken{false};
  std::atomic<bool> valid{false};
  char name[4096] = {};
};
std::array<Incomplete, 16> incomplete_files;  // NOLINT: a handler reaches nothing but globals
/// Threads between the making of a file and the note that it is there.
std::atomic<int> creating{0};
std::atomic<bool> program_ends{false};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

/// The slot that the name was noted in; -1 where there is no room, and a signal would leave it.
int remember(const std::string& name) {
  for (std::size_t i = 0; i < incomplete_files.size(); ++i) {
    Incomplete& slot = incomplete_files[i];
    if (name.size() >= sizeof(slot.name) || slot.taken.exchange(true)) continue;
    std::memcpy(slot.name, name.c_str(), name.size() + 1);
    slot.valid = true;
    return static_cast<int>(i);
  }
  return -1;
}

void forget(int slot) {
  if (slot < 0) return;
  incomplete_files[static_cast<std::size_t>(slot)].valid = false;
  incomplete_files[static_cast<std::size_t>(slot)].taken = false;
}

/// Once the program is being ended elsewhere, nobody shall report a failure that comes of it.
void wait_if_ending() {
  while (program_ends) ::pause();
}

/// A name beside `target` with an ending that hardly any other file has.
std::string temporary_name(const std::string& target) {
  // As much of the name as leaves room for the rest on every file system, in whole characters.
  constexpr std::size_t kMostOfName = 100;
  const std::size_t folder = target.find_last_of('/') + 1;
  std::size_t end = std::min(target.size(), folder + kMostOfName);
  while (end < target.size() && end > folder && (target[end] & 0xC0) == 0x80) --end;
  std::uint32_t number = 0;
  if (::getentropy(&number, sizeof(number)) != 0) number = static_cast<std::uint32_t>(::getpid());
  return fmt::format("{}.{:08x}", std::string_view(target).substr(0, end), number);
}

/// Makes the file and notes it in the list, in a slot; -1 and errno if it cannot be made.
int make_temporary(const std::string& name, mode_t mode, int& slot) {
  sigset_t all, before;
  sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  // The signal may still reach another thread: its handler waits until `creating` is 0 again.
  ++creating;
  int descriptor = -1, problem = 0;
  if (!program_ends) {
    descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    problem = errno;
    if (descriptor >= 0) slot = remember(name);
  }
  --creating;
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  wait_if_ending();
  errno = problem;
  return descriptor;
}

/// The file that a path means, through all links, whether it is there yet or not. Empty, and errno,
/// where they lead around in a loop.
std::string end_of_links(const std::string& path) {
  constexpr int kMostLinks = 40;  // as many as Linux follows
  fs::path at(path);
  std::error_code error;
  for (int links = 0; links <= kMostLinks; ++links) {
    if (!fs::is_symlink(at, error)) return at.string();
    const fs::path next = fs::read_symlink(at, error);
    if (error) break;
    at = at.parent_path() / next;
  }
  errno = ELOOP;
  return "";
}

/// What a name stands for: a regular file by its number, one that is not there yet by its path
/// behind all links. None for devices, pipes and folders, which are not replaced.
std::string file_behind(const std::string& path) {
  struct stat status {};
  const bool exists =
      path == "-" ? ::fstat(STDIN_FILENO, &status) == 0 : ::stat(path.c_str(), &status) == 0;
  if (exists)
    return S_ISREG(status.st_mode) ? fmt::format("{}:{}", status.st_dev, status.st_ino) : "";
  std::error_code error;
  return fs::weakly_canonical(fs::absolute(end_of_links(path), error), error).string();
}

}  // namespace

void remove_incomplete_files() noexcept {
  constexpr int kLongestWaitMs = 1000;  // a file system that hangs must not keep the program alive
  program_ends = true;
  for (int waited = 0; creating != 0 && waited < kLongestWaitMs; ++waited) ::poll(nullptr, 0, 1);
  for (const Incomplete& slot : incomplete_files)
    if (slot.valid) ::unlink(slot.name);
}

Result<NewFile> NewFile::create(const std::string& path) {
  NewFile file;
  file.name_ = path;
  const auto problem = [&] {
    return failure(path, phrase(Word::path_unwritable, reason_of(errno)),
                   errno == ENOENT ? phrase(Word::path_folder_there) : Phrase{});
  };
  if (path == "-") {
    file.name_ = "standard output";
    file.stream_ = ::fdopen(::dup(STDOUT_FILENO), "wb");
    if (file.stream_ == nullptr)
      return failure(file.name_, phrase(Word::path_unwritable, reason_of(errno)));
    return file;
  }
  struct stat old {};
  const bool exists = ::stat(path.c_str(), &old) == 0;
  if (!exists && errno != ENOENT) return problem();
  if (exists && S_ISDIR(old.st_mode)) return failure(path, phrase(Word::path_unwritable_folder));
  if (exists && S_ISREG(old.st_mode) && ::access(path.c_str(), W_OK) != 0) return problem();
  file.target_ = end_of_links(path);
  if (file.target_.empty()) return problem();
  struct stat target {};
  if (exists && (!S_ISREG(old.st_mode) || ::stat(file.target_.c_str(), &target) != 0 ||
                 target.st_ino != old.st_ino || target.st_dev != old.st_dev)) {
    // A device, a pipe (/dev/stdout, /dev/null) or an open file that has no name any more cannot be
    // replaced; it is written as it stands.
    file.stream_ = std::fopen(path.c_str(), "wb");
    if (file.stream_ == nullptr) return problem();
    return file;
  }
  constexpr int kMostTries = 100;
  const mode_t mode = exists ? old.st_mode & 0777 : 0666;
  std::string temporary;
  int descriptor = -1;
  for (int i = 0; i < kMostTries && descriptor < 0 && (i == 0 || errno == EEXIST); ++i) {
    temporary = temporary_name(file.target_);
    descriptor = make_temporary(temporary, mode, file.incomplete_);
  }
  if (descriptor < 0) return problem();
  file.temporary_ = std::move(temporary);
  // A file that is replaced hands its permissions on; a new one has those of the user's mask.
  if (exists) ::fchmod(descriptor, old.st_mode & 07777);
  file.stream_ = ::fdopen(descriptor, "wb");
  return file;
}

NewFile::NewFile(NewFile&& other) noexcept
    : name_(std::move(other.name_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      incomplete_(std::exchange(other.incomplete_, -1)),
      stream_(std::exchange(other.stream_, nullptr)) {}

NewFile::~NewFile() {
  if (stream_ != nullptr) std::fclose(stream_);
  if (temporary_.empty()) return;
  ::unlink(temporary_.c_str());
  forget(incomplete_);
}

Result<void> NewFile::commit() {
  bool good = std::fflush(stream_) == 0 && std::ferror(stream_) == 0;
  int problem = errno;
  if (std::fclose(std::exchange(stream_, nullptr)) != 0 && good) good = false, problem = errno;
  if (good && !temporary_.empty()) {
    if (std::rename(temporary_.c_str(), target_.c_str()) == 0) {
      forget(std::exchange(incomplete_, -1));
      temporary_.clear();
    } else {
      good = false;
      problem = errno;
    }
  }
  if (good) return {};
  wait_if_ending();
  return failure(name_, phrase(Word::path_unwritable, reason_of(problem)));
}

Result<void> check_outputs(const std::vector<std::string>& inputs,
                           const std::vector<std::string>& outputs) {
  std::map<std::string, std::string> names;  // of inputs by what they stand for
  for (const std::string& input : inputs)
    if (!input.empty()) names.emplace(file_behind(input), input);
  std::set<std::string> written;
  for (const std::string& output : outputs) {
    if (output.empty() || output == "-") continue;
    const std::string file = file_behind(output);
    if (file.empty()) continue;
    if (const auto read = names.find(file); read != names.end())
      return failure(output, phrase(Word::path_over_input),
                     read->second == output ? Phrase()
                     : read->second == "-"  ? phrase(Word::path_is_standard_input)
                                            : phrase(Word::path_is_file, shown(read->second)));
    if (!written.insert(file).second) return failure(output, phrase(Word::path_written_twice));
  }
  return {};
}

Result<void> write_text_file(const std::string& path, std::string_view text) {
  Result<NewFile> file = NewFile::create(path);
  if (!file) return tl::make_unexpected(file.error());
  std::fwrite(text.data(), 1, text.size(), file->stream());
  return file->commit();
}

}  // namespace zraka
