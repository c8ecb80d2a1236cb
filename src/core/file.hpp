// SPDX-License-Identifier: Apache-2.0
// Files, read whole; what is written is in new_file.hpp.
#pragma once

#include <cstdint>
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

}  // namespace zraka
