// SPDX-License-Identifier: Apache-2.0
// The list of picture formats, and how a file finds its own.
#include <array>
#include <zraka/image.hpp>

#include "core/file.hpp"
#include "core/phrase.hpp"
#include "image/readers.hpp"

namespace zraka {
namespace {

struct ImageFormat {
  std::string_view start;  ///< the file's first bytes
  Result<ReadImage> (*parse)(const ImageFile& file);
};

constexpr std::array kImageFormats = {
    ImageFormat{"\x89PNG\r\n\x1a\n", parse_png},
    ImageFormat{"\xFF\xD8\xFF", parse_jpeg},
    ImageFormat{"P2", parse_pnm},
    ImageFormat{"P3", parse_pnm},
    ImageFormat{"P5", parse_pnm},
    ImageFormat{"P6", parse_pnm},
    ImageFormat{"PF", parse_pfm},
    ImageFormat{"Pf", parse_pfm},
    ImageFormat{"BM", parse_bmp},
    ImageFormat{"#?RADIANCE", parse_hdr},
    ImageFormat{"#?RGBE", parse_hdr},
    ImageFormat{"\x76\x2F\x31\x01", parse_exr},
};

/// Pictures that people have and we cannot read, so that the answer is more than "unknown".
struct OtherFormat {
  std::string_view start, name;
};
constexpr std::array kOtherFormats = {
    OtherFormat{"GIF8", "a GIF"},
    OtherFormat{"RIFF", "a WebP"},
    OtherFormat{"II*", "a TIFF"},
    OtherFormat{{"MM\0*", 4}, "a TIFF"},
    OtherFormat{"%PDF", "a PDF"},
    OtherFormat{"PK\x03\x04", "a zip archive"},
    OtherFormat{"P1", "a PBM"},
    OtherFormat{"P4", "a PBM"},
    OtherFormat{"P7", "a PAM"},
};

/// Croatian has no articles.
std::string without_article(std::string_view name) {
  return std::string(name.substr(name.find(' ') + 1));
}

}  // namespace

Result<void> ImageFile::check_size(std::uint64_t width, std::uint64_t height) const {
  if (width == 0 || height == 0) return failure(name, phrase(Word::image_no_pixels, width, height));
  // Each side first, so that their product cannot run over.
  if (width > max_pixels || height > max_pixels || width * height > max_pixels)
    return failure(name, phrase(Word::image_too_large, width, height, max_pixels));
  return {};
}

namespace {

Result<ReadImage> parse_file(const ImageFile& file) {
  const auto& [bytes, name, max_pixels, alpha] = file;
  if (bytes.empty()) return failure(name, phrase(Word::image_empty));
  for (const ImageFormat& format : kImageFormats)
    if (bytes.starts_with(format.start)) return format.parse(file);
  for (const OtherFormat& other : kOtherFormats)
    if (bytes.starts_with(other.start))
      return failure(
          name,
          phrase(Word::image_other, Phrase{std::string(other.name), without_article(other.name)}),
          phrase(Word::image_save_as, phrase(Word::image_readable)));
  if (is_tga(bytes)) return parse_tga(file);
  return failure(name, phrase(Word::image_unknown), phrase(Word::image_readable));
}

}  // namespace

Result<ReadImage> parse_image(std::string_view bytes, const std::string& name,
                              std::uint64_t max_pixels) {
  return parse_file({bytes, name, max_pixels});
}

Result<ReadImage> parse_image_with_alpha(std::string_view bytes, const std::string& name,
                                         std::uint64_t max_pixels, std::vector<float>& alpha) {
  alpha.clear();
  Result<ReadImage> read = parse_file({bytes, name, max_pixels, &alpha});
  if (read && !read->alpha) alpha.clear();
  return read;
}

Result<ReadImage> read_image(const std::string& path, std::uint64_t max_pixels) {
  // The wordiest file that makes sense: a text PPM of three numbers of five digits a pixel.
  const std::uint64_t most_bytes = (std::uint64_t{1} << 24) + 24 * max_pixels;
  const Result<std::string> bytes = read_file(path, most_bytes);
  if (!bytes) return tl::make_unexpected(bytes.error());
  return parse_image(*bytes, path == "-" ? "standard input" : path, max_pixels);
}

}  // namespace zraka
