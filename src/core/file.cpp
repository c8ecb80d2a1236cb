// SPDX-License-Identifier: Apache-2.0
#include "core/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>
#include <zraka/formats.hpp>

namespace zraka {
namespace {

/// Names of incomplete files for the signal handler: fixed memory, claimed and released without
/// locks.
struct Incomplete {
  std::atomic<bool> taken{false};
  std::atomic<bool> valid{false};
  char name[4096] = {};
};
std::array<Incomplete, 16> incomplete_files;  // NOLINT: a handler reaches nothing but globals

void remember(const std::string& name) {
  for (Incomplete& slot : incomplete_files) {
    if (name.size() >= sizeof(slot.name) || slot.taken.exchange(true)) continue;
    std::memcpy(slot.name, name.c_str(), name.size() + 1);
    slot.valid = true;
    return;
  }
}

void forget(const std::string& name) {
  for (Incomplete& slot : incomplete_files) {
    if (!slot.valid || name != slot.name) continue;
    slot.valid = false;
    slot.taken = false;
    return;
  }
}

std::string reason() {
  return std::strerror(errno);
}

}  // namespace

void remove_incomplete_files() noexcept {
  for (const Incomplete& slot : incomplete_files)
    if (slot.valid) ::unlink(slot.name);
}

Result<std::string> read_file(const std::string& path, std::uint64_t limit) {
  constexpr std::uint64_t kMostOfStream = std::uint64_t{1}
                                          << 32;  // whose size nobody knows beforehand
  const bool standard_input = path == "-";
  // Without O_NONBLOCK, opening a pipe that nobody writes to would wait for ever.
  const int descriptor = standard_input ? ::dup(STDIN_FILENO)
                                        : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0)
    return failure(path, fmt::format("cannot be read: {}", reason()),
                   errno == ENOENT ? "is the name right, and the folder?" : "");
  struct stat status {};
  const bool known = ::fstat(descriptor, &status) == 0;
  const auto refuse = [&](const std::string& message) {
    ::close(descriptor);
    return failure(path, message);
  };
  if (known && S_ISDIR(status.st_mode)) return refuse("is a folder, not a file");
  if (!standard_input && known && !S_ISREG(status.st_mode) && !S_ISFIFO(status.st_mode))
    return refuse("is no file that can be read: a device or a socket");
  if (!known || !S_ISREG(status.st_mode)) limit = std::min(limit, kMostOfStream);
  if (!standard_input && known && S_ISFIFO(status.st_mode)) {
    // A writer may come late and be slow, but not for ever.
    pollfd wanted{descriptor, POLLIN, 0};
    ::poll(&wanted, 1, 1000);
    ::fcntl(descriptor, F_SETFL, O_RDONLY);
  }
  const auto too_large = [&] { return fmt::format("is too large: over {} bytes", limit); };
  if (known && S_ISREG(status.st_mode) && static_cast<std::uint64_t>(status.st_size) > limit)
    return refuse(too_large());

  std::string text;
  if (known && S_ISREG(status.st_mode)) text.reserve(static_cast<std::size_t>(status.st_size));
  std::array<char, 65536> buffer;
  for (;;) {
    const ssize_t got = ::read(descriptor, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return refuse(fmt::format("cannot be read: {}", reason()));
    if (got == 0) break;
    text.append(buffer.data(), static_cast<std::size_t>(got));
    if (text.size() > limit) return refuse(too_large());
  }
  ::close(descriptor);
  return text;
}

Result<FileText> FileText::open(const std::string& path, std::uint64_t limit) {
  constexpr off_t kLarge = off_t{1} << 24;
  FileText file;
  struct stat status {};
  if (path != "-" && ::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) &&
      status.st_size >= kLarge && static_cast<std::uint64_t>(status.st_size) <= limit) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor >= 0) {
      const auto size = static_cast<std::size_t>(status.st_size);
      void* mapped = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
      ::close(descriptor);
      if (mapped != MAP_FAILED) {
        ::madvise(mapped, size, MADV_SEQUENTIAL);
        file.mapped_ = mapped;
        file.size_ = size;
        return file;
      }
    }
  }
  Result<std::string> text = read_file(path, limit);
  if (!text) return tl::make_unexpected(text.error());
  file.text_ = std::move(*text);
  return file;
}

