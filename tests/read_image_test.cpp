// SPDX-License-Identifier: Apache-2.0
// Readers of pictures: every kind against files that the libraries wrote, and files that mean harm.
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <zraka/image.hpp>

#include "picture_files.hpp"

namespace zraka {
namespace {

using Bytes = std::vector<unsigned char>;

/// A sample of 0…2^bits - 1 for each pixel and channel.
unsigned sample(std::uint32_t x, std::uint32_t y, unsigned channel, int bits) {
  return (x * 7 + y * 13 + channel * 29 + x * y) * (bits == 16 ? 257 : 1) % (1u << bits);
}

/// Samples packed into rows as PNG has it: the first pixel in the highest bits, high bytes first.
std::vector<Bytes> packed(std::uint32_t width, std::uint32_t height, unsigned channels, int bits) {
  std::vector<Bytes> rows;
  for (std::uint32_t y = 0; y < height; ++y) {
    Bytes row((width * channels * static_cast<unsigned>(bits) + 7) / 8, 0);
    for (std::uint32_t i = 0; i < width * channels; ++i) {
      const unsigned v = sample(i / channels, y, i % channels, bits);
      if (bits == 16) {
        row[2 * i] = static_cast<unsigned char>(v >> 8);
        row[2 * i + 1] = static_cast<unsigned char>(v & 255);
      } else {
        const unsigned at = i * static_cast<unsigned>(bits);
        row[at / 8] = static_cast<unsigned char>(row[at / 8] |
                                                 v << (8 - static_cast<unsigned>(bits) - at % 8));
      }
    }
    rows.push_back(row);
  }
  return rows;
}

struct PngCase {
  int color_type, bits;
  unsigned channels;
};
constexpr PngCase kPngCases[] = {
    {PNG_COLOR_TYPE_GRAY, 1, 1},        {PNG_COLOR_TYPE_GRAY, 2, 1},
    {PNG_COLOR_TYPE_GRAY, 4, 1},        {PNG_COLOR_TYPE_GRAY, 8, 1},
    {PNG_COLOR_TYPE_GRAY, 16, 1},       {PNG_COLOR_TYPE_GRAY_ALPHA, 8, 2},
    {PNG_COLOR_TYPE_GRAY_ALPHA, 16, 2}, {PNG_COLOR_TYPE_RGB, 8, 3},
    {PNG_COLOR_TYPE_RGB, 16, 3},        {PNG_COLOR_TYPE_RGB_ALPHA, 8, 4},
    {PNG_COLOR_TYPE_RGB_ALPHA, 16, 4}};

TEST(ReadPng, ReadsEveryTypeAndDepthInterlacedOrNot) {
  constexpr std::uint32_t kWidth = 19, kHeight = 11;
  for (const PngCase& c : kPngCases)
    for (const bool interlaced : {false, true}) {
      const auto rows = packed(kWidth, kHeight, c.channels, c.bits);
      const std::string file =
          png_file(kWidth, kHeight,
                   {.color_type = c.color_type, .bits = c.bits, .interlaced = interlaced}, rows);
      const Result<ReadImage> read = parse_image(file, "a");
      ASSERT_TRUE(read) << to_string(read.error().front());
      EXPECT_EQ(read->format, "PNG");
      EXPECT_EQ(read->bits, c.bits == 16 ? 16 : 8);
      EXPECT_EQ(read->alpha, c.channels % 2 == 0);
      EXPECT_FALSE(read->floats);
      ASSERT_EQ(read->image.width, kWidth);
      ASSERT_EQ(read->image.height, kHeight);
      const double most = (1 << c.bits) - 1;
      for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t x = 0; x < kWidth; ++x)
          for (unsigned k = 0; k < 3; ++k) {
            const double alpha =
                c.channels % 2 == 0 ? sample(x, y, c.channels - 1, c.bits) / most : 1;
            const double stored = sample(x, y, c.channels < 3 ? 0 : k, c.bits) / most;
            ASSERT_NEAR(read->image.row(y)[3 * x + k], stored * alpha, 1e-6)
                << c.color_type << " with " << c.bits << " bits at " << x << ", " << y;
          }
    }
}

TEST(ReadPng, LooksPalettesUpAndLaysTransparentColorsOverBlack) {
  const Bytes palette = {255, 0, 51, 0, 102, 255, 204, 204, 0};
  for (const int bits : {2, 4, 8}) {
    std::vector<Bytes> rows = {Bytes(3, 0)};
    for (unsigned x = 0; x < 3; ++x)
      rows[0][x * static_cast<unsigned>(bits) / 8] |= static_cast<unsigned char>(
          x << (8 - static_cast<unsigned>(bits) - x * static_cast<unsigned>(bits) % 8));
    for (const bool transparent : {false, true}) {
      PngKind kind{.color_type = PNG_COLOR_TYPE_PALETTE, .bits = bits, .palette = palette};
      if (transparent) kind.transparency = {255, 51};
      const ReadImage read = parse_image(png_file(3, 1, kind, rows), "a").value();
      EXPECT_EQ(read.alpha, transparent);
      for (std::size_t i = 0; i < 9; ++i) {
        const float alpha = transparent && i / 3 == 1 ? 0.2f : 1.0f;
        EXPECT_NEAR(read.image.pixels[i], alpha * palette[i] / 255.0f, 1e-6) << i;
      }
    }
  }
}

TEST(ReadPng, ReadsWhatWritePngWrote) {
  Image image(23, 9);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<float>(i) / 620.0f;
  for (const int bits : {8, 16}) {
    const ReadImage read = parse_image(encode_png(image, {bits}).value(), "a").value();
    const float most = bits == 8 ? 255.0f : 65535.0f;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      ASSERT_EQ(read.image.pixels[i],
                static_cast<float>(quantize(image.pixels[i], Transfer::linear, bits)) / most);
  }
}

/// A chunk of bytes, with a sum that libpng does not look at in chunks that are passed over.
std::string chunk(const std::string& name, std::uint32_t size) {
  std::string text;
  for (const int shift : {24, 16, 8, 0}) text += static_cast<char>(size >> shift & 255);
  return text + name + std::string(size + 4, 'x');
}

TEST(ReadPng, PassesOverLargeChunksThatAreNoPixels) {
  std::string file = png_file(19, 11, {}, packed(19, 11, 3, 8));
  for (const char* name : {"tEXt", "iCCP", "eXIf", "abCd"})
    file.insert(33, chunk(name, 9000000));  // behind the header
  const Result<ReadImage> read = parse_image(file, "a");
  EXPECT_TRUE(read) << to_string(read.error().front());
}

TEST(ReadPng, SaysWhatIsWrong) {
  const std::string good = png_file(19, 11, {}, packed(19, 11, 3, 8));
  EXPECT_EQ(error_of(good.substr(0, good.size() / 2)),
            "a: error: is no PNG that can be read: the file ends too early\n");
  std::string damaged = good;
  damaged[good.size() - 13] ^= 4;  // the sum before the last chunk, which has 12 bytes
  EXPECT_EQ(error_of(damaged), "a: error: is no PNG that can be read: IDAT: CRC error\n");
  EXPECT_EQ(error_of(good, 208),
            "a: error: is too large: 19×11 pixels, where at most 208 in all are read\n");

  // A header that promises more than there is: refused before memory is taken. libpng checks sums,
  // so the header comes from a file that libpng wrote.
  const std::string large =
      png_file(60000, 2000, {.color_type = 0, .bits = 1}, std::vector<Bytes>(2000, Bytes(7500, 0)));
  EXPECT_EQ(error_of(large.substr(0, 200)),
            "a: error: is cut off: 200 bytes cannot hold 60000×2000 pixels\n");
  EXPECT_EQ(error_of(large, 1 << 20),
            "a: error: is too large: 60000×2000 pixels, where at most 1048576 in all are read\n");
}

Bytes smooth_bytes(std::uint32_t width, std::uint32_t height, unsigned channels) {
  Bytes bytes;
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x)
      for (unsigned c = 0; c < channels; ++c)
        bytes.push_back(static_cast<unsigned char>(40 + 3 * x + 2 * y + 30 * c));
  return bytes;
}

