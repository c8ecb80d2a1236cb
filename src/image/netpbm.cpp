// SPDX-License-Identifier: Apache-2.0
// PPM, PGM and PFM: numbers with a short header (netpbm's manuals ppm(5), pgm(5) and pfm(5)).
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include "core/text.hpp"
#include "image/readers.hpp"

namespace zraka {
namespace {

bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

/// Goes through a file word by word, and knows where it is.
class Words {
 public:
  explicit Words(const ImageFile& file) : file_(file), places_(file.bytes) {}

  /// The next word; comments run from # to the end of the line. Empty at the end.
  std::string_view next() {
    for (; at_ < file_.bytes.size(); ++at_) {
      if (file_.bytes[at_] == '#') {
        at_ = std::min(file_.bytes.find('\n', at_), file_.bytes.size());
        if (at_ == file_.bytes.size()) break;
      } else if (!is_space(file_.bytes[at_])) {
        break;
      }
    }
    start_ = at_;
    while (at_ < file_.bytes.size() && !is_space(file_.bytes[at_]) && file_.bytes[at_] != '#')
      ++at_;
    return file_.bytes.substr(start_, at_ - start_);
  }

  /// The next word as a whole number from 0 to `most`.
  Result<std::uint32_t> whole(std::uint32_t most, std::string_view what) {
    const std::string_view word = next();
    if (word.empty()) return problem(fmt::format("the file ends: expected {}", what));
    std::uint64_t value = 0;
    for (const char c : word) {
      if (c < '0' || c > '9' || value > most)
        return problem(fmt::format("'{}' is not {}: expected a whole number up to {}", shown(word),
                                   what, most));
      value = 10 * value + static_cast<std::uint64_t>(c - '0');
    }
    if (value > most)
      return problem(
          fmt::format("'{}' is not {}: expected a whole number up to {}", shown(word), what, most));
    return static_cast<std::uint32_t>(value);
  }

  /// A problem with the word that was read last.
  tl::unexpected<Diagnostics> problem(std::string message) {
    Diagnostic d;
    d.file = file_.name;
    const TextPosition place = places_.at(start_);
    d.line = place.line;
    d.column = place.column;
    d.message = std::move(message);
    return tl::make_unexpected(Diagnostics{std::move(d)});
  }

  /// What comes after the header and the one white space that ends it.
  Result<std::string_view> rest(std::uint64_t wanted) {
    const std::uint64_t left = at_ < file_.bytes.size() ? file_.bytes.size() - at_ - 1 : 0;
    if (left < wanted)
      return failure(file_.name, fmt::format("is cut off: {} bytes of pixels are there, where {} "
                                             "were expected",
                                             left, wanted));
    return file_.bytes.substr(at_ + 1, wanted);
  }

  std::uint64_t bytes_left() const { return file_.bytes.size() - at_; }

