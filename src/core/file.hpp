// SPDX-License-Identifier: Apache-2.0
// Files, read whole; what is written is in new_file.hpp.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <zraka/diagnostic.hpp>

namespace zraka {

/// Whether there is any use in more, given the beginning of what is read.
using GoesOn = std::function<bool(std::string_view beginning)>;

/// The bytes of a file of at most `limit` bytes; "-" is standard input. Of a pipe or the like,
/// whose end nobody knows, only the first 2^20 bytes if `goes_on` says no to them.
Result<std::string> read_file(const std::string& path, std::uint64_t limit,
                              const GoesOn& goes_on = {});

/// A regular file that is read from front to back in parts.
class LargeFile {
 public:
  /// Nothing if the file is not a regular one, or not large, or larger than `limit`, or cannot be
  /// read: read_file() has words for it.
  static std::optional<LargeFile> open(const std::string& path, std::uint64_t limit);
  LargeFile(LargeFile&& other) noexcept;
  LargeFile& operator=(LargeFile&&) = delete;
  ~LargeFile();

  /// When it was opened.
  std::uint64_t size() const { return size_; }
  /// The next bytes, fewer only where the file ends or cannot be read.
  std::size_t read(char* bytes, std::size_t count);
  void rewind() { at_ = 0; }
  /// Whether reading came to an end before the size that the file had.
  bool shortened() const { return shortened_; }

 private:
  LargeFile(int descriptor, std::uint64_t size) : descriptor_(descriptor), size_(size) {}
  int descriptor_;
  std::uint64_t size_, at_ = 0;
  bool shortened_ = false;
};

/// Makes a folder, and those above it, where it is not there yet.
Result<void> make_folder(const std::string& path);

}  // namespace zraka