TEST(ReadJpeg, ReadsColorAndGreyPlainAndProgressive) {
  constexpr std::uint32_t kWidth = 37, kHeight = 21;
  for (const int channels : {1, 3})
    for (const bool progressive : {false, true})
      for (const bool subsampled : {false, true}) {
        const Bytes bytes = smooth_bytes(kWidth, kHeight, static_cast<unsigned>(channels));
        const JpegKind kind{.quality = 100,
                            .channels = channels,
                            .progressive = progressive,
                            .subsampled = subsampled};
        const Result<ReadImage> read = parse_image(jpeg_file(kWidth, kHeight, kind, bytes), "a");
        ASSERT_TRUE(read) << to_string(read.error().front());
        EXPECT_EQ(read->format, "JPEG");
        EXPECT_EQ(read->bits, 8);
        ASSERT_EQ(read->image.width, kWidth);
        ASSERT_EQ(read->image.height, kHeight);
        for (std::size_t i = 0; i < read->image.pixels.size(); ++i) {
          const std::size_t from = channels == 3 ? i : i / 3;
          ASSERT_NEAR(read->image.pixels[i] * 255, bytes[from], 3.1) << i;
        }
      }
}

TEST(ReadJpeg, SaysWhatIsWrong) {
  const Bytes bytes = smooth_bytes(64, 48, 3);
  const std::string good = jpeg_file(64, 48, {}, bytes);
  EXPECT_EQ(error_of(good.substr(0, good.size() - 40)),
            "a: error: is no JPEG that can be read: Premature end of JPEG file\n");
  EXPECT_EQ(error_of(good.substr(0, 3)),
            "a: error: is no JPEG that can be read: Premature end of JPEG file\n");
  EXPECT_EQ(error_of("\xFF\xD8\xFF\xD9"),
            "a: error: is no JPEG that can be read: JPEG datastream contains no image\n");
  EXPECT_EQ(error_of(good, 64 * 48 - 1),
            "a: error: is too large: 64×48 pixels, where at most 3071 in all are read\n");
  EXPECT_EQ(
      error_of(jpeg_file(8, 8, {.channels = 4}, smooth_bytes(8, 8, 4))),
      "a: error: is a JPEG for printing, with four inks (CMYK)\n  save it with red, green and "
      "blue\n");
}