 private:
  const ImageFile& file_;
  TextPositions places_;
  std::size_t at_ = 2, start_ = 0;
};

constexpr std::uint32_t kMostSide = 0x7FFFFFFF;

struct Size {
  std::uint32_t width = 0, height = 0;
  std::uint64_t pixels() const { return std::uint64_t{width} * height; }
};

Result<Size> read_size(Words& words, const ImageFile& file) {
  const Result<std::uint32_t> width = words.whole(kMostSide, "the width");
  if (!width) return tl::make_unexpected(width.error());
  const Result<std::uint32_t> height = words.whole(kMostSide, "the height");
  if (!height) return tl::make_unexpected(height.error());
  if (const Result<void> fits = file.check_size(*width, *height); !fits)
    return tl::make_unexpected(fits.error());
  return Size{*width, *height};
}

tl::unexpected<Diagnostics> too_bright(const ImageFile& file, std::uint64_t pixel,
                                       std::uint32_t width, std::uint32_t value,
                                       std::uint32_t most) {
  return failure(file.name, fmt::format("pixel ({}, {}) holds {}, where {} is the largest value",
                                        pixel % width, pixel / width, value, most));
}

}  // namespace

Result<ReadImage> parse_pnm(const ImageFile& file) {
  const char kind = file.bytes[1];
  const bool text = kind == '2' || kind == '3';
  const std::uint64_t channels = kind == '3' || kind == '6' ? 3 : 1;
  Words words(file);
  const Result<Size> size = read_size(words, file);
  if (!size) return tl::make_unexpected(size.error());
  const Result<std::uint32_t> most = words.whole(65535, "the largest value");
  if (!most) return tl::make_unexpected(most.error());
  if (*most == 0) return words.problem("the largest value is 0: expected 1 to 65535");

  const std::uint64_t values = size->pixels() * channels;
  const std::uint64_t bytes_each = *most < 256 ? 1 : 2;
  std::string_view stored;
  if (text) {
    // Each value is at least a white space and a digit.
    if (words.bytes_left() < 2 * values)
      return failure(file.name, fmt::format("is cut off: {} bytes cannot hold {} values",
                                            words.bytes_left(), values));
  } else {
    const Result<std::string_view> rest = words.rest(values * bytes_each);
    if (!rest) return tl::make_unexpected(rest.error());
    stored = *rest;
  }

  ReadImage read;
  read.format = channels == 3 ? "PPM" : "PGM";
  read.bits = *most < 256 ? 8 : 16;
  read.image = Image(size->width, size->height);
  const auto largest = static_cast<float>(*most);
  if (bytes_each == 1 && !text && *most == 255 && channels == 3) {  // as nearly all have it
    float value_of[256];
    for (int value = 0; value < 256; ++value) value_of[value] = static_cast<float>(value) / largest;
    for (std::size_t i = 0; i < stored.size(); ++i)
      read.image.pixels[i] = value_of[static_cast<unsigned char>(stored[i])];
    return read;
  }
  const char* at = stored.data();
  float* out = read.image.pixels.data();
  for (std::uint64_t i = 0; i < size->pixels(); ++i, out += 3)
    for (std::uint64_t c = 0; c < 3; ++c) {
      if (c >= channels) {
        out[c] = out[0];
        continue;
      }
      std::uint32_t value = 0;
      if (text) {
        const Result<std::uint32_t> word = words.whole(*most, "a value of a pixel");
        if (!word) return tl::make_unexpected(word.error());
        value = *word;
      } else {
        value = static_cast<unsigned char>(*at++);
        if (bytes_each == 2) value = value << 8 | static_cast<unsigned char>(*at++);
        if (value > *most) return too_bright(file, i, size->width, value, *most);
      }
      out[c] = static_cast<float>(value) / largest;
    }
  return read;
}

Result<ReadImage> parse_pfm(const ImageFile& file) {
  const std::uint64_t channels = file.bytes[1] == 'F' ? 3 : 1;
  Words words(file);
  const Result<Size> size = read_size(words, file);
  if (!size) return tl::make_unexpected(size.error());
  const std::string_view word = words.next();
  const std::optional<double> scale = parse_number(word);
  if (!scale || !std::isfinite(*scale) || *scale == 0)
    return words.problem(fmt::format(
        "'{}' is not the scale: expected a number other than 0, below 0 where the least "
        "byte comes first",
        shown(word)));
  const Result<std::string_view> stored = words.rest(size->pixels() * channels * sizeof(float));
  if (!stored) return tl::make_unexpected(stored.error());

  // Only the sign of the scale counts: programs do not agree on what its size is for.
  const bool swap = (std::endian::native == std::endian::little) != (*scale < 0);
  ReadImage read;
  read.format = "PFM";
  read.bits = 32;
  read.floats = true;
  read.image = Image(size->width, size->height);
  const char* at = stored->data();
  for (std::uint32_t row = size->height; row-- > 0;) {  // the lowest row comes first
    float* out = read.image.row(row);
    for (std::size_t i = 0; i < size->width * channels; ++i, at += sizeof(float)) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, at, sizeof(bits));
      if (swap) bits = __builtin_bswap32(bits);
      const auto v = std::bit_cast<float>(bits);
      if (channels == 3)
        out[i] = v;
      else
        out[3 * i] = out[3 * i + 1] = out[3 * i + 2] = v;
    }
  }
  return read;
}

}  // namespace zraka
