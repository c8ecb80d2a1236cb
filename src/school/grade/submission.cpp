// SPDX-License-Identifier: Apache-2.0
#include "school/grade/submission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <mutex>

#include "core/file.hpp"
#include "core/phrase.hpp"
#include "core/text.hpp"
#include "image/alter.hpp"
#include "school/grade/archived.hpp"

namespace zraka {
namespace {

namespace fs = std::filesystem;

/// A screen's worth and more; nobody hands in larger ones by right.
constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 24;
/// Pictures of more pixels are decoded one at a time.
constexpr std::uint64_t kLargePicture = std::uint64_t{1} << 20;
/// Finer detail than this many pixels for one of the right picture says nothing more.
constexpr std::uint32_t kMostScale = 4;
/// Room for a window's frame around a small picture.
constexpr std::uint32_t kFrame = 64;

tl::unexpected<Diagnostics> a_link(const std::string& path) {
  return failure(path, phrase(Word::grade_link), phrase(Word::grade_file_itself));
}

/// Goes through a folder and those in it, and fails where one cannot be read: pictures must not be
/// lost without a word.
class FolderReader {
 public:
  explicit FolderReader(const std::string& path) : path_(path) {}
  Result<std::vector<SubmittedPicture>> read() {
    if (Result<void> good = look_into(path_); !good) return tl::make_unexpected(good.error());
    return std::move(pictures_);
  }

 private:
  Result<void> look_into(const fs::path& folder);
  Result<void> take(const fs::directory_entry& entry);

  const std::string& path_;
  std::size_t seen_ = 0;
  std::vector<SubmittedPicture> pictures_;
};

Result<void> FolderReader::look_into(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> folders;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (++seen_ > kMostEntries)
      return failure(path_, phrase(Word::grade_folder_files, kMostEntries));
    if (is_hidden(it->path().filename())) continue;
    std::error_code unknown;
    if (it->symlink_status(unknown).type() == fs::file_type::directory)
      folders.push_back(it->path());
    else if (Result<void> good = take(*it); !good)
      return good;
  }
  if (error) {
    const std::string inside = folder.lexically_relative(path_).string();
    return failure(path_, inside == "."
                              ? phrase(Word::grade_folder, error.message())
                              : phrase(Word::grade_inner_folder, shown(inside), error.message()));
  }
  for (const fs::path& inner : folders)
    if (Result<void> good = look_into(inner); !good) return good;
  return {};
}

Result<void> FolderReader::take(const fs::directory_entry& entry) {
  std::error_code error;
  const fs::file_type type = entry.symlink_status(error).type();
  const std::string name = entry.path().lexically_relative(path_).string();
  const bool archive = is_archive(name);
  if ((type != fs::file_type::regular && type != fs::file_type::symlink) ||
      !(archive || is_picture(name)))
    return {};
  if (archive && type == fs::file_type::regular) {
    const std::size_t before = pictures_.size();
    Result<void> good = take_from_archive(entry.path().string(), name, pictures_);
    if (good) return good;
    // What else lies there is marked all the same.
    pictures_.resize(before);
    pictures_.push_back({.file = name, .problems = std::move(good.error())});
    return {};
  }
  if (pictures_.size() == kMostPictures) return too_many_pictures(path_);
  SubmittedPicture picture{.file = name,
                           .stage = stage_of_name(entry.path().filename().string()),
                           .path = entry.path().string()};
  if (type == fs::file_type::symlink) picture.problems = a_link(picture.path).value();
  pictures_.push_back(std::move(picture));
  return {};
}

std::string lower_stem(const std::string& file) {
  std::string name = fs::path(file).stem().string();
  for (char& c : name)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  return name;
}

/// 0 where no word tells one.
int stage_of_words(const std::string& name) {
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
  return 0;
}

/// The digits that come last, "" where there are none.
std::string last_number(const std::string& name) {
  const std::size_t last = name.find_last_of("0123456789");
  if (last == std::string::npos) return "";
  const std::size_t before = name.find_last_not_of("0123456789", last);
  const std::size_t first = before == std::string::npos ? 0 : before + 1;
  return name.substr(first, last + 1 - first);
}

/// Seven numbered pictures are the stages in their order, eight the letter's too.
void number_series(std::vector<SubmittedPicture>& pictures) {
  std::vector<std::pair<std::uint64_t, SubmittedPicture*>> series;
  for (SubmittedPicture& picture : pictures) {
    const std::string name = lower_stem(picture.file), digits = last_number(name);
    if (stage_of_words(name) == kNoStage) continue;
    if (stage_of_words(name) != 0 || digits.empty() || digits.size() > 18) return;
    series.emplace_back(std::stoull(digits), &picture);
  }
  if (series.size() != 7 && series.size() != 8) return;
  std::sort(series.begin(), series.end());
  for (std::size_t i = 1; i < series.size(); ++i)
    if (series[i].first == series[i - 1].first) return;
  for (std::size_t i = 0; i < series.size(); ++i) {
    series[i].second->stage = static_cast<int>(i) + 1;
  }
}

}  // namespace