TEST(ReadJpeg, RefusesPicturesOfTooManyScans) {
  // Each scan costs the time of a whole picture.
  const std::string many = jpeg_file(16, 16, {.many_scans = true}, smooth_bytes(16, 16, 3));
  EXPECT_EQ(error_of(many), "a: error: is no JPEG that can be read: it has more than 100 scans\n");
}

TEST(ReadPnm, ReadsTextAndBytesOfAnyDepth) {
  struct Case {
    std::string file, format;
    int bits;
    std::vector<float> first;
  };
  const std::vector<Case> cases = {
      {"P3\n# a comment\n2 1\n255\n255 0 51\n102 # here too\n 204 255\n",
       "PPM",
       8,
       {1, 0, 0.2f, 0.4f, 0.8f, 1}},
      {"P3 1 1 1000 1000 500 0", "PPM", 16, {1, 0.5f, 0}},
      {"P2\n2 1\n15\n15 3", "PGM", 8, {1, 1, 1, 0.2f, 0.2f, 0.2f}},
      {std::string("P6 1 1 255\n\xFF\x33\x00", 14), "PPM", 8, {1, 0.2f, 0}},
      {std::string("P6\n1 1\n65535\n\xFF\xFF\x00\x00\x33\x33", 19), "PPM", 16, {1, 0, 0.2f}},
      {std::string("P5 2 1 100\n\x64\x32", 13), "PGM", 8, {1, 1, 1, 0.5f, 0.5f, 0.5f}},
      {std::string("P5 1 1 1000\n\x01\xF4", 14), "PGM", 16, {0.5f, 0.5f, 0.5f}},
  };
  for (const Case& c : cases) {
    const Result<ReadImage> read = parse_image(c.file, "a");
    ASSERT_TRUE(read) << c.file << to_string(read.error().front());
    EXPECT_EQ(read->format, c.format) << c.file;
    EXPECT_EQ(read->bits, c.bits) << c.file;
    EXPECT_EQ(read->image.pixels, c.first) << c.file;
  }
}

