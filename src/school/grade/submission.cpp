// SPDX-License-Identifier: Apache-2.0
#include "school/grade/submission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <new>

#include "core/text.hpp"
#include "school/late/archive.hpp"

namespace zraka {
namespace {

namespace fs = std::filesystem;

/// A screen's worth and more; nobody hands in larger ones by right.
constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 24;
constexpr std::uint64_t kMostBytes = std::uint64_t{64} << 20;
constexpr std::size_t kMostFiles = 64;

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  return text;
}

/// By its name; those of formats that cannot be read are told so.
bool is_picture(const std::string& file) {
  const std::string extension = lower_case(fs::path(file).extension().string());
  for (const char* known : {".png", ".jpg", ".jpeg", ".ppm", ".pgm", ".pnm", ".pfm", ".exr", ".bmp",
                            ".gif", ".tif", ".tiff", ".webp"})
    if (extension == known) return true;
  return false;
}

bool is_hidden(const fs::path& path) {
  for (const fs::path& part : path)
    if (const std::string name = part.string(); name.starts_with('.') || name == "__MACOSX")
      return true;
  return false;
}

tl::unexpected<Diagnostics> too_many(const std::string& path) {
  return failure(path, fmt::format("it holds more than {} pictures", kMostFiles),
                 "hand in the pictures of the seven stages");
}

Result<std::vector<SubmittedPicture>> from_folder(const std::string& path) {
  std::vector<SubmittedPicture> pictures;
  std::error_code error;
  fs::recursive_directory_iterator it(path, error), end;
  if (error) return failure(path, "the folder cannot be read: " + error.message());
  for (std::size_t seen = 0; it != end; it.increment(error)) {
    if (error) return failure(path, "the folder cannot be read: " + error.message());
    if (++seen > 10000) return failure(path, "the folder holds more than 10000 files");
    const fs::path relative = it->path().lexically_relative(path);
    if (it->is_symlink(error) || is_hidden(relative)) {
      it.disable_recursion_pending();
      continue;
    }
    if (it->is_directory(error) && it.depth() >= 2) it.disable_recursion_pending();
    if (!it->is_regular_file(error) || !is_picture(relative.string())) continue;
    if (pictures.size() == kMostFiles) return too_many(path);
    pictures.push_back({relative.string(), stage_of_name(relative.filename().string()), {}, false});
  }
  for (SubmittedPicture& picture : pictures)
    if (picture.stage != kNoStage)
      picture.image = read_image((fs::path(path) / picture.file).string(), kMostPixels);
  return pictures;
}

/// The file at hand, at most kMostBytes of it, whatever the archive says about its size.
Result<std::string> read_entry(archive* from, const std::string& file) {
  std::string bytes, part(std::size_t{1} << 16, '\0');
  for (;;) {
    const la_ssize_t more = archive_read_data(from, part.data(), part.size());
    if (more < 0) return failure(file, "the archive is damaged there");
    if (more == 0) return bytes;
    bytes.append(part, 0, static_cast<std::size_t>(more));
    if (bytes.size() > kMostBytes)
      return failure(file, fmt::format("it unpacks to more than {} MiB", kMostBytes >> 20));
  }
}

/// Everything stays in memory, so no name in an archive can lead anywhere; one that tries is
/// refused all the same.
Result<std::vector<SubmittedPicture>> from_archive(const std::string& path) {
  const std::unique_ptr<archive, int (*)(archive*)> from(archive_read_new(), archive_read_free);
  if (from == nullptr) throw std::bad_alloc();
  archive_read_support_format_zip(from.get());
  if (archive_read_open_filename(from.get(), path.c_str(), std::size_t{1} << 16) != ARCHIVE_OK)
    return failure(path, "the archive is damaged or no zip");
  std::vector<SubmittedPicture> pictures;
  archive_entry* entry = nullptr;
  for (int files = 0;; ++files) {
    const int code = archive_read_next_header(from.get(), &entry);
    if (code == ARCHIVE_EOF) return pictures;
    const char* pathname =
        code == ARCHIVE_OK || code == ARCHIVE_WARN ? archive_entry_pathname(entry) : nullptr;
    if (pathname == nullptr) return failure(path, "the archive is damaged or no zip");
    if (files > 10000) return failure(path, "the archive holds more than 10000 files");
    const std::string name = pathname;
    const fs::path inside(name);
    if (inside.is_absolute() || name.find('\\') != std::string::npos ||
        std::find(inside.begin(), inside.end(), "..") != inside.end())
      return failure(path,
                     fmt::format("the archive has a file outside of its folder: '{}'", shown(name)),
                     "pack the pictures anew, without paths");
    if (archive_entry_filetype(entry) != AE_IFREG || is_hidden(inside) || !is_picture(name))
      continue;
    if (pictures.size() == kMostFiles) return too_many(path);
    SubmittedPicture picture{name, stage_of_name(inside.filename().string()), {}, false};
    if (picture.stage != kNoStage) {
      const Result<std::string> bytes = read_entry(from.get(), name);
      picture.image = bytes ? parse_image(*bytes, name, kMostPixels)
                            : Result<ReadImage>(tl::make_unexpected(bytes.error()));
    }
    pictures.push_back(std::move(picture));
  }
}

}  // namespace

