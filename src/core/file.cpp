// SPDX-License-Identifier: Apache-2.0
#include "core/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "core/phrase.hpp"

namespace zraka {
namespace {

Phrase reason() {
  return reason_of(errno);
}

}  // namespace

Result<std::string> read_file(const std::string& path, std::uint64_t limit) {
  constexpr std::uint64_t kMostOfStream = std::uint64_t{1}
                                          << 32;  // whose size nobody knows beforehand
  const bool standard_input = path == "-";
  // Without O_NONBLOCK, opening a pipe that nobody writes to would wait for ever.
  const int descriptor = standard_input ? ::dup(STDIN_FILENO)
                                        : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0)
    return failure(path, phrase(Word::path_unreadable, reason()),
                   errno == ENOENT ? phrase(Word::path_right) : Phrase{});
  struct stat status {};
  const bool known = ::fstat(descriptor, &status) == 0;
  const auto refuse = [&](const Phrase& message) {
    ::close(descriptor);
    return failure(path, message);
  };
  if (known && S_ISDIR(status.st_mode)) return refuse(phrase(Word::path_is_folder));
  if (!standard_input && known && !S_ISREG(status.st_mode) && !S_ISFIFO(status.st_mode))
    return refuse(phrase(Word::path_is_device));
  if (!known || !S_ISREG(status.st_mode)) limit = std::min(limit, kMostOfStream);
  if (!standard_input && known && S_ISFIFO(status.st_mode)) {
    // A writer may come late and be slow, but not for ever.
    pollfd wanted{descriptor, POLLIN, 0};
    ::poll(&wanted, 1, 1000);
    ::fcntl(descriptor, F_SETFL, O_RDONLY);
  }
  const auto too_large = [&] { return phrase(Word::path_too_large, limit); };
  if (known && S_ISREG(status.st_mode) && static_cast<std::uint64_t>(status.st_size) > limit)
    return refuse(too_large());

  std::string text;
  if (known && S_ISREG(status.st_mode)) text.reserve(static_cast<std::size_t>(status.st_size));
  std::array<char, 65536> buffer;
  for (;;) {
    const ssize_t got = ::read(descriptor, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return refuse(phrase(Word::path_unreadable, reason()));
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

Result<void> make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) return failure(path, phrase(Word::path_no_folder, reason_of(error.value())));
  return {};
}

}  // namespace zraka
