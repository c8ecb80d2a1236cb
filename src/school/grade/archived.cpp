// SPDX-License-Identifier: Apache-2.0
#include "school/grade/archived.hpp"

#include <locale.h>

#include <algorithm>
#include <memory>
#include <new>

#include "core/file.hpp"
#include "core/phrase.hpp"
#include "core/text.hpp"
#include "school/grade/pdf.hpp"
#include "school/late/archive.hpp"

namespace zraka {
namespace {

namespace fs = std::filesystem;

/// Of a file whose name in an archive is in no encoding: it may be a picture.
constexpr const char* kUnknownName = "?";
/// An archive of archives of documents, and no deeper.
constexpr int kDeepest = 2;

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  return text;
}

/// The file at hand, at most kMostBytes of it, whatever the archive says about its size.
Result<std::string> read_entry(archive* from, const std::string& file) {
  std::string bytes, part(std::size_t{1} << 16, '\0');
  for (;;) {
    const la_ssize_t more = archive_read_data(from, part.data(), part.size());
    if (more < 0) return failure(file, phrase(Word::grade_damaged_there));
    if (more == 0) return bytes;
    bytes.append(part, 0, static_cast<std::size_t>(more));
    if (bytes.size() > kMostBytes)
      return failure(file, phrase(Word::grade_unpacks, kMostBytes >> 20));
  }
}

/// Lets libarchive say names in UTF-8 on this thread: in the C locale, which a program starts with,
/// it gives those that are not ASCII up.
class Utf8Names {
 public:
  Utf8Names() {
    for (const char* name : {"C.UTF-8", "en_US.UTF-8", "UTF-8"})
      if (own_ == nullptr) own_ = ::newlocale(LC_CTYPE_MASK, name, nullptr);
    if (own_ != nullptr) before_ = ::uselocale(own_);
  }
  ~Utf8Names() {
    if (own_ == nullptr) return;
    ::uselocale(before_);
    ::freelocale(own_);
  }
  Utf8Names(const Utf8Names&) = delete;
  Utf8Names& operator=(const Utf8Names&) = delete;

 private:
  locale_t own_ = nullptr, before_ = nullptr;
};

/// Documents keep their pictures in folders of this name.
bool is_document(const std::string& file) {
  const std::string extension = lower_case(fs::path(file).extension().string());
  return extension == ".docx" || extension == ".odt";
}

bool is_pdf(const std::string& file) {
  return lower_case(fs::path(file).extension().string()) == ".pdf";
}

/// Reads an archive, and those in it.
class ArchiveReader {
 public:
  ArchiveReader(const std::string& path, std::vector<SubmittedPicture>& pictures)
      : path_(path), pictures_(pictures) {
    for (const SubmittedPicture& picture : pictures) bytes_in_all_ += picture.bytes.size();
  }
  Result<void> read_file(const std::string& within);

 private:
  using Handle = std::unique_ptr<archive, int (*)(archive*)>;
  Handle opened() const {
    Handle from(archive_read_new(), archive_read_free);
    if (from == nullptr) throw std::bad_alloc();
    archive_read_support_format_zip(from.get());
    return from;
  }
  tl::unexpected<Diagnostics> damaged() const {
    return failure(path_, phrase(Word::grade_damaged));
  }
  Result<void> read(archive* from, const std::string& within, bool document, int depth);
  Result<void> take(archive* from, const std::string& name, const std::string& shown_as,
                    bool document, int depth);