TEST(ReadPnm, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(error_of("P3\n2 x\n255\n"),
            "a:2:3: error: 'x' is not the height: expected a whole number up to 2147483647\n");
  EXPECT_EQ(error_of("P3\n2 -1\n255\n"),
            "a:2:3: error: '-1' is not the height: expected a whole number up to 2147483647\n");
  EXPECT_EQ(error_of("P6\n2"), "a:2:2: error: the file ends: expected the height\n");
  EXPECT_EQ(error_of("P6 0 4 255\n"), "a: error: has no pixels: 0×4\n");
  EXPECT_EQ(error_of("P6 2147483647 2147483647 255\n"),
            "a: error: is too large: 2147483647×2147483647 pixels, where at most 134217728 in all "
            "are read\n");
  EXPECT_EQ(error_of("P6 2147483648 1 255\n"),
            "a:1:4: error: '2147483648' is not the width: expected a whole number up to "
            "2147483647\n");
  EXPECT_EQ(error_of("P6 99999999999999999999999 1 255\n"),
            "a:1:4: error: '99999999999999999999999' is not the width: expected a whole number up "
            "to 2147483647\n");
  EXPECT_EQ(
      error_of("P6 1 1 65536\n"),
      "a:1:8: error: '65536' is not the largest value: expected a whole number up to 65535\n");
  EXPECT_EQ(error_of("P6 1 1 0\n"), "a:1:8: error: the largest value is 0: expected 1 to 65535\n");
  EXPECT_EQ(error_of("P6 10000 10000 255\n123"),
            "a: error: is cut off: 3 bytes of pixels are there, where 300000000 were expected\n");
  EXPECT_EQ(error_of("P3 10000 10000 255\n1 2 3"),
            "a: error: is cut off: 6 bytes cannot hold 300000000 values\n");
  EXPECT_EQ(error_of("P3 1 1 255\n1 2 # 3   "),
            "a:2:11: error: the file ends: expected a value of a pixel\n");
  EXPECT_EQ(error_of("P3 2 1 100\n1 2 3\n4 101 6 "),
            "a:3:3: error: '101' is not a value of a pixel: expected a whole number up to 100\n");
  EXPECT_EQ(error_of("P5 2 1 100\n\x01\x65"),
            "a: error: pixel (1, 0) holds 101, where 100 is the largest value\n");
  EXPECT_EQ(error_of("P4 8 1 x"),
            "a: error: is a PBM, which cannot be read here\n  save it as PNG; PNG, JPEG, BMP, TGA, "
            "PPM, PGM, PFM, Radiance HDR and OpenEXR can be read\n");
}

std::string float_bytes(const std::vector<float>& values, bool big_endian) {
  std::string bytes;
  for (const float v : values) {
    char raw[4];
    std::memcpy(raw, &v, 4);
    if (big_endian) std::swap(raw[0], raw[3]), std::swap(raw[1], raw[2]);
    bytes.append(raw, 4);
  }
  return bytes;
}

TEST(ReadPfm, StartsWithTheLowestRowInEitherOrderOfBytes) {
  const float inf = std::numeric_limits<float>::infinity();
  for (const bool big_endian : {false, true}) {
    const std::string scale = big_endian ? "1.0" : "-1.0";
    const ReadImage color =
        parse_image("PF\n1 2\n" + scale + "\n" + float_bytes({1, 2, -3, 0.5f, inf, 6}, big_endian),
                    "a")
            .value();
    EXPECT_EQ(color.format, "PFM");
    EXPECT_EQ(color.bits, 32);
    EXPECT_TRUE(color.floats);
    EXPECT_EQ(color.image.pixels, (std::vector<float>{0.5f, inf, 6, 1, 2, -3}));
    const ReadImage grey =
        parse_image("Pf 2 1 " + scale + " " + float_bytes({7, 8}, big_endian), "a").value();
    EXPECT_EQ(grey.image.pixels, (std::vector<float>{7, 7, 7, 8, 8, 8}));
  }
  EXPECT_EQ(error_of("PF 1 1 0\n"),
            "a:1:8: error: '0' is not the scale: expected a number other than 0, below 0 where the "
            "least byte comes first\n");
  EXPECT_EQ(error_of("PF 1 1 -1\n123"),
            "a: error: is cut off: 3 bytes of pixels are there, where 12 were expected\n");
}