FileText::FileText(FileText&& other) noexcept
    : text_(std::move(other.text_)),
      mapped_(std::exchange(other.mapped_, nullptr)),
      size_(other.size_) {}

FileText::~FileText() {
  if (mapped_ != nullptr) ::munmap(mapped_, size_);
}

std::string_view FileText::view() const {
  return mapped_ != nullptr ? std::string_view(static_cast<const char*>(mapped_), size_) : text_;
}

void FileText::pass(const char* at) const {
  if (mapped_ == nullptr) return;
  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  const auto passed = static_cast<std::size_t>(at - static_cast<const char*>(mapped_));
  ::madvise(mapped_, std::min(passed, size_) / page * page, MADV_DONTNEED);
}

Result<NewFile> NewFile::create(const std::string& path) {
  NewFile file;
  if (path == "-") {
    file.path_ = "standard output";
    file.stream_ = ::fdopen(::dup(STDOUT_FILENO), "wb");
    if (file.stream_ == nullptr)
      return failure(file.path_, fmt::format("cannot be written: {}", reason()));
    return file;
  }
  // A link is written through, not replaced.
  std::error_code error;
  const auto target = std::filesystem::canonical(path, error);
  file.path_ = error ? path : target.string();
  if (error && std::filesystem::is_symlink(path, error))  // to a file that is not there yet
    file.path_ = std::filesystem::path(path).replace_filename(std::filesystem::read_symlink(path));
  if (!error && std::filesystem::is_directory(target, error))
    return failure(path, "cannot be written: it is a folder");
  struct stat old {};
  const bool exists = ::stat(file.path_.c_str(), &old) == 0;
  if (exists && !S_ISREG(old.st_mode)) {
    // A device or a pipe (/dev/stdout, /dev/null) cannot be replaced; it is written as it stands.
    file.stream_ = std::fopen(file.path_.c_str(), "wb");
    if (file.stream_ == nullptr)
      return failure(path, fmt::format("cannot be written: {}", reason()));
    return file;
  }
  if (exists && ::access(file.path_.c_str(), W_OK) != 0)
    return failure(path, fmt::format("cannot be written: {}", reason()));
  std::string name = file.path_ + ".XXXXXX";
  // No signal comes between the file and the note that it is there.
  sigset_t all, before;
  sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  const int descriptor = ::mkostemp(name.data(), O_CLOEXEC);
  const int problem = errno;
  if (descriptor >= 0) remember(name);
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = problem;
  if (descriptor < 0)
    return failure(path, fmt::format("cannot be written: {}", reason()),
                   errno == ENOENT ? "does its folder exist?" : "");
  file.temporary_ = name;
  // The permissions of the file that is replaced, else those that the user's mask gives a new one.
  const mode_t mask = ::umask(0);
  ::umask(mask);
  ::fchmod(descriptor, exists ? old.st_mode & 07777 : 0666 & ~mask);
  file.stream_ = ::fdopen(descriptor, "wb");
  return file;
}

NewFile::NewFile(NewFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::exchange(other.temporary_, {})),
      stream_(std::exchange(other.stream_, nullptr)) {}

NewFile::~NewFile() {
  if (stream_ != nullptr) std::fclose(stream_);
  if (temporary_.empty()) return;
  ::unlink(temporary_.c_str());
  forget(temporary_);
}

Result<void> NewFile::commit() {
  bool good = std::fflush(stream_) == 0 && std::ferror(stream_) == 0;
  std::string problem = good ? "" : reason();
  if (std::fclose(std::exchange(stream_, nullptr)) != 0 && good) good = false, problem = reason();
  if (good && !temporary_.empty()) {
    if (std::rename(temporary_.c_str(), path_.c_str()) == 0) {
      forget(temporary_);
      temporary_.clear();
    } else {
      good = false;
      problem = reason();
    }
  }
  if (!good) return failure(path_, fmt::format("cannot be written: {}", problem));
  return {};
}

Result<void> make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) return failure(path, fmt::format("cannot be made a folder: {}", error.message()));
  return {};
}

Result<void> write_text_file(const std::string& path, std::string_view text) {
  Result<NewFile> file = NewFile::create(path);
  if (!file) return tl::make_unexpected(file.error());
  std::fwrite(text.data(), 1, text.size(), file->stream());
  return file->commit();
}

}  // namespace zraka