  const std::string& path_;
  std::vector<SubmittedPicture>& pictures_;
  std::uint64_t bytes_in_all_ = 0;
  std::size_t entries_ = 0;
};

Result<void> ArchiveReader::read_file(const std::string& within) {
  const Handle from = opened();
  if (archive_read_open_filename(from.get(), path_.c_str(), std::size_t{1} << 16) != ARCHIVE_OK)
    return damaged();
  return read(from.get(), within, is_document(path_), 0);
}

Result<void> ArchiveReader::read(archive* from, const std::string& within, bool document,
                                 int depth) {
  archive_entry* entry = nullptr;
  for (;;) {
    const int code = archive_read_next_header(from, &entry);
    if (code == ARCHIVE_EOF) return {};
    // Names in old encodings come with a warning.
    if (code != ARCHIVE_OK && code != ARCHIVE_WARN) return damaged();
    if (entries_++ == kMostEntries)
      return failure(path_, phrase(Word::grade_archive_files, kMostEntries));
    const char* pathname = archive_entry_pathname(entry);
    const std::string name = pathname != nullptr ? pathname : kUnknownName;
    const fs::path inside(name);
    if (inside.is_absolute() || name.find('\\') != std::string::npos ||
        std::find(inside.begin(), inside.end(), "..") != inside.end())
      return failure(path_, phrase(Word::grade_outside, shown(name)),
                     phrase(Word::grade_pack_anew));
    if (archive_entry_filetype(entry) != AE_IFREG || is_hidden(inside)) continue;
    const std::string called = within.empty() ? name : within + "/" + name;
    if (Result<void> good = take(from, name, called, document, depth); !good) return good;
  }
}

Result<void> ArchiveReader::take(archive* from, const std::string& name, const std::string& called,
                                 bool document, int depth) {
  // A document's thumbnails and themes are no pictures of the scene.
  if (document && name.find("media/") == std::string::npos &&
      name.find("Pictures/") == std::string::npos)
    return {};
  const bool archived = !document && depth < kDeepest && is_archive(name);
  if (!archived && !is_picture(name) && name != kUnknownName) return {};
  if (!archived && pictures_.size() == kMostPictures) return too_many_pictures(path_);
  SubmittedPicture picture{
      .file = called,
      .stage = document ? 0 : stage_of_name(fs::path(name).filename().string()),
      .document = document};
  if (!archived && picture.stage == kNoStage) {
    pictures_.push_back(std::move(picture));
    return {};
  }
  Result<std::string> bytes = read_entry(from, name);
  if (!bytes) {
    if (archived) return tl::make_unexpected(bytes.error());
    picture.problems = bytes.error();
  } else {
    bytes_in_all_ += bytes->size();
    if (bytes_in_all_ > kMostBytesInAll)
      return failure(path_, phrase(Word::grade_unpacks_all, kMostBytesInAll >> 20));
    if (archived && is_pdf(name)) return take_from_pdf(*bytes, called, pictures_);
    if (archived) {
      const Handle inner = opened();
      if (archive_read_open_memory(inner.get(), bytes->data(), bytes->size()) != ARCHIVE_OK)
        return damaged();
      return read(inner.get(), called, is_document(name), depth + 1);
    }
    picture.bytes = std::move(*bytes);
  }
  pictures_.push_back(std::move(picture));
  return {};
}

}  // namespace

bool is_picture(const std::string& file) {
  const std::string extension = lower_case(fs::path(file).extension().string());
  for (const char* known : {".png", ".jpg", ".jpeg", ".ppm", ".pgm", ".pnm", ".pfm", ".exr", ".bmp",
                            ".tga", ".gif", ".tif", ".tiff", ".webp"})
    if (extension == known) return true;
  return false;
}

bool is_hidden(const fs::path& path) {
  for (const fs::path& part : path)
    if (const std::string name = part.string(); name.starts_with('.') || name == "__MACOSX")
      return true;
  return false;
}

bool is_archive(const std::string& file) {
  return lower_case(fs::path(file).extension().string()) == ".zip" || is_document(file) ||
         is_pdf(file);
}

tl::unexpected<Diagnostics> too_many_pictures(const std::string& path) {
  return failure(path, phrase(Word::grade_too_many, kMostPictures), phrase(Word::grade_seven));
}

Result<void> take_from_archive(const std::string& path, const std::string& within,
                               std::vector<SubmittedPicture>& pictures) {
  if (is_pdf(path)) {
    const Result<std::string> bytes = read_file(path, kMostBytes);
    if (!bytes) return tl::make_unexpected(bytes.error());
    return take_from_pdf(*bytes, within.empty() ? fs::path(path).filename().string() : within,
                         pictures);
  }
  if (Result<void> loaded = kLibarchive.load(); !loaded) return loaded;
  const Utf8Names utf8_names;
  return ArchiveReader(path, pictures).read_file(within);
}

}  // namespace zraka