TEST(ReadImage, GoesByContentNotByName) {
  const std::string path = testing::TempDir() + "zraka-wrong-name.jpg";
  ASSERT_TRUE(write_png(Image(3, 2), path));
  const Result<ReadImage> read = read_image(path);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->format, "PNG");
  std::filesystem::remove(path);
}

TEST(ReadImage, NamesOtherKindsOfFiles) {
  constexpr const char* kReadable =
      "PNG, JPEG, BMP, TGA, PPM, PGM, PFM, Radiance HDR and OpenEXR can be read";
  EXPECT_EQ(error_of(""), "a: error: the file is empty\n");
  EXPECT_EQ(error_of("hello"),
            std::string("a: error: is no picture of a known kind\n  ") + kReadable + "\n");
  EXPECT_EQ(error_of("GIF89a"), std::string("a: error: is a GIF, which cannot be read here\n  "
                                            "save it as PNG; ") +
                                    kReadable + "\n");
  const Result<ReadImage> none = read_image("/nowhere.png");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().front().message, "cannot be read: No such file or directory");
}

/// One file of each kind.
std::vector<std::string> small_files() {
  std::vector<std::string> files;
  for (const PngCase& c : kPngCases)
    files.push_back(png_file(9, 7, {.color_type = c.color_type, .bits = c.bits, .interlaced = true},
                             packed(9, 7, c.channels, c.bits)));
  files.push_back(jpeg_file(20, 12, {}, smooth_bytes(20, 12, 3)));
  files.push_back(
      jpeg_file(20, 12, {.progressive = true, .subsampled = true}, smooth_bytes(20, 12, 3)));
  for (const bool tiled : {false, true})
    for (int compression = 0; compression <= 9; ++compression)
      files.push_back(exr_file({.channels = {"A", "B", "G", "R"},
                                .half = compression % 2 == 0,
                                .tiled = tiled,
                                .compression = compression},
                               exr_sample));
  files.push_back("P3 2 2 255 1 2 3 4 5 6 7 8 9 10 11 12");
  files.push_back("P6 2 2 255 123456789012");
  files.push_back("PF 1 1 -1 123456789012");
  for (const HdrRuns runs : {HdrRuns::none, HdrRuns::of_pixels, HdrRuns::of_bytes})
    files.push_back(hdr_file(9, 4, runs, smooth_bytes(9, 4, 4)));
  return files;
}

/// Whether a picture came out, of as many pixels as it says; else a reason has to.
bool read_or_refused(const std::string& file) {
  const Result<ReadImage> read = parse_image(file, "a", 1 << 16);
  if (read) {
    EXPECT_EQ(read->image.pixels.size(), std::size_t{3} * read->image.width * read->image.height);
    return true;
  }
  EXPECT_FALSE(read.error().empty());
  for (const Diagnostic& problem : read.error()) {
    EXPECT_EQ(problem.file, "a");
    EXPECT_FALSE(problem.message.empty());
  }
  return false;
}

TEST(ReadImage, AnswersFilesThatAreCutOffAnywhere) {
  for (const std::string& file : small_files())
    for (std::size_t size = 0; size + 1 < file.size(); size += 1 + size / 40) {
      const std::string cut(file.data(), size);  // with its own end, for sanitizers to watch
      if (!read_or_refused(cut)) continue;
      // Whatever could still be read had all its pixels.
      EXPECT_GT(size, file.size() - 20) << file.substr(0, 8);
    }
}

TEST(ReadImage, AnswersFilesWithWrongBytes) {
  std::mt19937 random(3);
  int read = 0, refused = 0;
  for (const std::string& file : small_files())
    for (int round = 0; round < 60; ++round) {
      std::string wrong = file;
      for (unsigned i = 0; i < 1 + random() % 4; ++i)
        wrong[random() % wrong.size()] = static_cast<char>(random());
      ++(read_or_refused(wrong) ? read : refused);
    }
  EXPECT_GT(read, 100) << "wrong pixels are no wrong file";
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace zraka