bool is_handed_in(const std::string& file) {
  return is_picture(file) || is_archive(file);
}

bool is_named_for_sure(const std::string& file) {
  return stage_of_words(lower_stem(file)) != 0;
}

int stage_of_name(const std::string& file) {
  const std::string name = lower_stem(file);
  if (const int stage = stage_of_words(name); stage != 0) return stage;
  const std::string digits = last_number(name);
  const std::size_t first = digits.find_first_not_of('0');
  if (first == std::string::npos || digits.size() - first != 1) return 0;
  const int stage = digits[first] - '0';
  return stage > kNoStage ? 0 : stage;
}

Result<std::vector<SubmittedPicture>> read_submission(const std::string& path, Links links) {
  std::error_code error;
  fs::path named(path);
  if (!named.has_filename()) named = named.parent_path();  // a link and a slash is its folder
  if (links == Links::refuse && fs::is_symlink(named, error)) return a_link(path);
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return failure(path, phrase(Word::grade_not_there));
  Result<std::vector<SubmittedPicture>> pictures;
  if (fs::is_directory(status)) {
    pictures = FolderReader(path).read();
  } else if (!fs::is_regular_file(status)) {
    return failure(path, phrase(Word::grade_neither));
  } else if (is_archive(path)) {
    if (Result<void> good = take_from_archive(path, "", *pictures); !good)
      return tl::make_unexpected(good.error());
  } else {
    const std::string file = fs::path(path).filename().string();
    pictures->push_back({.file = file, .stage = stage_of_name(file), .path = path, .alone = true});
  }
  if (!pictures) return pictures;
  if (pictures->empty())
    return failure(path, phrase(Word::grade_no_picture), phrase(Word::grade_hand_in));
  std::sort(pictures->begin(), pictures->end(),
            [](const SubmittedPicture& a, const SubmittedPicture& b) { return a.file < b.file; });
  for (SubmittedPicture& picture : *pictures)
    picture.stage_is_sure = picture.stage != 0 && is_named_for_sure(picture.file);
  number_series(*pictures);
  return pictures;
}

namespace {

struct Sides {
  std::uint32_t width, height;
};

/// What a large picture is made to: smaller by the same factor on both axes, as screens are wider
/// than what they show; only what is far longer than any screen is pressed together.
Sides sides_to_keep(const Image& pixels, const PictureKind& kind) {
  constexpr std::uint32_t kLongest = 2;  // times what its size allows
  const std::uint32_t width = kMostScale * kind.width + kFrame;
  const std::uint32_t height = kMostScale * kind.height + kFrame;
  const double by = std::sqrt(static_cast<double>(width) * height /
                              (static_cast<double>(pixels.width) * pixels.height));
  const auto kept = [&](std::uint32_t side, std::uint32_t most) {
    const auto scaled = by < 1 ? static_cast<std::uint32_t>(std::lround(by * side)) : side;
    return std::clamp(scaled, 1U, kLongest * most);
  };
  return {kept(pixels.width, width), kept(pixels.height, height)};
}

}  // namespace

Result<DecodedPicture> read_picture(const SubmittedPicture& picture, const PictureKind& kind) {
  if (!picture.problems.empty()) return tl::make_unexpected(picture.problems);
  const auto decoded = [&](std::string_view bytes, const std::string& name,
                           std::uint64_t most_pixels) -> Result<DecodedPicture> {
    Result<ReadImage> read = parse_image(bytes, name, most_pixels);
    if (!read) return tl::make_unexpected(read.error());
    DecodedPicture made{std::move(read->image), read->format == "JPEG"};
    if (made.jpeg) made.tables = jpeg_tables(bytes);
    Image& pixels = made.image;
    if (read->floats) pixels = as_stored(pixels, kind.transfer, 8);
    const Sides sides = sides_to_keep(pixels, kind);
    if (sides.width < pixels.width || sides.height < pixels.height) {
      pixels = scaled_by_area(pixels, sides.width, sides.height);
      made.tables.reset();
    }
    if (!made.tables) return made;
    if (std::optional<UnpaintedLines> lines = find_unpainted(pixels, *made.tables)) {
      made.unpainted = std::make_shared<const UnpaintedLines>(std::move(*lines));
      pixels = made.unpainted->painted(made.unpainted->handed_in);
    }
    return made;
  };
  const auto read = [&](std::uint64_t most_pixels) -> Result<DecodedPicture> {
    if (picture.path.empty()) return decoded(picture.bytes, picture.file, most_pixels);
    const Result<std::string> bytes = read_file(picture.path, kMostBytes);
    if (!bytes) return tl::make_unexpected(bytes.error());
    return decoded(*bytes, picture.path, most_pixels);
  };
  if (Result<DecodedPicture> picture_read = read(kLargePicture)) return picture_read;
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  return read(kMostPixels);
}

}  // namespace zraka
