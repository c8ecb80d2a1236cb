// SPDX-License-Identifier: Apache-2.0
// Files, read whole and written whole or not at all.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <zraka/diagnostic.hpp>

namespace zraka {

/// The bytes of a regular file of at most `limit` bytes; "-" is standard input.
Result<std::string> read_file(const std::string& path, std::uint64_t limit);

/// The text of a file for a reader that goes through it from front to back. A large regular file
/// is mapped, not read, and what the reader has passed takes no memory; whoever shortens such a
/// file while it is being read ends the program.
class FileText {
 public:
  /// As read_file().
  static Result<FileText> open(const std::string& path, std::uint64_t limit);
  FileText(FileText&& other) noexcept;
  FileText& operator=(FileText&&) = delete;
  ~FileText();

  std::string_view view() const;
  /// What lies before `at` will hardly be looked at again.
  void pass(const char* at) const;

 private:
  FileText() = default;
  std::string text_;
  void* mapped_ = nullptr;
  std::size_t size_ = 0;
};

/// Makes a folder, and those above it, where it is not there yet.
Result<void> make_folder(const std::string& path);

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
  /// What people know it by: its path, or "standard output".
  const std::string& name() const { return path_; }
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