int stage_of_name(const std::string& file) {
  const std::string name = lower_case(fs::path(file).stem().string());
  for (const char* other : {"contact", "difference", "change", "razlik", "letter", "slovo", "heat"})
    if (name.find(other) != std::string::npos) return kNoStage;
  constexpr struct {
    const char* part;
    int stage;
  } kParts[] = {{"refrak", 7}, {"refrac", 7},  {"lomlj", 7},  {"lom", 7},   {"reflek", 6},
                {"reflec", 6}, {"odbij", 6},   {"zrcalj", 6}, {"sjen", 5},  {"shadow", 5},
                {"spekul", 4}, {"specul", 4},  {"zrcal", 4},  {"difuz", 3}, {"diffus", 3},
                {"ambij", 2},  {"ambient", 2}, {"siluet", 1}, {"silhou", 1}};
  for (const auto& [part, stage] : kParts)
    if (name.find(part) != std::string::npos) return stage;
  int stage = 0;
  const auto digit = [&](std::size_t i) {
    return i < name.size() && name[i] >= '0' && name[i] <= '9';
  };
  for (std::size_t i = 0; i < name.size(); ++i)
    if (digit(i) && !digit(i + 1) && (i == 0 || !digit(i - 1) || name[i - 1] == '0'))
      stage = name[i] - '0';
  return stage > kNoStage ? 0 : stage;
}

Result<std::vector<SubmittedPicture>> read_submission(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return failure(path, "there is no such file or folder");
  Result<std::vector<SubmittedPicture>> pictures;
  if (fs::is_directory(status)) {
    pictures = from_folder(path);
  } else if (!fs::is_regular_file(status)) {
    return failure(path, "it is neither a file nor a folder");
  } else if (lower_case(fs::path(path).extension().string()) == ".zip") {
    pictures = from_archive(path);
  } else {
    Result<ReadImage> image = read_image(path, kMostPixels);
    if (!image) return tl::make_unexpected(image.error());
    const std::string file = fs::path(path).filename().string();
    pictures->push_back({file, stage_of_name(file), std::move(image), true});
  }
  if (!pictures) return pictures;
  if (pictures->empty())
    return failure(path, "there is no picture in it",
                   "hand in PNG, JPEG, PPM, PFM or OpenEXR files, called 1 to 7 or by their stage");
  std::sort(pictures->begin(), pictures->end(),
            [](const SubmittedPicture& a, const SubmittedPicture& b) { return a.file < b.file; });
  return pictures;
}

}  // namespace zraka
