// SPDX-License-Identifier: Apache-2.0
// The pictures on Tachyon's surfaces: from files, and written out in the scene.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formats/tachyon_reader.hpp"

namespace zraka {
namespace {

/// One nibble; 16: none.
unsigned hex_digit(char c) {
  if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
  if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a') + 10;
  if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A') + 10;
  return 16;
}

}  // namespace

bool TachyonReader::is_targa(const std::string& name) {
  return name.ends_with(".tga") || name.ends_with(".TGA");
}

Result<Image> TachyonReader::read_picture(const std::string& name) {
  const Result<std::shared_ptr<const Image>> read = images_.load(name, Transfer::linear);
  if (!read) return tl::make_unexpected(read.error());
  return **read;
}

/// The v of a Targa goes up.
Result<Image> TachyonReader::read_targa(const std::string& name) {
  Result<Image> image = read_picture(name);
  if (!image) return image;
  for (std::uint32_t y = 0; y < image->height / 2; ++y)
    std::swap_ranges(image->row(y), image->row(y) + std::size_t{3} * image->width,
                     image->row(image->height - 1 - y));
  return image;
}

/// As Tachyon shows it, from the middle of the first texel to that of the last.
std::shared_ptr<const Image> TachyonReader::image_named(const char* at, const std::string& name,
                                                        int slice) {
  const auto known = cut_images_.find({name, slice});
  if (known != cut_images_.end()) return known->second;
  std::shared_ptr<const Image>& kept = cut_images_[{name, slice}];
  Image whole;
  const auto defined = definitions_.find(name);
  if (defined != definitions_.end()) {
    const auto& [width, height, depth] = defined->second.size;
    whole = Image(width, height);
    const std::size_t from = std::size_t{3} * width * height * static_cast<std::size_t>(slice);
    for (std::size_t i = 0; i < whole.pixels.size(); ++i)
      whole.pixels[i] = static_cast<float>(defined->second.texels[from + i]) / 255;
  } else if (name.starts_with("::")) {
    warn(at, fmt::format("there is no IMAGEDEF '{}' before this: white is drawn", shown(name)));
    return nullptr;
  } else if (!options_.folder) {
    warn(at,
         fmt::format("{} cannot be read, and white is drawn: files beside the scene need a folder",
                     shown(name)));
    return nullptr;
  } else {
    Result<Image> read = is_targa(name) ? read_targa(name) : read_picture(name);
    if (!read) {
      warn(at,
           fmt::format("{} cannot be read, and white is drawn: {}", shown(name),
                       read.error()[0].message),
           read.error()[0].hint);
      return nullptr;
    }
    whole = std::move(*read);
  }
  kept = std::make_shared<const Image>(std::move(whole));
  return kept;
}

bool TachyonReader::read_imagedef() {
  std::string name;
  if (!file_name("a name", name) || !expect("FORMAT") || !expect("RGB24") || !expect("RESOLUTION"))
    return false;
  const char* at = in_->place();
  Definition image;
  std::uint64_t texels = 1;
  for (std::uint32_t& side : image.size) {
    std::size_t n = 0;
    if (!count(n, "RESOLUTION", 1, static_cast<double>(kMaxPixels))) return false;
    side = static_cast<std::uint32_t>(n);
    texels *= n;  // of three numbers of 27 bits
    if (texels == 0 || texels > kMaxPixels)
      return fail(at, fmt::format("RESOLUTION of IMAGEDEF has {} texels: expected from 1 to {}",
                                  texels, kMaxPixels));
  }
  if (!expect("ENCODING") || !expect("HEX")) return false;
  if (4 * texels > in_->left() + 1)
    return fail(at,
                fmt::format("RESOLUTION of IMAGEDEF has {} texels, more than the rest of the file "
                            "can hold",
                            texels));
  image.texels.reserve(3 * texels);
  for (std::uint64_t i = 0; i < texels; ++i) {
    const char* const place = in_->place();
    const std::string_view word = in_->take();
    const std::size_t digits = word.size() / 3;
    bool good = word.size() % 3 == 0 && digits >= 1 && digits <= 4;
    for (std::size_t k = 0; good && k < 3; ++k) {
      const unsigned high = hex_digit(word[k * digits]);
      const unsigned low = hex_digit(word[k * digits + (digits > 1 ? 1 : 0)]);
      for (std::size_t d = 0; d < digits; ++d) good = good && hex_digit(word[k * digits + d]) < 16;
      image.texels.push_back(static_cast<unsigned char>(16 * high + low));
    }
    if (!good)
      return fail(place, fmt::format("'{}' is no colour of IMAGEDEF: expected 3, 6, 9 or 12 "
                                     "hexadecimal digits",
                                     shown(word)));
  }
  definitions_[name] = std::move(image);
  return true;
}

}  // namespace zraka
