// SPDX-License-Identifier: Apache-2.0
// Files that are written whole or not at all.
#pragma once

#include <cstdio>
#include <string>
#include <vector>
#include <zraka/diagnostic.hpp>

namespace zraka {

/// A file that comes into being when it is complete: written beside its name, then renamed over it.
/// Without commit() nothing stays behind.
class NewFile {
 public:
  /// "-" is standard output; devices and pipes are written as they stand, and links are written
  /// through, however many follow each other.
  static Result<NewFile> create(const std::string& path);
  NewFile(NewFile&& other) noexcept;
  NewFile& operator=(NewFile&&) = delete;
  ~NewFile();

  std::FILE* stream() const { return stream_; }
  /// What people know it by: its path, or "standard output".
  const std::string& name() const { return name_; }
  /// Flushes, closes, renames. A file that existed is as it was if this fails.
  Result<void> commit();

 private:
  NewFile() = default;
  std::string name_, target_, temporary_;
  int incomplete_ = -1;  ///< its slot in the list of what to remove
  std::FILE* stream_ = nullptr;
};

/// Removes the temporary files of all NewFiles that are not complete, and lets no more come into
/// being: whoever asks for one from now on, or fails to complete one, waits for the program's end.
/// To be called last, also in a signal handler.
void remove_incomplete_files() noexcept;

/// Fails where an output would be written over one of the inputs or over another output, by
/// whatever name: links lead to the same file. "-" is standard input or output, "" is none.
Result<void> check_outputs(const std::vector<std::string>& inputs,
                           const std::vector<std::string>& outputs);

}  // namespace zraka
