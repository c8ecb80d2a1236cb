// SPDX-License-Identifier: Apache-2.0
#include "core/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
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

Result<std::string> read_file(const std::string& path, std::uint64_t limit, const GoesOn& goes_on) {
  constexpr std::size_t kBeginning = std::size_t{1} << 20;
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
  const bool regular = known && S_ISREG(status.st_mode);
  if (!regular) limit = std::min(limit, kMostOfStream);
  if (!standard_input && known && S_ISFIFO(status.st_mode)) {
    // A writer may come late and be slow, but not for ever.
    pollfd wanted{descriptor, POLLIN, 0};
    ::poll(&wanted, 1, 1000);
    ::fcntl(descriptor, F_SETFL, O_RDONLY);
  }
  const auto too_large = [&] { return phrase(Word::path_too_large, limit); };
  if (regular && static_cast<std::uint64_t>(status.st_size) > limit) return refuse(too_large());

  std::string text;
  if (regular) text.reserve(static_cast<std::size_t>(status.st_size));
  std::array<char, 65536> buffer;
  bool asked = regular || goes_on == nullptr;
  for (;;) {
    const ssize_t got = ::read(descriptor, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return refuse(phrase(Word::path_unreadable, reason()));
    if (got == 0) break;
    text.append(buffer.data(), static_cast<std::size_t>(got));
    if (text.size() > limit) return refuse(too_large());
    if (asked || text.size() < kBeginning) continue;
    asked = true;
    if (!goes_on(text)) break;
  }
  if (regular && text.size() < static_cast<std::size_t>(status.st_size))
    return refuse(phrase(Word::path_shortened));
  ::close(descriptor);
  return text;
}

std::optional<LargeFile> LargeFile::open(const std::string& path, std::uint64_t limit) {
  constexpr std::uint64_t kLarge = std::uint64_t{1} << 24;
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return {};
  LargeFile file(descriptor, 0);
  struct stat status {};
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return {};
  file.size_ = static_cast<std::uint64_t>(status.st_size);
  if (file.size_ < kLarge || file.size_ > limit) return {};
  return file;
}

LargeFile::LargeFile(LargeFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_), at_(other.at_) {}

LargeFile::~LargeFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::size_t LargeFile::read(char* bytes, std::size_t count) {
  std::size_t all = 0;
  while (all < count) {
    const ssize_t got = ::pread(descriptor_, bytes + all, count - all, static_cast<off_t>(at_));
    if (got < 0 && errno == EINTR) continue;
    shortened_ = shortened_ || (got == 0 && at_ < size_);
    if (got <= 0) break;
    all += static_cast<std::size_t>(got);
    at_ += static_cast<std::uint64_t>(got);
  }
  return all;
}

Result<void> make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) return failure(path, phrase(Word::path_no_folder, reason_of(error.value())));
  return {};
}

}  // namespace zraka
