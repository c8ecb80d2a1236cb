// SPDX-License-Identifier: Apache-2.0
// Files, read whole and written whole or not at all.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <zraka/diagnostic.hpp>

namespace zraka {

/// The bytes of a regular file of at most `limit` bytes; "-" is standard input.
Result<std::string> read_file(const std::string& path, std::uint64_t limit);

/// A file that comes into being when it is complete: written beside its name, then renamed over it.
/// Without commit() nothing stays behind.
class NewFile {
 public:
  /// "-" is standard output; devices and pipes are written as they stand.
  static Result<NewFile> create(const std::string& path);
  NewFile(NewFile&& other) noexcept;
  NewFile& operator=(NewFile&&) = delete;
  ~NewFile();

  std::FILE* stream() const { return stream_; }
  /// Flushes, closes, renames. A file that existed is as it was if this fails.
  Result<void> commit();

 private:
  NewFile() = default;
  std::string path_, temporary_;
  std::FILE* stream_ = nullptr;
};

/// Removes the temporary files of all NewFiles that are not complete; safe in a signal handler.
void remove_incomplete_files() noexcept;

}  // namespace zraka
