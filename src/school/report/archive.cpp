// SPDX-License-Identifier: Apache-2.0
#include "school/report/archive.hpp"

#include <fmt/format.h>

#include <memory>

#include "core/phrase.hpp"
#include "core/text.hpp"
#include "school/late/archive.hpp"

namespace zraka {
namespace {

/// The most letters of a name: a file's name has room for 255 bytes.
constexpr std::size_t kMostLetters = 100;

/// The words of a name, of Latin letters only (ASCII's and U+00C0 to U+024F).
std::vector<std::string> words_of(const std::string& author) {
  std::vector<std::string> words;
  if (!is_utf8(author)) return words;
  bool inside = false;
  std::size_t letters = 0;
  for (std::size_t i = 0; i < author.size();) {
    const auto first = static_cast<unsigned char>(author[i]);
    const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    const std::string_view letter = std::string_view(author).substr(i, length);
    i += length;
    bool latin = (first >= 'A' && first <= 'Z') || (first >= 'a' && first <= 'z');
    if (length == 2) {
      const unsigned code = (first & 0x1Fu) << 6 | (static_cast<unsigned char>(letter[1]) & 0x3Fu);
      latin = code >= 0xC0 && code <= 0x24F && code != 0xD7 && code != 0xF7;
    }
    if (latin && ++letters > kMostLetters) break;
    if (latin && !inside) words.emplace_back();
    if (latin) words.back() += letter;
    // An apostrophe, or an accent that follows its letter, parts no name.
    inside = latin || (inside && (letter == "'" || letter == "’" || (first & 0xFE) == 0xCC));
  }
  return words;
}

std::size_t first_letter(const std::string& word) {
  return static_cast<unsigned char>(word[0]) < 0x80 ? 1 : 2;
}

}  // namespace

std::string archive_name(const std::string& author) {
  std::string name;
  for (const std::string& word : words_of(author)) name += capitalized(word);
  return name.empty() ? "" : fmt::format("OVO-V3-Rezultati-{}.zip", name);
}

std::string initial_of(const std::string& author) {
  const std::size_t space = author.find_last_of(' ', author.find_last_not_of(' '));
  const std::vector<std::string> words =
      words_of(space == std::string::npos ? author : author.substr(space));
  if (words.empty()) return "";
  const std::string word = capitalized(words[0]);
  for (const char* letter : {"Dž", "Lj", "Nj"})
    if (word.starts_with(letter)) return letter;
  return word.substr(0, first_letter(word));
}

Result<std::string> zip_of(const std::vector<NamedBytes>& files) {
  if (Result<void> loaded = kLibarchive.load(); !loaded) return tl::make_unexpected(loaded.error());
  std::string zip;
  const std::unique_ptr<archive, int (*)(archive*)> writer(archive_write_new(), archive_write_free);
  const auto append = [](archive*, void* to, const void* bytes, std::size_t size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), size);
    return static_cast<la_ssize_t>(size);
  };
  const auto problem = [&] {
    const char* why = writer ? archive_error_string(writer.get()) : nullptr;
    return failure("", phrase(Word::report_no_archive, why ? why : "not enough memory"));
  };
  if (!writer || archive_write_set_format_zip(writer.get()) != ARCHIVE_OK ||
      archive_write_set_bytes_in_last_block(writer.get(), 1) != ARCHIVE_OK ||
      archive_write_open(writer.get(), &zip, nullptr, append, nullptr) != ARCHIVE_OK)
    return problem();
  for (const NamedBytes& file : files) {
    const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(),
                                                                         archive_entry_free);
    if (!entry) return problem();
    archive_entry_set_pathname(entry.get(), file.name.c_str());
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(file.bytes.size()));
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    if (archive_write_header(writer.get(), entry.get()) != ARCHIVE_OK ||
        archive_write_data(writer.get(), file.bytes.data(), file.bytes.size()) !=
            static_cast<la_ssize_t>(file.bytes.size()))
      return problem();
  }
  if (archive_write_close(writer.get()) != ARCHIVE_OK) return problem();
  return zip;
}

}  // namespace zraka
